package org.diacaustic.map;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.IntStream;

/**
 * Writes what the benchmarks gather, for other programs to do the same: {@code java -cp target/benchmarks.jar
 * org.diacaustic.map.PointFiles FOLDER [photons]}. Three floats a point, little-endian, in {@code photons.f32}, {@code
 * rows.f32} and {@code shuffled.f32}; the radius in {@code radius.txt}. {@code src/jmh/python/ckdtree.py} reads them.
 */
public final class PointFiles {
    private PointFiles() {}

    public static void main(String[] arguments) throws IOException {
        Path folder = Files.createDirectories(Path.of(arguments[0]));
        int size = arguments.length > 1 ? Integer.parseInt(arguments[1]) : 1_000_000;
        PhotonStore store = CausticPhotons.store(size);
        SurfacePoint[] photons = IntStream.range(0, size)
                .mapToObj(i -> {
                    SurfacePoint point = new SurfacePoint();
                    store.position(i, point);
                    return point;
                })
                .toArray(SurfacePoint[]::new);
        write(folder.resolve("photons.f32"), photons);
        write(folder.resolve("rows.f32"), CausticPhotons.queries(100_000, false));
        write(folder.resolve("shuffled.f32"), CausticPhotons.queries(100_000, true));
        Files.writeString(folder.resolve("radius.txt"), CausticPhotons.radiusFor(112, size) + "\n");
    }

    private static void write(Path file, SurfacePoint[] points) throws IOException {
        ByteBuffer buffer = ByteBuffer.allocate(12 * points.length).order(ByteOrder.LITTLE_ENDIAN);
        for (SurfacePoint point : points) {
            buffer.putFloat((float) point.x).putFloat((float) point.y).putFloat((float) point.z);
        }
        Files.write(file, buffer.array());
    }
}
