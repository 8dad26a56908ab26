package org.diacaustic.fault;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;

/** Faults of mesh files. */
final class MeshFaults {
    private static final String CORNERS = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    private static final String PLY = """
            ply
            format %s 1.0
            element vertex 3
            property float x
            property float y
            property float z
            element face 1
            property list uchar int vertex_indices
            end_header
            """;

    private MeshFaults() {}

    static void meet(FaultBench bench) throws IOException, InterruptedException {
        objects(bench);
        polygons(bench);
        solids(bench);
        bench.write("odd.obj", CORNERS + "v 2 0 0\nf 1 2 3\nf 1 2 2\nf 1 2 4\n");
        bench.renders(
                "triangles without area",
                scene("odd.obj"),
                "[^\\n]*odd\\.obj: warning: 2 of 3 triangles have no area[^\\n]*");
    }

    private static void objects(FaultBench bench) throws IOException, InterruptedException {
        refuses(bench, "m.obj", CORNERS + "f 1 2 7\n", ":4: .*names vertex 7");
        refuses(bench, "m.obj", CORNERS + "f 0 1 2\n", ":4: ");
        refuses(bench, "m.obj", CORNERS + "f 1 2\n", ":4: ");
        refuses(bench, "m.obj", "v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n", ":2: .*found 'nan'");
        refuses(bench, "m.obj", "v 0 0 0\nv inf 0 0\nv 0 1 0\nf 1 2 3\n", ":2: .*found 'inf'");
        refuses(bench, "m.obj", "f 1 2 3\n", ":1: ");
        refuses(bench, "m.obj", CORNERS, ": ");
        refuses(bench, "m.obj", "", ": ");
        refuses(bench, "m.xyz", CORNERS, ": ");
    }

    private static void polygons(FaultBench bench) throws IOException, InterruptedException {
        String head = PLY.replace("%s", "ascii");
        refuses(bench, "m.ply", head + "0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n", ":13: ");
        refuses(bench, "m.ply", head + "0 0 0\nnan 0 0\n0 1 0\n3 0 1 2\n", ":11: ");
        refuses(bench, "m.ply", head + "0 0 0\n1 0 0\n", "m\\.ply");
        refuses(bench, "m.ply", head.replace("vertex 3", "vertex 2000000000"), "m\\.ply");
        refuses(bench, "m.ply", "plx\n" + head, "m\\.ply");
        String binary = PLY.replace("%s", "binary_little_endian");
        refuses(bench, "m.ply", body(binary, 1, 7), "m\\.ply.*7");
        refuses(bench, "m.ply", body(binary, Float.NaN, 2), "m\\.ply.*NaN");
        byte[] whole = body(binary, 1, 2);
        refuses(bench, "m.ply", Arrays.copyOf(whole, whole.length - 5), "m\\.ply");
    }

    private static void solids(FaultBench bench) throws IOException, InterruptedException {
        String facet =
                "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex %s 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
        refuses(bench, "m.stl", facet.replace("%s", "nan") + "endsolid s\n", ":5: ");
        refuses(bench, "m.stl", facet.replace("%s", "1").substring(0, 60), "m\\.stl");
        byte[] binary = new byte[84 + 20];
        ByteBuffer.wrap(binary).order(ByteOrder.LITTLE_ENDIAN).putInt(80, 1_000_000);
        refuses(bench, "m.stl", binary, "m\\.stl");
    }

    private static byte[] body(String head, float coordinate, int index) throws IOException {
        ByteBuffer body =
                ByteBuffer.allocate(9 * Float.BYTES + 1 + 3 * Integer.BYTES).order(ByteOrder.LITTLE_ENDIAN);
        float[] corners = {0, 0, 0, coordinate, 0, 0, 0, 1, 0};
        for (float corner : corners) {
            body.putFloat(corner);
        }
        body.put((byte) 3).putInt(0).putInt(1).putInt(index);
        ByteArrayOutputStream file = new ByteArrayOutputStream();
        file.write(BrokenPictures.ascii(head));
        file.write(body.array());
        return file.toByteArray();
    }

    private static void refuses(FaultBench bench, String file, String text, String pattern)
            throws IOException, InterruptedException {
        refuses(bench, file, BrokenPictures.ascii(text), pattern);
    }

    private static void refuses(FaultBench bench, String file, byte[] bytes, String pattern)
            throws IOException, InterruptedException {
        bench.write(file, bytes);
        String end = new String(bytes, java.nio.charset.StandardCharsets.ISO_8859_1).replaceAll("[^\\x21-\\x7e]+", " ");
        bench.refuses(file + " ... " + end.substring(Math.max(0, end.length() - 20)), scene(file), 2, pattern);
    }

    private static String scene(String file) {
        return FaultScene.withObject("mesh", "file: " + file);
    }
}
