package org.diacaustic.scenefile;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import org.diacaustic.shape.MeshData;

/** Reads triangle meshes from Wavefront OBJ, PLY (text and binary) and STL (text and binary), told by the name's end. */
public final class MeshFile {
    private static final long MOST_BYTES = 1L << 30;

    private MeshFile() {}

    /**
     * The mesh of a file. Polygons are cut in triangles; triangles without area stay, with a warning.
     *
     * @return nothing if the file cannot be read or holds something wrong; {@code problems} say what and where
     */
    public static Optional<MeshData> read(Path file, Problems problems) {
        Place place = Place.of(file.toString());
        Optional<String> reason = FileErrors.whyUnreadable(file);
        if (reason.isPresent()) {
            problems.unreadable(place, "", reason.get());
            return Optional.empty();
        }
        String name = place.source().toLowerCase(Locale.ROOT);
        String ending = name.substring(name.lastIndexOf('.') + 1);
        try {
            if (!ending.matches("obj|ply|stl")) {
                throw MeshFault.atLine(0, "expected a mesh file that ends in .obj, .ply or .stl");
            }
            byte[] bytes = bytes(file, place, problems);
            if (bytes == null) {
                return Optional.empty();
            }
            MeshAssembly assembly = new MeshAssembly(place, problems);
            return Optional.of(
                    switch (ending) {
                        case "obj" -> new ObjMesh(bytes, assembly).read();
                        case "ply" -> new PlyMesh(bytes, assembly).read();
                        default -> new StlMesh(bytes, assembly).read();
                    });
        } catch (MeshFault fault) {
            problems.error(new Place(place.source(), fault.line(), 0), "", fault.getMessage());
        } catch (IOException failure) {
            problems.unreadable(place, "", "cannot be read: " + FileErrors.reason(failure));
        } catch (OutOfMemoryError full) {
            // All that was allocated is unreachable by now, so a message can be made.
            problems.limit(place, "", "does not fit in the Java heap of " + heapMebibytes() + " MiB; -Xmx sets it");
        }
        return Optional.empty();
    }

    /** The file's bytes; null after adding a problem if it is too large or no real file. */
    private static byte[] bytes(Path file, Place place, Problems problems) throws IOException {
        long most = Math.min(MOST_BYTES, Runtime.getRuntime().maxMemory() / 4);
        if (!Files.isRegularFile(file)) {
            problems.unreadable(place, "", "expected a regular file");
            return null;
        }
        if (Files.size(file) > most) {
            String limit = "is larger than the limit of " + (most >> 20)
                    + " MiB, the less of 1 GiB and a quarter of the" + " Java heap; -Xmx sets that";
            problems.limit(place, "", limit);
            return null;
        }
        return Files.readAllBytes(file);
    }

    private static long heapMebibytes() {
        return Runtime.getRuntime().maxMemory() >> 20;
    }
}
