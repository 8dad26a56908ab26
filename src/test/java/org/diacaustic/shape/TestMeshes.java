package org.diacaustic.shape;

import java.util.HashMap;
import java.util.Map;
import java.util.SplittableRandom;
import org.diacaustic.math.Vector3;

/** Meshes that tests share. */
final class TestMeshes {
    private TestMeshes() {}

    static TriangleMesh triangle(double... vertices) {
        return new TriangleMesh(new MeshData(vertices, new int[] {0, 1, 2}, null, null), false);
    }

    /**
     * An icosahedron with every triangle cut in four {@code level} times and all vertices at distance
     * radius · (1 + bumpiness · random) from the centre.
     */
    static MeshData icosphere(int level, Vector3 centre, double radius, double bumpiness, long seed) {
        double g = (1 + Math.sqrt(5)) / 2;
        double[] unit = {
            -1, g, 0, 1, g, 0, -1, -g, 0, 1, -g, 0, 0, -1, g, 0, 1, g, 0, -1, -g, 0, 1, -g, g, 0, -1, g, 0, 1, -g, 0,
            -1, -g, 0, 1
        };
        int[] triangles = {
            0, 11, 5, 0, 5, 1, 0, 1, 7, 0, 7, 10, 0, 10, 11, 1, 5, 9, 5, 11, 4, 11, 10, 2, 10, 7, 6, 7, 1, 8, 3, 9, 4,
            3, 4, 2, 3, 2, 6, 3, 6, 8, 3, 8, 9, 4, 9, 5, 2, 4, 11, 6, 2, 10, 8, 6, 7, 9, 8, 1
        };
        java.util.List<Vector3> points = new java.util.ArrayList<>();
        for (int i = 0; i < unit.length; i += 3) {
            points.add(new Vector3(unit[i], unit[i + 1], unit[i + 2]).normalized());
        }
        for (int i = 0; i < level; i++) {
            triangles = divided(points, triangles);
        }
        SplittableRandom random = new SplittableRandom(seed);
        double[] vertices = new double[3 * points.size()];
        for (int i = 0; i < points.size(); i++) {
            Vector3 p = points.get(i)
                    .times(radius * (1 + bumpiness * random.nextDouble()))
                    .plus(centre);
            vertices[3 * i] = p.x();
            vertices[3 * i + 1] = p.y();
            vertices[3 * i + 2] = p.z();
        }
        return new MeshData(vertices, triangles, null, null);
    }

    private static int[] divided(java.util.List<Vector3> points, int[] triangles) {
        Map<Long, Integer> middles = new HashMap<>();
        int[] divided = new int[4 * triangles.length];
        for (int i = 0; i < triangles.length; i += 3) {
            int a = triangles[i];
            int b = triangles[i + 1];
            int c = triangles[i + 2];
            int ab = middle(points, middles, a, b);
            int bc = middle(points, middles, b, c);
            int ca = middle(points, middles, c, a);
            System.arraycopy(new int[] {a, ab, ca, b, bc, ab, c, ca, bc, ab, bc, ca}, 0, divided, 4 * i, 12);
        }
        return divided;
    }

    private static int middle(java.util.List<Vector3> points, Map<Long, Integer> middles, int a, int b) {
        long edge = (long) Math.min(a, b) << 32 | Math.max(a, b);
        return middles.computeIfAbsent(edge, key -> {
            points.add(points.get(a).plus(points.get(b)).normalized());
            return points.size() - 1;
        });
    }

    /** A vertex of a mesh. */
    static Vector3 vertex(MeshData data, int vertex) {
        double[] v = data.vertices();
        return new Vector3(v[3 * vertex], v[3 * vertex + 1], v[3 * vertex + 2]);
    }

    /** The middle of an edge: from corner {@code corner} of a triangle to the next. */
    static Vector3 edgeMiddle(MeshData data, int triangle, int corner) {
        return vertex(data, data.triangles()[3 * triangle + corner])
                .plus(vertex(data, data.triangles()[3 * triangle + (corner + 1) % 3]))
                .times(0.5);
    }
}
