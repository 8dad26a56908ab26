package org.diacaustic.shape;

import java.util.Arrays;
import org.diacaustic.math.Arithmetic;

/**
 * Which triangles of a mesh meet. Vertices in the same place count as one, however often a file lists them to give them
 * different normals or map coordinates.
 */
final class MeshTopology {
    private static final long NO_EDGE = -1;

    /** The cosine of half a degree. */
    private static final double ALIKE_COSINE = 0.99996;

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

    /**
     * For each triangle the number of the piece it belongs to: triangles that meet along an edge are of one piece if their
     * normals to shade with, at both ends of the edge, are the same but for half a degree. A piece has the number of its
     * first triangle.
     */
    int[] pieces(MeshSurface surface) {
        int count = data.triangleCount();
        int[] parent = new int[count];
        Arrays.setAll(parent, i -> i);
        int[] triangles = data.triangles();
        int[] table = new int[tableSize(triangles.length)];
        Arrays.fill(table, -1);
        Hit one = new Hit();
        Hit other = new Hit();
        for (int edge = 0; edge < triangles.length; edge++) {
            long key = undirected(edge);
            int slot = hash(key, table.length);
            while (table[slot] >= 0 && undirected(table[slot]) != key) {
                slot = slot + 1 & table.length - 1;
            }
            if (table[slot] < 0) {
                table[slot] = edge;
            } else if (isSmooth(surface, table[slot], edge, one, other)) {
                join(parent, table[slot] / 3, edge / 3);
            }
        }
        for (int triangle = 0; triangle < count; triangle++) {
            parent[triangle] = root(parent, triangle);
        }
        return parent;
    }

    /** The edge from a corner of a triangle to the next corner, numbered as the corner is in the list of triangles. */
    private long undirected(int edge) {
        int from = welded[data.triangles()[edge]];
        int to = welded[data.triangles()[next(edge)]];
        return edge(Math.min(from, to), Math.max(from, to));
    }

    private static int next(int edge) {
        return edge % 3 == 2 ? edge - 2 : edge + 1;
    }

    /** Whether the shading does not jump where two triangles meet along an edge. */
    private boolean isSmooth(MeshSurface surface, int edge, int twin, Hit one, Hit other) {
        boolean isTurned = welded[data.triangles()[edge]] != welded[data.triangles()[twin]];
        return isAlike(surface, edge, isTurned ? next(twin) : twin, one, other)
                && isAlike(surface, next(edge), isTurned ? twin : next(twin), one, other);
    }

    private static boolean isAlike(MeshSurface surface, int corner, int twin, Hit one, Hit other) {
        return surface.setNormalAt(corner, one)
                && surface.setNormalAt(twin, other)
                && one.shadingX * other.shadingX + one.shadingY * other.shadingY + one.shadingZ * other.shadingZ
                        > ALIKE_COSINE;
    }

    private static void join(int[] parent, int a, int b) {
        int rootA = root(parent, a);
        int rootB = root(parent, b);
        parent[Math.max(rootA, rootB)] = Math.min(rootA, rootB);
    }

    private static int root(int[] parent, int start) {
        int i = start;
        while (parent[i] != i) {
            parent[i] = parent[parent[i]];
            i = parent[i];
        }
        return i;
    }
}
