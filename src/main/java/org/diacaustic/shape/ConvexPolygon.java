package org.diacaustic.shape;

import org.diacaustic.math.Arithmetic;
import org.diacaustic.math.Bounds;
import org.diacaustic.math.Ray;
import org.diacaustic.math.Vector3;

/**
 * A flat convex polygon, visible from both sides or, one-sided, only from where its normal points. The normal follows
 * the vertices by the right hand.
 *
 * <p>Which side of an edge a ray passes is decided as by [Woop, Benthin and Wald 2013], from the edge's vertices
 * and the ray alone and with the exact sign: polygons that share an edge leave no gap, and a ray through the edge itself
 * hits both.
 *
 * <p>The map of four vertices runs from vertex 0 at (0, 0) over vertex 1 at (1, 0) and vertex 2 at (1, 1) to vertex 3 at
 * (0, 1) [Thesis 2.4; Haines 1991]. That of any other number is the smallest rectangle along edge 0 that holds the
 * polygon.
 */
public final class ConvexPolygon implements Shape {
    private final double[] x;
    private final double[] y;
    private final double[] z;
    private final Vector3 point;
    private final Vector3 normal;
    private final boolean twoSided;
    private final Bounds bounds;
    private final QuadrilateralMapping quadrilateral;
    private final PlanarMapping rectangle;

    /** @param vertices at least three, in order around the polygon, in scene units */
    private ConvexPolygon(Vector3[] vertices, boolean twoSided) {
        PolygonCheck check = new PolygonCheck(vertices);
        this.normal = check.normal();
        this.point = vertices[0];
        this.twoSided = twoSided;
        this.x = new double[vertices.length];
        this.y = new double[vertices.length];
        this.z = new double[vertices.length];
        for (int i = 0; i < vertices.length; i++) {
            x[i] = vertices[i].x();
            y[i] = vertices[i].y();
            z[i] = vertices[i].z();
        }
        Bounds exact = Bounds.of(vertices);
        // Points are brought down to the plane, from which the vertices differ by their own rounding.
        double slack = check.deviation()
                + Arithmetic.gamma(16)
                        * Math.max(
                                Math.max(Math.abs(exact.minX()), Math.abs(exact.maxX())),
                                Math.max(
                                        Math.max(Math.abs(exact.minY()), Math.abs(exact.maxY())),
                                        Math.max(Math.abs(exact.minZ()), Math.abs(exact.maxZ()))));
        this.bounds = new Bounds(
                exact.minX() - slack,
                exact.minY() - slack,
                exact.minZ() - slack,
                exact.maxX() + slack,
                exact.maxY() + slack,
                exact.maxZ() + slack);
        this.quadrilateral = vertices.length == 4 ? new QuadrilateralMapping(vertices, normal) : null;
        this.rectangle = vertices.length == 4 ? null : rectangleAlongFirstEdge(vertices, normal);
    }

    /**
     * A polygon that is seen from both sides.
     *
     * @param vertices at least three, in order, in scene units
     * @throws IllegalArgumentException if they are not flat within rounding, not convex, or have no area
     */
    public static ConvexPolygon twoSided(Vector3... vertices) {
        return new ConvexPolygon(vertices, true);
    }

    /** A polygon that rays from behind pass unhindered; otherwise as {@link #twoSided}. */
    public static ConvexPolygon oneSided(Vector3... vertices) {
        return new ConvexPolygon(vertices, false);
    }

    private static PlanarMapping rectangleAlongFirstEdge(Vector3[] vertices, Vector3 normal) {
        Vector3 u = vertices[1].minus(vertices[0]).normalized();
        Vector3 v = normal.cross(u);
        double low = 0;
        double high = 0;
        double width = 0;
        for (Vector3 vertex : vertices) {
            Vector3 offset = vertex.minus(vertices[0]);
            low = Math.min(low, offset.dot(u));
            high = Math.max(high, offset.dot(u));
            width = Math.max(width, offset.dot(v));
        }
        return new PlanarMapping(vertices[0].plus(u.times(low)), u.times(high - low), v.times(width));
    }

    public int vertexCount() {
        return x.length;
    }

    public Vector3 vertex(int index) {
        return new Vector3(x[index], y[index], z[index]);
    }

    /** The outward normal, of length 1. */
    public Vector3 normal() {
        return normal;
    }

    public boolean isTwoSided() {
        return twoSided;
    }

    @Override
    public Bounds bounds() {
        return bounds;
    }

    @Override
    public boolean intersect(Ray ray) {
        ray.tests++;
        if (ray.leaving != Ray.FREE) {
            return false;
        }
        if (!twoSided && !(FlatSurface.approach(ray, normal) < 0)) {
            return false;
        }
        double t = FlatSurface.distance(ray, point, normal);
        if (!(t > 0 && t < ray.tMax) || !surrounds(ray)) {
            return false;
        }
        ray.hit(t, 0);
        return true;
    }

    /** Whether the line of the ray passes all edges on the same side, or through them. */
    private boolean surrounds(Ray ray) {
        double dx = Math.abs(ray.directionX);
        double dy = Math.abs(ray.directionY);
        double dz = Math.abs(ray.directionZ);
        if (dz >= dx && dz >= dy) {
            return surrounds(
                    x, y, z, ray.originX, ray.originY, ray.originZ, ray.directionX, ray.directionY, ray.directionZ);
        }
        if (dx >= dy) {
            return surrounds(
                    y, z, x, ray.originY, ray.originZ, ray.originX, ray.directionY, ray.directionZ, ray.directionX);
        }
        return surrounds(
                z, x, y, ray.originZ, ray.originX, ray.originY, ray.directionZ, ray.directionX, ray.directionY);
    }

    /** The third direction is the longest: a shear along it turns the ray into the axis through (0, 0). */
    private static boolean surrounds(
            double[] first,
            double[] second,
            double[] third,
            double originFirst,
            double originSecond,
            double originThird,
            double directionFirst,
            double directionSecond,
            double directionThird) {
        double shearFirst = directionFirst / directionThird;
        double shearSecond = directionSecond / directionThird;
        int last = first.length - 1;
        double depth = third[last] - originThird;
        double fromFirst = Math.fma(-shearFirst, depth, first[last] - originFirst);
        double fromSecond = Math.fma(-shearSecond, depth, second[last] - originSecond);
        boolean left = false;
        boolean right = false;
        for (int i = 0; i <= last; i++) {
            depth = third[i] - originThird;
            double toFirst = Math.fma(-shearFirst, depth, first[i] - originFirst);
            double toSecond = Math.fma(-shearSecond, depth, second[i] - originSecond);
            double side = Arithmetic.differenceOfProducts(fromFirst, toSecond, fromSecond, toFirst);
            left |= side > 0;
            right |= side < 0;
            if (left && right) {
                return false;
            }
            fromFirst = toFirst;
            fromSecond = toSecond;
        }
        return left || right;
    }

    @Override
    public void complete(Ray ray, Hit hit) {
        FlatSurface.complete(ray, hit, point, normal);
    }

    @Override
    public void inverseMap(Hit hit) {
        if (quadrilateral != null) {
            quadrilateral.map(hit);
        } else {
            rectangle.mapWithin(hit);
        }
    }

    @Override
    public boolean isClosed() {
        return false;
    }
}
