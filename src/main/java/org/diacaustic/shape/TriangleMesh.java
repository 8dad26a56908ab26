package org.diacaustic.shape;

import org.diacaustic.index.BoxHierarchy;
import org.diacaustic.math.Bounds;
import org.diacaustic.math.Ray;

/**
 * A mesh of triangles with a hierarchy of boxes of its own. Its primitives are its triangles, its normal is to the side
 * from which a triangle's vertices run counterclockwise.
 *
 * <p>The test is watertight: a ray that goes through an edge or a vertex shared by triangles never slips between them
 * [Woop, Benthin and Wald 2013]. Triangles without area are never hit.
 */
public final class TriangleMesh implements Shape {
    /** How many errors of its start a ray may need to get off a triangle that it leaves, before nobody asks. */
    private static final double FLATTEST_DEPARTURE = 0x1p24;

    /** Two hits whose distances differ by no more than this part may be one behind the other, or the other way round. */
    private static final double ALIKE = 0x1p-30;

    private final MeshSurface surface;
    private final MeshOrder order;
    private final BoxHierarchy hierarchy;

    /** The corners of all triangles in the order of the hierarchy, nine numbers each. */
    private final double[] corners;

    private final int[] triangleAt;
    private final int triangleCount;
    private final int degenerateCount;
    private final boolean closed;

    /** For each triangle, the smooth piece that it belongs to. */
    private final int[] pieces;

    /**
     * @param smooth whether the shading normal runs smoothly from vertex to vertex: along the normals given or, without
     *     any, along those computed from the triangles around each vertex; otherwise each triangle is a flat facet
     */
    public TriangleMesh(MeshData data, boolean smooth) {
        int n = data.triangleCount();
        int[] solid = new int[n];
        int count = 0;
        MeshSurface facets = new MeshSurface(data, null);
        for (int triangle = 0; triangle < n; triangle++) {
            if (facets.hasArea(triangle)) {
                solid[count++] = triangle;
            }
        }
        this.triangleCount = n;
        this.degenerateCount = n - count;
        this.hierarchy = BoxHierarchy.over(boxes(data, solid, count));
        this.triangleAt = new int[count];
        this.corners = new double[9 * count];
        for (int position = 0; position < count; position++) {
            int triangle = solid[hierarchy.item(position)];
            triangleAt[position] = triangle;
            for (int corner = 0; corner < 3; corner++) {
                int vertex = 3 * data.triangles()[3 * triangle + corner];
                System.arraycopy(data.vertices(), vertex, corners, 9 * position + 3 * corner, 3);
            }
        }
        MeshTopology topology = new MeshTopology(data);
        this.closed = topology.isClosed();
        this.surface = !smooth
                ? facets
                : new MeshSurface(data, data.normals() != null ? data.normals() : topology.vertexNormals(facets));
        this.order = new MeshOrder(data);
        this.pieces = topology.pieces(surface);
    }

    private static double[] boxes(MeshData data, int[] solid, int count) {
        double[] vertices = data.vertices();
        double[] boxes = new double[6 * count];
        for (int i = 0; i < count; i++) {
            int first = 3 * solid[i];
            for (int axis = 0; axis < 3; axis++) {
                double a = vertices[3 * data.triangles()[first] + axis];
                double b = vertices[3 * data.triangles()[first + 1] + axis];
                double c = vertices[3 * data.triangles()[first + 2] + axis];
                boxes[6 * i + axis] = Math.min(a, Math.min(b, c));
                boxes[6 * i + 3 + axis] = Math.max(a, Math.max(b, c));
            }
        }
        return boxes;
    }

    public int triangleCount() {
        return triangleCount;
    }

    /** The number of triangles that have no area, which no ray hits. */
    public int degenerateCount() {
        return degenerateCount;
    }

    @Override
    public Bounds bounds() {
        return hierarchy.bounds();
    }

    @Override
    public boolean isClosed() {
        return closed;
    }

    @Override
    public boolean intersect(Ray ray) {
        return walk(ray, false);
    }

    @Override
    public boolean occludes(Ray ray) {
        return walk(ray, true);
    }

