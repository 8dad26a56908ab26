package org.diacaustic.trial;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.diacaustic.math.SampleStream;
import org.diacaustic.math.Vector3;
import org.diacaustic.shape.MeshData;

/** An icosahedron whose triangles are cut in four again and again, with a rough surface; vertices are shared. */
final class Icosphere {
    /** The two numbers of each edge, smaller first, as one. */
    private final Map<Long, Integer> middles = new HashMap<>();

    private final List<Vector3> vertices = new ArrayList<>();
    private List<int[]> triangles = new ArrayList<>();

    /** @param subdivision how often triangles are cut */
    Icosphere(int subdivision) {
        double golden = (1 + Math.sqrt(5)) / 2;
        for (int i = 0; i < 12; i++) {
            double one = (i & 1) == 0 ? 1 : -1;
            double other = (i & 2) == 0 ? golden : -golden;
            vertices.add((i < 4
                            ? new Vector3(one, other, 0)
                            : i < 8 ? new Vector3(0, one, other) : new Vector3(other, 0, one))
                    .normalized());
        }
        for (int a = 0; a < 12; a++) {
            for (int b = a + 1; b < 12; b++) {
                for (int c = b + 1; c < 12; c++) {
                    if (areNeighbours(a, b) && areNeighbours(b, c) && areNeighbours(a, c)) {
                        boolean outward = vertices.get(a).cross(vertices.get(b)).dot(vertices.get(c)) > 0;
                        triangles.add(outward ? new int[] {a, b, c} : new int[] {a, c, b});
                    }
                }
            }
        }
        for (int i = 0; i < subdivision; i++) {
            subdivide();
        }
    }

    private boolean areNeighbours(int a, int b) {
        return vertices.get(a).dot(vertices.get(b)) > 0.4;
    }

    private void subdivide() {
        List<int[]> smaller = new ArrayList<>();
        for (int[] t : triangles) {
            int ab = middle(t[0], t[1]);
            int bc = middle(t[1], t[2]);
            int ca = middle(t[2], t[0]);
            smaller.add(new int[] {t[0], ab, ca});
            smaller.add(new int[] {ab, t[1], bc});
            smaller.add(new int[] {ca, bc, t[2]});
            smaller.add(new int[] {ab, bc, ca});
        }
        triangles = smaller;
        middles.clear();
    }

    private int middle(int a, int b) {
        long edge = (long) Math.min(a, b) << 32 | Math.max(a, b);
        return middles.computeIfAbsent(edge, key -> {
            vertices.add(vertices.get(a).plus(vertices.get(b)).normalized());
            return vertices.size() - 1;
        });
    }

    int triangleCount() {
        return triangles.size();
    }

    int vertexCount() {
        return vertices.size();
    }

    /** Vertices − edges + triangles: 2 if it is closed and has no handle. */
    int eulerCharacteristic() {
        Set<Long> edges = new HashSet<>();
        for (int[] t : triangles) {
            for (int i = 0; i < 3; i++) {
                edges.add((long) Math.min(t[i], t[(i + 1) % 3]) << 32 | Math.max(t[i], t[(i + 1) % 3]));
            }
        }
        return vertices.size() - edges.size() + triangles.size();
    }

    /**
     * Its numbers.
     *
     * @param roughness the distance of each vertex from the centre is radius · (1 + roughness · a random number in 0..1)
     */
    MeshData data(Vector3 centre, double radius, double roughness, SampleStream random) {
        double[] numbers = new double[3 * vertices.size()];
        for (int i = 0; i < vertices.size(); i++) {
            Vector3 vertex = centre.plus(vertices.get(i).times(radius * (1 + roughness * random.nextDouble())));
            numbers[3 * i] = vertex.x();
            numbers[3 * i + 1] = vertex.y();
            numbers[3 * i + 2] = vertex.z();
        }
        int[] corners = triangles.stream().flatMapToInt(Arrays::stream).toArray();
        return new MeshData(numbers, corners, null, null);
    }
}
