package org.diacaustic.shape;

/**
 * The numbers of a triangle mesh. The arrays are not copied: whoever makes one leaves them alone from then on.
 *
 * @param vertices x, y, z of each vertex, in scene units
 * @param triangles three vertex numbers of each triangle, counterclockwise seen from outside
 * @param normals x, y, z of the normal at each vertex, of any length, or null
 * @param maps u, v of each vertex, or null
 */
public record MeshData(double[] vertices, int[] triangles, double[] normals, double[] maps) {

    /** @throws IllegalArgumentException if the lengths do not fit, an index is out of range or a number not finite */
    public MeshData {
        requireLength("vertices", vertices.length, 3, vertices.length / 3);
        requireLength("triangles", triangles.length, 3, triangles.length / 3);
        requireFinite("vertices", vertices, 3);
        int count = vertices.length / 3;
        for (int i = 0; i < triangles.length; i++) {
            if (triangles[i] < 0 || triangles[i] >= count) {
                throw new IllegalArgumentException("triangle " + i / 3 + " names vertex " + triangles[i]
                        + ", but there are " + count + " vertices, numbered from 0");
            }
        }
        if (normals != null) {
            requireLength("normals", normals.length, 3, count);
            requireFinite("normals", normals, 3);
        }
        if (maps != null) {
            requireLength("maps", maps.length, 2, count);
            requireFinite("maps", maps, 2);
        }
    }

    public int vertexCount() {
        return vertices.length / 3;
    }

    public int triangleCount() {
        return triangles.length / 3;
    }

    private static void requireLength(String name, int length, int each, int count) {
        if (length != each * count) {
            throw new IllegalArgumentException(
                    name + " must have " + each + " numbers each, for " + count + " in all, but has " + length);
        }
    }

    private static void requireFinite(String name, double[] values, int each) {
        for (int i = 0; i < values.length; i++) {
            if (!Double.isFinite(values[i])) {
                throw new IllegalArgumentException(name + " must be finite, but number " + i % each + " of vertex "
                        + i / each + " is " + values[i]);
            }
        }
    }
}
