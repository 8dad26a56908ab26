package org.diacaustic.shape;

import org.diacaustic.index.BoxHierarchy;
import org.diacaustic.math.Bounds;
import org.diacaustic.math.Ray;

/**
 * A mesh whose triangles are met by Möller and Trumbore's test and a smallest distance, as one writes it first; all but the test
 * is {@link TriangleMesh}'s, the hierarchy and the order of the corners in memory included.
 */
public final class TextbookMesh implements Shape {
    private static final double SMALLEST = 1e-6;

    private final TriangleMesh mesh;
    private final BoxHierarchy hierarchy;
    private final double[] corners;

    public TextbookMesh(MeshData data, TriangleMesh mesh) {
        this.mesh = mesh;
        int n = data.triangleCount();
        double[] boxes = new double[6 * n];
        for (int i = 0; i < n; i++) {
            for (int axis = 0; axis < 3; axis++) {
                double a = vertex(data, 3 * i, axis);
                double b = vertex(data, 3 * i + 1, axis);
                double c = vertex(data, 3 * i + 2, axis);
                boxes[6 * i + axis] = Math.min(a, Math.min(b, c));
                boxes[6 * i + 3 + axis] = Math.max(a, Math.max(b, c));
            }
        }
        hierarchy = BoxHierarchy.over(boxes);
        corners = new double[9 * n];
        for (int position = 0; position < n; position++) {
            for (int k = 0; k < 9; k++) {
                corners[9 * position + k] = vertex(data, 3 * hierarchy.item(position) + k / 3, k % 3);
            }
        }
    }

    private static double vertex(MeshData data, int corner, int axis) {
        return data.vertices()[3 * data.triangles()[corner] + axis];
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
        boolean found = false;
        int base = hierarchy.enter(ray);
        for (int leaf = hierarchy.next(ray, base); leaf != BoxHierarchy.DONE; leaf = hierarchy.next(ray, base)) {
            int end = BoxHierarchy.end(leaf);
            ray.tests += end - BoxHierarchy.first(leaf);
            for (int position = BoxHierarchy.first(leaf); position < end; position++) {
                if (meet(ray, position)) {
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

    private boolean meet(Ray ray, int position) {
        double[] p = corners;
        int i = 9 * position;
        double e1x = p[i + 3] - p[i];
        double e1y = p[i + 4] - p[i + 1];
        double e1z = p[i + 5] - p[i + 2];
        double e2x = p[i + 6] - p[i];
        double e2y = p[i + 7] - p[i + 1];
        double e2z = p[i + 8] - p[i + 2];
        double dx = ray.directionX;
        double dy = ray.directionY;
        double dz = ray.directionZ;
        double px = dy * e2z - dz * e2y;
        double py = dz * e2x - dx * e2z;
        double pz = dx * e2y - dy * e2x;
        double determinant = e1x * px + e1y * py + e1z * pz;
        if (determinant == 0) {
            return false;
        }
        double inverse = 1 / determinant;
        double sx = ray.originX - p[i];
        double sy = ray.originY - p[i + 1];
        double sz = ray.originZ - p[i + 2];
        double u = (sx * px + sy * py + sz * pz) * inverse;
        if (u < 0 || u > 1) {
            return false;
        }
        double qx = sy * e1z - sz * e1y;
        double qy = sz * e1x - sx * e1z;
        double qz = sx * e1y - sy * e1x;
        double v = (dx * qx + dy * qy + dz * qz) * inverse;
        if (v < 0 || u + v > 1) {
            return false;
        }
        double t = (e2x * qx + e2y * qy + e2z * qz) * inverse;
        if (t < SMALLEST || t >= ray.tMax) {
            return false;
        }
        ray.hit(t, hierarchy.item(position));
        ray.hitU = u;
        ray.hitV = v;
        return true;
    }

    @Override
    public Bounds bounds() {
        return mesh.bounds();
    }

    @Override
    public void complete(Ray ray, Hit hit) {
        mesh.complete(ray, hit);
    }

    @Override
    public void inverseMap(Hit hit) {
        mesh.inverseMap(hit);
    }

    @Override
    public int piece(Hit hit) {
        return mesh.piece(hit);
    }

    @Override
    public boolean isClosed() {
        return mesh.isClosed();
    }
}
