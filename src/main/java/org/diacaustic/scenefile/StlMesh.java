package org.diacaustic.scenefile;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import org.diacaustic.shape.MeshData;

/**
 * Reads STL, text and binary. Vertices that are equal in every bit become one; the facets' normals are passed over,
 * because the order of the corners says the same.
 */
final class StlMesh {
    private static final int HEADER_BYTES = 84;
    private static final int TRIANGLE_BYTES = 50;

    private final byte[] bytes;
    private final MeshAssembly assembly;
    private final TripleIndex vertices = new TripleIndex();
    private final IntList triangles = new IntList();

    StlMesh(byte[] bytes, MeshAssembly assembly) {
        this.bytes = bytes;
        this.assembly = assembly;
    }

    MeshData read() {
        if (isText()) {
            readText();
        } else {
            readBinary();
        }
        double[] points = new double[Math.multiplyExact(3, vertices.size())];
        for (int i = 0; i < points.length; i++) {
            points[i] = Double.longBitsToDouble(vertices.key(i / 3, i % 3));
        }
        return assembly.finish(points, triangles.toArray(), null, null);
    }

    /** Binary files may begin with "solid" as well; the length that they announce, or a zero byte, gives them away. */
    private boolean isText() {
        if (bytes.length >= HEADER_BYTES && bytes.length == HEADER_BYTES + TRIANGLE_BYTES * announced()) {
            return false;
        }
        for (int i = 0; i < Math.min(bytes.length, 512); i++) {
            if (bytes[i] == 0) {
                return false;
            }
        }
        MeshText text = new MeshText(bytes);
        return text.nextWordAnywhere() && text.is("solid");
    }

    /** The number of triangles in a binary header. */
    private long announced() {
        return ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN).getInt(HEADER_BYTES - 4) & 0xFFFFFFFFL;
    }

    private void readBinary() {
        if (bytes.length < HEADER_BYTES) {
            throw MeshFault.atByte(
                    bytes.length, "is not an STL file: neither does it begin with 'solid' nor has it a binary header");
        }
        long expected = HEADER_BYTES + TRIANGLE_BYTES * announced();
        if (bytes.length != expected) {
            throw MeshFault.atByte(
                    HEADER_BYTES - 4,
                    "announces " + announced() + " triangles, which make " + expected + " bytes, but the file has "
                            + bytes.length);
        }
        ByteBuffer data = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
        for (int at = HEADER_BYTES; at < bytes.length; at += TRIANGLE_BYTES) {
            for (int corner = at + 12; corner < at + 48; corner += 12) {
                addCorner(finite(data, corner), finite(data, corner + 4), finite(data, corner + 8));
            }
        }
    }

    private static double finite(ByteBuffer data, int at) {
        float value = data.getFloat(at);
        if (!Float.isFinite(value)) {
            throw MeshFault.atByte(at, "expected a finite number, found " + value);
        }
        return value;
    }

    /** Adding zero makes one of the two zeros, so that they meet. */
    private void addCorner(double x, double y, double z) {
        triangles.add(vertices.indexOf(
                Double.doubleToLongBits(x + 0.0), Double.doubleToLongBits(y + 0.0), Double.doubleToLongBits(z + 0.0)));
    }

    private void readText() {
        MeshText text = new MeshText(bytes);
        while (text.nextWordAnywhere()) {
            require(text, "solid");
            text.nextLine();
            while (!next(text, "facet or endsolid").equals("endsolid")) {
                readFacet(text);
            }
            text.nextLine();
        }
    }

    private void readFacet(MeshText text) {
        require(text, "facet");
        text.nextLine();
        requireNext(text, "outer");
        requireNext(text, "loop");
        for (int corner = 0; corner < 3; corner++) {
            requireNext(text, "vertex");
            addCorner(text.number("x"), text.number("y"), text.number("z"));
        }
        requireNext(text, "endloop");
        requireNext(text, "endfacet");
    }

    private static String next(MeshText text, String expected) {
        if (!text.nextWordAnywhere()) {
            throw text.fault("the file ends where " + expected + " should follow");
        }
        return text.word();
    }

    private static void requireNext(MeshText text, String word) {
        next(text, word);
        require(text, word);
    }

    private static void require(MeshText text, String word) {
        if (!text.is(word)) {
            throw text.fault("expected " + word + ", found '" + Problem.printable(text.word(), 40) + "'");
        }
    }
}