    private boolean walk(Ray ray, boolean anyHit) {
        // The axis along which the ray runs most becomes z of a frame in which it starts at 0 and runs along z alone.
        int kz = longestAxis(ray);
        int kx = kz == 2 ? 0 : kz + 1;
        int ky = kx == 2 ? 0 : kx + 1;
        double originX = axis(kx, ray.originX, ray.originY, ray.originZ);
        double originY = axis(ky, ray.originX, ray.originY, ray.originZ);
        double originZ = axis(kz, ray.originX, ray.originY, ray.originZ);
        double directionZ = axis(kz, ray.directionX, ray.directionY, ray.directionZ);
        double shearX = -axis(kx, ray.directionX, ray.directionY, ray.directionZ) / directionZ;
        double shearY = -axis(ky, ray.directionX, ray.directionY, ray.directionZ) / directionZ;

        double[] corners = this.corners;
        boolean found = false;
        int base = hierarchy.enter(ray);
        for (int leaf = hierarchy.next(ray, base); leaf != BoxHierarchy.DONE; leaf = hierarchy.next(ray, base)) {
            int first = BoxHierarchy.first(leaf);
            int end = BoxHierarchy.end(leaf);
            ray.tests += end - first;
            for (int position = first; position < end; position++) {
                int i = 9 * position;
                double az = corners[i + kz] - originZ;
                double ax = Math.fma(shearX, az, corners[i + kx] - originX);
                double ay = Math.fma(shearY, az, corners[i + ky] - originY);
                double bz = corners[i + 3 + kz] - originZ;
                double bx = Math.fma(shearX, bz, corners[i + 3 + kx] - originX);
                double by = Math.fma(shearY, bz, corners[i + 3 + ky] - originY);
                double cz = corners[i + 6 + kz] - originZ;
                double cx = Math.fma(shearX, cz, corners[i + 6 + kx] - originX);
                double cy = Math.fma(shearY, cz, corners[i + 6 + ky] - originY);
                // No fma here: swapping the ends of an edge must change the sign and nothing else, so that two
                // triangles never disagree about the side on which the ray passes their edge.
                double wa = cx * by - cy * bx;
                double wb = ax * cy - ay * cx;
                double wc = bx * ay - by * ax;
                if ((wa < 0 || wb < 0 || wc < 0) && (wa > 0 || wb > 0 || wc > 0)) {
                    continue;
                }
                double sum = wa + wb + wc;
                if (sum == 0) {
                    continue;
                }
                double t = (wa * az + wb * bz + wc * cz) / (sum * directionZ);
                if (accept(ray, triangleAt[position], t, wb / sum, wc / sum, found)) {
                    found = true;
                    if (anyHit) {
                        hierarchy.leave(ray, base);
                        return true;
                    }
                }
            }
        }
        return found;
    }

    /** The axis along which the ray runs most. */
    static int longestAxis(Ray ray) {
        double sizeX = Math.abs(ray.directionX);
        double sizeY = Math.abs(ray.directionY);
        double sizeZ = Math.abs(ray.directionZ);
        return sizeX > sizeY ? (sizeX > sizeZ ? 0 : 2) : sizeY > sizeZ ? 1 : 2;
    }

    private static double axis(int axis, double x, double y, double z) {
        return axis == 0 ? x : axis == 1 ? y : z;
    }

    /** @param found whether the ray's nearest hit so far is one of this mesh */
    private boolean accept(Ray ray, int triangle, double t, double u, double v, boolean found) {
        double accepted = t;
        if (ray.leaving != Ray.FREE) {
            if (triangle == ray.leaving) {
                return false;
            }
            if (Math.abs(t) <= FLATTEST_DEPARTURE * ray.departureError) {
                accepted = order.afterLeaving(ray, triangle, t);
            }
        }
        boolean nearer = accepted < ray.tMax;
        if (found && Math.abs(accepted - ray.tMax) <= ALIKE * ray.tMax) {
            nearer = order.isBefore(ray, triangle, ray.hitPrimitive, accepted);
            accepted = Math.min(accepted, ray.tMax);
        }
        if (!(nearer && accepted > 0)) {
            return false;
        }
        ray.hit(accepted, triangle);
        ray.hitU = u;
        ray.hitV = v;
        return true;
    }

    @Override
    public void complete(Ray ray, Hit hit) {
        surface.complete(ray, hit);
    }

    @Override
    public int piece(Hit hit) {
        return pieces[hit.primitive];
    }

    @Override
    public void inverseMap(Hit hit) {
        surface.inverseMap(hit);
    }
}
