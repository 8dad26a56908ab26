package org.diacaustic.shape;

import java.util.Arrays;
import org.diacaustic.math.Arithmetic;

/**
 * Which triangles of a mesh meet. Vertices in the same place count as one, however often a file lists them to give them
 * different normals or map coordinates.
 */
final class MeshTopology {
    private static final long NO_EDGE = -1;

    private final MeshData data;

    /** For each vertex the first one in its place. */
    private final int[] welded;

    MeshTopology(MeshData data) {
        this.data = data;
        this.welded = weld(data.vertices());
    }

    private static int[] weld(double[] vertices) {
        int count = vertices.length / 3;
        int[] welded = new int[count];
        int[] table = new int[tableSize(count)];
        Arrays.fill(table, -1);
        for (int vertex = 0; vertex < count; vertex++) {
            int slot = hash(placeHash(vertices, 3 * vertex), table.length);
            while (table[slot] >= 0 && !samePlace(vertices, 3 * table[slot], 3 * vertex)) {
                slot = slot + 1 & table.length - 1;
            }
            if (table[slot] < 0) {
                table[slot] = vertex;
            }
            welded[vertex] = table[slot];
        }
        return welded;
    }

    private static long placeHash(double[] vertices, int i) {
        // Adding 0 makes -0 the same place as 0.
        long x = Double.doubleToRawLongBits(vertices[i] + 0.0);
        long y = Double.doubleToRawLongBits(vertices[i + 1] + 0.0);
        long z = Double.doubleToRawLongBits(vertices[i + 2] + 0.0);
        return (x * 31 + y) * 0x9E3779B97F4A7C15L + z;
    }

    private static boolean samePlace(double[] vertices, int i, int j) {
        return vertices[i] == vertices[j] && vertices[i + 1] == vertices[j + 1] && vertices[i + 2] == vertices[j + 2];
    }

    /** Whether every edge belongs to two triangles that run along it in opposite directions, and to no others. */
    boolean isClosed() {
        int[] triangles = data.triangles();
        long[] edges = new long[tableSize(triangles.length)];
        Arrays.fill(edges, NO_EDGE);
        int edgeCount = 0;
        for (int i = 0; i < triangles.length; i += 3) {
            int a = welded[triangles[i]];
            int b = welded[triangles[i + 1]];
            int c = welded[triangles[i + 2]];
            if (a == b || b == c || c == a) {
                continue;
            }
            if (!add(edges, a, b) || !add(edges, b, c) || !add(edges, c, a)) {
                return false;
            }
            edgeCount += 3;
        }
        for (long edge : edges) {
            if (edge != NO_EDGE && !contains(edges, (int) edge, (int) (edge >>> 32))) {
                return false;
            }
        }
        return edgeCount > 0;
    }

    private static boolean add(long[] edges, int from, int to) {
        int slot = slot(edges, from, to);
        if (edges[slot] != NO_EDGE) {
            return false;
        }
        edges[slot] = edge(from, to);
        return true;
    }

    private static boolean contains(long[] edges, int from, int to) {
        return edges[slot(edges, from, to)] != NO_EDGE;
    }

    private static int slot(long[] edges, int from, int to) {
        long edge = edge(from, to);
        int slot = hash(edge, edges.length);
        while (edges[slot] != NO_EDGE && edges[slot] != edge) {
            slot = slot + 1 & edges.length - 1;
        }
        return slot;
    }

    private static long edge(int from, int to) {
        return (long) from << 32 | to;
    }

    /** A power of two at least twice as large as what the table must hold. */
    private static int tableSize(int entries) {
        return Integer.highestOneBit(Math.max(2, entries)) << 2;
    }

    private static int hash(long key, int tableSize) {
        long mixed = (key ^ key >>> 32) * 0x9E3779B97F4A7C15L;
        return (int) (mixed >>> 32) & tableSize - 1;
    }

    /**
     * A normal for each vertex: the sum of the normals of the triangles around it, each weighted by its angle there
     * [Thürmer and Wüthrich 1998]. So cutting a triangle in two changes nothing.
     */
    double[] vertexNormals(MeshSurface facets) {
        double[] vertices = data.vertices();
        int[] triangles = data.triangles();
        double[] normals = new double[vertices.length];
        Hit facet = new Hit();
        for (int i = 0; i < triangles.length; i++) {
            int triangle = i / 3;
            if (!facets.setNormal(triangle, facet)) {
                continue;
            }
            int at = 3 * triangles[i];
            int next = 3 * triangles[3 * triangle + (i + 1) % 3];
            int last = 3 * triangles[3 * triangle + (i + 2) % 3];
            double angle = angle(vertices, at, next, last);
            int sum = 3 * welded[triangles[i]];
            normals[sum] += angle * facet.normalX;
            normals[sum + 1] += angle * facet.normalY;
            normals[sum + 2] += angle * facet.normalZ;
        }
        for (int vertex = 0; vertex < welded.length; vertex++) {
            System.arraycopy(normals, 3 * welded[vertex], normals, 3 * vertex, 3);
        }
        return normals;
    }

    private static double angle(double[] vertices, int at, int next, int last) {
        double ux = vertices[next] - vertices[at];
        double uy = vertices[next + 1] - vertices[at + 1];
        double uz = vertices[next + 2] - vertices[at + 2];
        double vx = vertices[last] - vertices[at];
        double vy = vertices[last + 1] - vertices[at + 1];
        double vz = vertices[last + 2] - vertices[at + 2];
        double sine = Arithmetic.length(uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx);
        return StrictMath.atan2(sine, ux * vx + uy * vy + uz * vz);
    }
}
