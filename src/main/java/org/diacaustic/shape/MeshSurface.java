package org.diacaustic.shape;

import org.diacaustic.math.Arithmetic;
import org.diacaustic.math.Ray;

/** The geometry of single triangles of a mesh: points, normals, map coordinates, and which way they face. */
final class MeshSurface {
    /** Weights below which it is asked whether the point is too near to an edge. */
    private static final double EDGE = 0x1p-20;

    /** How many errors of the point it is kept off edges. */
    private static final double OFF_EDGES = 16;

    /** Rays flatter than this to a triangle do not move their points farther off its edges. */
    private static final double FLATTEST = 0x1p-24;

    /** The largest weight that this may take. */
    private static final double MOST_OFF = 0.125;

    private final double[] vertices;
    private final int[] triangles;
    private final double[] maps;

    /** x, y, z of the shading normal at each vertex, of any length; null for flat facets. */
    private final double[] vertexNormals;

    MeshSurface(MeshData data, double[] vertexNormals) {
        this.vertices = data.vertices();
        this.triangles = data.triangles();
        this.maps = data.maps();
        this.vertexNormals = vertexNormals;
    }

    /** Whether a triangle has a normal. */
    boolean hasArea(int triangle) {
        return setNormal(triangle, new Hit());
    }

    /**
     * Sets the unit normal, geometric and for shading, to the side from which the corners run counterclockwise.
     *
     * @return false, with nothing set, if the triangle has no area
     */
    boolean setNormal(int triangle, Hit hit) {
        int a = corner(triangle, 0);
        int b = corner(triangle, 1);
        int c = corner(triangle, 2);
        double ux = vertices[b] - vertices[a];
        double uy = vertices[b + 1] - vertices[a + 1];
        double uz = vertices[b + 2] - vertices[a + 2];
        double vx = vertices[c] - vertices[a];
        double vy = vertices[c + 1] - vertices[a + 1];
        double vz = vertices[c + 2] - vertices[a + 2];
        // Dividing by powers of two keeps the products of very short and very long edges in range.
        double u = scaleOf(ux, uy, uz);
        double v = scaleOf(vx, vy, vz);
        double nx = Arithmetic.differenceOfProducts(uy / u, vz / v, uz / u, vy / v);
        double ny = Arithmetic.differenceOfProducts(uz / u, vx / v, ux / u, vz / v);
        double nz = Arithmetic.differenceOfProducts(ux / u, vy / v, uy / u, vx / v);
        double length = Arithmetic.length(nx, ny, nz);
        if (!(length > 0)) {
            return false;
        }
        hit.setNormal(nx / length, ny / length, nz / length);
        return true;
    }

