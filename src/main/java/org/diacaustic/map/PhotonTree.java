package org.diacaustic.map;

import java.util.function.Consumer;
import java.util.function.Function;
import org.diacaustic.index.PointTree;
import org.diacaustic.math.Arithmetic;
import org.diacaustic.math.Rgb;
import org.diacaustic.math.Vector3;
import org.diacaustic.parallel.Workers;

/**
 * The photons of a pass, arranged to be found by place: arrays in the order of a kd-tree's leaves. At most 32 bytes a
 * photon, tree included. Positions are kept in units of a power of two that is about the size of what is lit, so that
 * squared distances stay in range whatever the scale of the scene. Immutable, shared by maps and threads.
 */
public final class PhotonTree {
    /** Photons copied by one task. */
    private static final int TASK = 1 << 16;

    final PointTree points;

    /** Offsets from the origin, in units of length. */
    final float[] x;

    final float[] y;
    final float[] z;

    /** In units of power. */
    final float[] red;

    final float[] green;
    final float[] blue;
    final int[] normal;

    private final Vector3 origin;
    private final double lengthUnit;
    private final double powerUnit;

    private PhotonTree(PhotonStore store, Workers workers) {
        int size = store.size();
        origin = store.origin();
        powerUnit = store.powerUnit();
        lengthUnit = lengthUnit(store);
        x = take(store, chunk -> chunk.x, 1 / lengthUnit);
        forEachChunk(store, chunk -> chunk.x = null);
        y = take(store, chunk -> chunk.y, 1 / lengthUnit);
        forEachChunk(store, chunk -> chunk.y = null);
        z = take(store, chunk -> chunk.z, 1 / lengthUnit);
        forEachChunk(store, chunk -> chunk.z = null);
        forEachChunk(store, chunk -> chunk.receiver = null);
        int[] numbers = new int[size];
        for (int i = 0; i < size; i++) {
            numbers[i] = i;
        }
        points = PointTree.over(x, y, z, numbers, workers);
        red = arrange(store, numbers, chunk -> chunk.red, workers);
        forEachChunk(store, chunk -> chunk.red = null);
        green = arrange(store, numbers, chunk -> chunk.green, workers);
        forEachChunk(store, chunk -> chunk.green = null);
        blue = arrange(store, numbers, chunk -> chunk.blue, workers);
        forEachChunk(store, chunk -> chunk.blue = null);
        normal = arrangeNormals(store, numbers, workers);
        store.forget();
    }

    /**
     * Moves the photons of a store into a tree. Each of the store's arrays is given up as soon as it has been read, so
     * there is never much more in memory than the photons once; the store is empty afterwards. The same photons
     * give the same tree for any number of threads, unless the workers are stopped, which leaves it unfinished.
     */
    public static PhotonTree movedFrom(PhotonStore store, Workers workers) {
        return new PhotonTree(store, workers);
    }

    private static double lengthUnit(PhotonStore store) {
        float largest = 0;
        int left = store.size();
        for (int c = 0; c < store.chunkCount(); c++) {
            PhotonChunk chunk = store.chunk(c);
            int count = Math.min(left, PhotonChunk.SIZE);
            for (int i = 0; i < count; i++) {
                largest = Math.max(largest, Math.max(Math.abs(chunk.x[i]), Math.abs(chunk.y[i])));
                largest = Math.max(largest, Math.abs(chunk.z[i]));
            }
            left -= count;
        }
        return largest == 0 ? 1 : Arithmetic.powerOfTwoNear(largest);
    }

    private static void forEachChunk(PhotonStore store, Consumer<PhotonChunk> action) {
        for (int c = 0; c < store.chunkCount(); c++) {
            action.accept(store.chunk(c));
        }
    }

    private static float[] take(PhotonStore store, Function<PhotonChunk, float[]> column, double scale) {
        float[] all = new float[store.size()];
        for (int c = 0; c < store.chunkCount(); c++) {
            float[] part = column.apply(store.chunk(c));
            int start = c << PhotonChunk.BITS;
            int count = Math.min(PhotonChunk.SIZE, all.length - start);
            for (int i = 0; i < count; i++) {
                all[start + i] = (float) (part[i] * scale);
            }
        }
        return all;
    }

    private static float[] arrange(
            PhotonStore store, int[] numbers, Function<PhotonChunk, float[]> column, Workers workers) {
        float[] all = new float[numbers.length];
        share(workers, numbers.length, (start, end) -> {
            for (int i = start; i < end; i++) {
                int number = numbers[i];
                all[i] = column.apply(store.chunk(number >> PhotonChunk.BITS))[number & PhotonChunk.SIZE - 1];
            }
        });
        return all;
    }

    private static int[] arrangeNormals(PhotonStore store, int[] numbers, Workers workers) {
        int[] all = new int[numbers.length];
        share(workers, numbers.length, (start, end) -> {
            for (int i = start; i < end; i++) {
                int number = numbers[i];
                all[i] = store.chunk(number >> PhotonChunk.BITS).normal[number & PhotonChunk.SIZE - 1];
            }
        });
        return all;
    }

    private static void share(Workers workers, int size, RangeTask task) {
        int tasks = (int) ((size + TASK - 1L) / TASK);
        if (tasks <= 1) {
            task.run(0, size);
        } else {
            workers.run(tasks, () -> i -> task.run(i * TASK, Math.min(size, (i + 1) * TASK)));
        }
    }

    /** The number of photons. */
    public int size() {
        return points.size();
    }

    /** The memory that photons and tree take. */
    public long bytes() {
        return 28L * size() + points.bytes();
    }

    /** In scene units. */
    double lengthUnit() {
        return lengthUnit;
    }

    /** In W. */
    double powerUnit() {
        return powerUnit;
    }

    Vector3 origin() {
        return origin;
    }

    /** Sets point and normal to those of photon i of the tree's order. */
    public void position(int i, SurfacePoint out) {
        out.x = x[i] * lengthUnit + origin.x();
        out.y = y[i] * lengthUnit + origin.y();
        out.z = z[i] * lengthUnit + origin.z();
        PackedNormal.unpack(normal[i], out);
    }

    /** Sets the power of photon i, in W. */
    public void power(int i, Rgb out) {
        out.set(red[i] * powerUnit, green[i] * powerUnit, blue[i] * powerUnit);
    }

    /** What is done with the photons from one to before another. */
    private interface RangeTask {
        void run(int start, int end);
    }
}
