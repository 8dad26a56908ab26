package org.diacaustic.shape;

import org.diacaustic.math.Arithmetic;
import org.diacaustic.math.Ray;

/**
 * Which of several triangles around an edge or a corner a ray meets first, where they are so near to each other, or to the
 * start of the ray, that distances along it do not tell.
 */
final class MeshOrder {
    /** Errors of the start within which a triangle with a corner of the one that the ray leaves may be met there. */
    private static final double ERRORS = 4;

    private final double[] vertices;
    private final int[] triangles;

    MeshOrder(MeshData data) {
        this.vertices = data.vertices();
        this.triangles = data.triangles();
    }

    /**
     * Where a ray that leaves {@code ray.leaving} meets another triangle near its start. It has just gone through the
     * surface one way, or turned away from it, so the next time it meets the surface it meets the side it came out on: what
     * it seems to meet from the other side is the edge it starts beside, or the same triangle in the file once more,
     * turned round. A neighbour that rises where the ray goes is met, though rounding may have set the start beyond it; one that
     * falls away is not.
     *
     * @param t where it seems to meet it
     * @return not a number if it does not
     */
    double afterLeaving(Ray ray, int triangle, double t) {
        int left = ray.leaving;
        int shared = sharedCorners(triangle, left);
        double approach = approach(ray, triangle);
        if (Math.abs(t) > ray.departureError && (shared == 0 || !isWithinErrors(ray, triangle, t * approach))) {
            return t;
        }
        double departure = approach(ray, left);
        if (approach * departure > 0 || shared == 3) {
            return Double.NaN;
        }
        if (shared > 0 && rises(triangle, left, departure) && rises(left, triangle, -approach)) {
            return Math.max(t, Double.MIN_VALUE);
        }
        return shared == 2 ? Double.NaN : t;
    }

    private boolean isWithinErrors(Ray ray, int triangle, double height) {
        double speed = Arithmetic.length(ray.directionX, ray.directionY, ray.directionZ);
        double area =
                Arithmetic.length(product(triangle, 1, 0, 0), product(triangle, 0, 1, 0), product(triangle, 0, 0, 1));
        return Math.abs(height) <= ERRORS * ray.departureError * speed * area;
    }

    /**
     * Whether a ray goes through a triangle before it goes through another, at about the same distance. If they share an edge,
     * they lie to each other as one before the other. If they share a corner only, distances are compared from there on,
     * where those digits are by which it was decided on which side the ray passes its edges.
     *
     * @param t where the ray meets the triangle; it meets the other at {@code ray.tMax}
     */
    boolean isBefore(Ray ray, int triangle, int other, double t) {
        int vertex = sharedCorner(triangle, other);
        if (vertex < 0) {
            return t < ray.tMax;
        }
        double through = approach(ray, triangle);
        double throughOther = approach(ray, other);
        if (through * throughOther < 0) {
            if (rises(triangle, other, -throughOther) && rises(other, triangle, through)) {
                return true;
            }
            if (rises(triangle, other, throughOther) && rises(other, triangle, -through)) {
                return false;
            }
        }
        double behind = behind(ray, triangle, vertex);
        double otherBehind = behind(ray, other, vertex);
        return behind == otherBehind ? t < ray.tMax : behind < otherBehind;
    }

    /** How far behind one of its corners, along the longest axis of its direction, a ray goes through a triangle. */
    private double behind(Ray ray, int triangle, int vertex) {
        int z = TriangleMesh.longestAxis(ray);
        int x = z == 2 ? 0 : z + 1;
        int y = x == 2 ? 0 : x + 1;
        double forward = direction(ray, z);
        double shearX = -direction(ray, x) / forward;
        double shearY = -direction(ray, y) / forward;
        double sum = 0;
        double weighted = 0;
        for (int i = 0; i < 3; i++) {
            int b = corner(triangle, (i + 1) % 3);
            int c = corner(triangle, (i + 2) % 3);
            double bz = vertices[b + z] - origin(ray, z);
            double cz = vertices[c + z] - origin(ray, z);
            double bx = Math.fma(shearX, bz, vertices[b + x] - origin(ray, x));
            double by = Math.fma(shearY, bz, vertices[b + y] - origin(ray, y));
            double cx = Math.fma(shearX, cz, vertices[c + x] - origin(ray, x));
            double cy = Math.fma(shearY, cz, vertices[c + y] - origin(ray, y));
            double weight = cx * by - cy * bx;
            sum += weight;
            weighted += weight * (vertices[corner(triangle, i) + z] - vertices[vertex + z]);
        }
        return weighted / sum * Math.signum(forward);
    }

    private static double direction(Ray ray, int axis) {
        return axis == 0 ? ray.directionX : axis == 1 ? ray.directionY : ray.directionZ;
    }

    private static double origin(Ray ray, int axis) {
        return axis == 0 ? ray.originX : axis == 1 ? ray.originY : ray.originZ;
    }

    /** Whether all corners of a triangle that it does not share with another lie over that, or under it: as the sign says. */
    private boolean rises(int triangle, int other, double sign) {
        int foot = corner(other, 0);
        for (int i = 0; i < 3; i++) {
            int a = corner(triangle, i);
            double height = product(
                    other,
                    vertices[a] - vertices[foot],
                    vertices[a + 1] - vertices[foot + 1],
                    vertices[a + 2] - vertices[foot + 2]);
            if (!isCorner(a, other) && !(sign * height > 0)) {
                return false;
            }
        }
        return true;
    }

    /** Positive if the ray runs with the normal of the triangle, negative if against it. */
    private double approach(Ray ray, int triangle) {
        return product(triangle, ray.directionX, ray.directionY, ray.directionZ);
    }

    /** The product of a vector and the triangle's normal, which is twice as long as the area is large. */
    private double product(int triangle, double x, double y, double z) {
        int a = corner(triangle, 0);
        int b = corner(triangle, 1);
        int c = corner(triangle, 2);
        double ux = vertices[b] - vertices[a];
        double uy = vertices[b + 1] - vertices[a + 1];
        double uz = vertices[b + 2] - vertices[a + 2];
        double vx = vertices[c] - vertices[a];
        double vy = vertices[c + 1] - vertices[a + 1];
        double vz = vertices[c + 2] - vertices[a + 2];
        return x * Arithmetic.differenceOfProducts(uy, vz, uz, vy)
                + y * Arithmetic.differenceOfProducts(uz, vx, ux, vz)
                + z * Arithmetic.differenceOfProducts(ux, vy, uy, vx);
    }

    /** How many corners of a triangle lie where another has one: 3 for one that is there twice. */
    private int sharedCorners(int triangle, int other) {
        int shared = 0;
        for (int i = 0; i < 3; i++) {
            shared += isCorner(corner(triangle, i), other) ? 1 : 0;
        }
        return shared;
    }

    /** A corner of a triangle that lies where the other has one; negative if there is none. */
    private int sharedCorner(int triangle, int other) {
        for (int i = 0; i < 3; i++) {
            if (isCorner(corner(triangle, i), other)) {
                return corner(triangle, i);
            }
        }
        return -1;
    }

    private boolean isCorner(int a, int triangle) {
        for (int j = 0; j < 3; j++) {
            int b = corner(triangle, j);
            if (vertices[a] == vertices[b]
                    && vertices[a + 1] == vertices[b + 1]
                    && vertices[a + 2] == vertices[b + 2]) {
                return true;
            }
        }
        return false;
    }

    /** Where the vertex at a corner of a triangle begins among the vertices. */
    private int corner(int triangle, int corner) {
        return 3 * triangles[3 * triangle + corner];
    }
}