    private static double scaleOf(double x, double y, double z) {
        return Arithmetic.powerOfTwoNear(Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z))));
    }

    /** Completes a hit whose notes are the weights of the second and the third corner. */
    void complete(Ray ray, Hit hit) {
        int a = corner(hit.primitive, 0);
        int b = corner(hit.primitive, 1);
        int c = corner(hit.primitive, 2);
        setNormal(hit.primitive, hit);
        setPoint(a, b, c, hit.noteU, hit.noteV, hit);
        if (hit.noteU < EDGE || hit.noteV < EDGE || 1 - hit.noteU - hit.noteV < EDGE) {
            keepOffEdges(a, b, c, ray, hit);
        }
        if (vertexNormals != null) {
            setShadingNormal(a, b, c, hit);
        }
    }

    private void setPoint(int a, int b, int c, double u, double v, Hit hit) {
        double errorX = error(vertices[a], vertices[b], vertices[c], u, v);
        double errorY = error(vertices[a + 1], vertices[b + 1], vertices[c + 1], u, v);
        double errorZ = error(vertices[a + 2], vertices[b + 2], vertices[c + 2], u, v);
        hit.setPoint(
                between(vertices[a], vertices[b], vertices[c], u, v),
                between(vertices[a + 1], vertices[b + 1], vertices[c + 1], u, v),
                between(vertices[a + 2], vertices[b + 2], vertices[c + 2], u, v),
                Arithmetic.length(errorX, errorY, errorZ));
    }

    /**
     * Moves a point that rounding may have put beyond an edge of its triangle off that edge, seen along the ray by more than
     * rounding: so a ray that leaves it passes the edge on the side on which it met the triangle, and meets of the triangles
     * around what such a ray meets.
     */
    private void keepOffEdges(int a, int b, int c, Ray ray, Hit hit) {
        double ab = distance(a, b);
        double bc = distance(b, c);
        double ca = distance(c, a);
        double along = ray.directionX * hit.normalX + ray.directionY * hit.normalY + ray.directionZ * hit.normalZ;
        double cosine = Math.abs(along) / Arithmetic.length(ray.directionX, ray.directionY, ray.directionZ);
        double off = OFF_EDGES * hit.pointError / (Math.max(cosine, FLATTEST) * doubleArea(a, b, c));
        double leastU = Math.min(off * ca, MOST_OFF);
        double leastV = Math.min(off * ab, MOST_OFF);
        double leastW = Math.min(off * bc, MOST_OFF);
        double u = Math.max(hit.noteU, leastU);
        double v = Math.max(hit.noteV, leastV);
        double w = Math.max(1 - hit.noteU - hit.noteV, leastW);
        double sum = u + v + w;
        setPoint(a, b, c, u / sum, v / sum, hit);
    }

    private double distance(int a, int b) {
        return Arithmetic.length(
                vertices[b] - vertices[a], vertices[b + 1] - vertices[a + 1], vertices[b + 2] - vertices[a + 2]);
    }

    private double doubleArea(int a, int b, int c) {
        double ux = vertices[b] - vertices[a];
        double uy = vertices[b + 1] - vertices[a + 1];
        double uz = vertices[b + 2] - vertices[a + 2];
        double vx = vertices[c] - vertices[a];
        double vy = vertices[c + 1] - vertices[a + 1];
        double vz = vertices[c + 2] - vertices[a + 2];
        return Arithmetic.length(
                Arithmetic.differenceOfProducts(uy, vz, uz, vy),
                Arithmetic.differenceOfProducts(uz, vx, ux, vz),
                Arithmetic.differenceOfProducts(ux, vy, uy, vx));
    }

    /**
     * Sets the normals of a triangle at one of its corners, numbered as in the list of triangles.
     *
     * @return false, with nothing set, if the triangle has no area
     */
    boolean setNormalAt(int cornerNumber, Hit hit) {
        int triangle = cornerNumber / 3;
        if (!setNormal(triangle, hit)) {
            return false;
        }
        if (vertexNormals != null) {
            int place = cornerNumber % 3;
            hit.noteU = place == 1 ? 1 : 0;
            hit.noteV = place == 2 ? 1 : 0;
            setShadingNormal(corner(triangle, 0), corner(triangle, 1), corner(triangle, 2), hit);
        }
        return true;
    }

    private void setShadingNormal(int a, int b, int c, Hit hit) {
        double u = hit.noteU;
        double v = hit.noteV;
        double w = 1 - u - v;
        double x = w * vertexNormals[a] + u * vertexNormals[b] + v * vertexNormals[c];
        double y = w * vertexNormals[a + 1] + u * vertexNormals[b + 1] + v * vertexNormals[c + 1];
        double z = w * vertexNormals[a + 2] + u * vertexNormals[b + 2] + v * vertexNormals[c + 2];
        double length = Arithmetic.length(x, y, z);
        if (!(length > 0 && length < Double.POSITIVE_INFINITY)) {
            return;
        }
        boolean inward = x * hit.normalX + y * hit.normalY + z * hit.normalZ < 0;
        double scale = inward ? -length : length;
        hit.shadingX = x / scale;
        hit.shadingY = y / scale;
        hit.shadingZ = z / scale;
    }

    private static double between(double a, double b, double c, double u, double v) {
        return Math.fma(v, c - a, Math.fma(u, b - a, a));
    }

    /** Bounds the rounding of {@link #between}: two edges, two sums, and weights that add up to 1 within rounding. */
    private static double error(double a, double b, double c, double u, double v) {
        return Arithmetic.gamma(5) * (Math.abs(a) + Math.abs(u * (b - a)) + Math.abs(v * (c - a)));
    }

    /** Sets the interpolated map coordinates, or the weights of the second and third corner where there are none. */
    void inverseMap(Hit hit) {
        int a = corner(hit.primitive, 0);
        int b = corner(hit.primitive, 1);
        int c = corner(hit.primitive, 2);
        double ux = vertices[b] - vertices[a];
        double uy = vertices[b + 1] - vertices[a + 1];
        double uz = vertices[b + 2] - vertices[a + 2];
        double vx = vertices[c] - vertices[a];
        double vy = vertices[c + 1] - vertices[a + 1];
        double vz = vertices[c + 2] - vertices[a + 2];
        if (maps == null) {
            hit.setMap(Arithmetic.clamp(hit.noteU, 0, 1), Arithmetic.clamp(hit.noteV, 0, 1));
            hit.setTangents(ux, uy, uz, vx, vy, vz);
            return;
        }
        int ma = a / 3 * 2;
        int mb = b / 3 * 2;
        int mc = c / 3 * 2;
        hit.setMap(
                wrapped(between(maps[ma], maps[mb], maps[mc], hit.noteU, hit.noteV)),
                wrapped(between(maps[ma + 1], maps[mb + 1], maps[mc + 1], hit.noteU, hit.noteV)));
        // The edges are known in space and on the map: solving for ∂p/∂u and ∂p/∂v.
        double ub = maps[mb] - maps[ma];
        double vb = maps[mb + 1] - maps[ma + 1];
        double uc = maps[mc] - maps[ma];
        double vc = maps[mc + 1] - maps[ma + 1];
        double determinant = Arithmetic.differenceOfProducts(ub, vc, vb, uc);
        if (determinant == 0) {
            hit.setTangents(0, 0, 0, 0, 0, 0);
            return;
        }
        hit.setTangents(
                (vc * ux - vb * vx) / determinant,
                (vc * uy - vb * vy) / determinant,
                (vc * uz - vb * vz) / determinant,
                (ub * vx - uc * ux) / determinant,
                (ub * vy - uc * uy) / determinant,
                (ub * vz - uc * uz) / determinant);
    }

    /** A coordinate of a map that repeats, in 0..1. */
    private static double wrapped(double coordinate) {
        return coordinate >= 0 && coordinate <= 1 ? coordinate : coordinate - Math.floor(coordinate);
    }

    /** Where the vertex at a corner of a triangle begins among the vertices. */
    private int corner(int triangle, int corner) {
        return 3 * triangles[3 * triangle + corner];
    }
}
