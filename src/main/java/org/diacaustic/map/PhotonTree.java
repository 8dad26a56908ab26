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
 * photon, tree included. Positions are kept in units of about the size of what is lit, so that
 * squared distances stay in range whatever the scale of the scene. Immutable, shared by maps and threads.
 */
public final class PhotonTree {
    /** Photons copied by one task: whole chunks. */
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

    /** For each leaf, the normal that all its photons have, or {@link PackedNormal#MIXED}. */
    final int[] leafNormal;

    private final Vector3 origin;
    private final double lengthUnit;
    private final double powerUnit;

    private PhotonTree(PhotonStore store, Workers workers) {
        int size = store.size();
        origin = store.origin();
        powerUnit = store.powerUnit();
        store.forEachChunk(chunk -> chunk.receiver = null);
        x = take(store, chunk -> chunk.x, chunk -> chunk.x = null, workers);
        y = take(store, chunk -> chunk.y, chunk -> chunk.y = null, workers);
        z = take(store, chunk -> chunk.z, chunk -> chunk.z = null, workers);
        float largest = Math.max(largest(x), Math.max(largest(y), largest(z)));
        double change = largest == 0 ? 1 : Arithmetic.powerOfTwoNear(largest);
        lengthUnit = change * store.lengthUnit();
        divide(x, change, workers);
        divide(y, change, workers);
        divide(z, change, workers);
        int[] numbers = new int[size];
        for (int i = 0; i < size; i++) {
            numbers[i] = i;
        }
        points = PointTree.over(x, y, z, numbers, workers);
        red = arrange(take(store, chunk -> chunk.red, chunk -> chunk.red = null, workers), numbers, workers);
        green = arrange(take(store, chunk -> chunk.green, chunk -> chunk.green = null, workers), numbers, workers);
        blue = arrange(take(store, chunk -> chunk.blue, chunk -> chunk.blue = null, workers), numbers, workers);
        normal = arrangeNormals(store, numbers, workers);
        leafNormal = leafNormals();
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

    /** Moves an array of every chunk into one array of all. */
    private static float[] take(
            PhotonStore store, Function<PhotonChunk, float[]> column, Consumer<PhotonChunk> release, Workers workers) {
        float[] all = new float[store.size()];
        share(workers, all.length, (first, end) -> {
            for (int start = first; start < end; start += PhotonChunk.SIZE) {
                float[] part = column.apply(store.chunk(start >> PhotonChunk.BITS));
                System.arraycopy(part, 0, all, start, Math.min(PhotonChunk.SIZE, end - start));
            }
        });
        store.forEachChunk(release);
        return all;
    }

    private static float largest(float[] values) {
        float largest = 0;
        for (float value : values) {
            float size = Math.abs(value);
            largest = size > largest ? size : largest;
        }
        return largest;
    }

    private static void divide(float[] values, double unit, Workers workers) {
        double inverse = 1 / unit;
        share(workers, values.length, (start, end) -> {
            for (int i = start; i < end; i++) {
                values[i] = (float) (values[i] * inverse);
            }
        });
    }

    private static float[] arrange(float[] before, int[] numbers, Workers workers) {
        float[] after = new float[numbers.length];
        share(workers, numbers.length, (start, end) -> {
            for (int i = start; i < end; i++) {
                after[i] = before[numbers[i]];
            }
        });
        return after;
    }

    private static int[] arrangeNormals(PhotonStore store, int[] numbers, Workers workers) {
        int[] after = new int[numbers.length];
        share(workers, numbers.length, (start, end) -> {
            for (int i = start; i < end; i++) {
                int number = numbers[i];
                after[i] = store.chunk(number >> PhotonChunk.BITS).normal[number & PhotonChunk.SIZE - 1];
            }
        });
        return after;
    }

    private int[] leafNormals() {
        int[] common = new int[points.leafCount()];
        for (int leaf = 0; leaf < common.length; leaf++) {
            int first = normal[points.first(leaf)];
            common[leaf] = first;
            for (int i = points.first(leaf); i < points.end(leaf); i++) {
                common[leaf] = normal[i] == first ? common[leaf] : PackedNormal.MIXED;
            }
        }
        return common;
    }

    private static void share(Workers workers, int size, RangeTask task) {
        int tasks = (int) ((size + TASK - 1L) / TASK);
        if (tasks <= 1) {
            task.run(0, size);
        } else {
            workers.run(tasks, () -> i -> task.run(i * TASK, (int) Math.min(size, (i + 1L) * TASK)));
        }
    }

    /** The number of photons. */
    public int size() {
        return points.size();
    }

    /** The number of nodes from the root to a leaf, which is the same for all leaves; 0 if there are no photons. */
    public int depth() {
        return points.depth();
    }

    /** The memory that photons and tree take. */
    public long bytes() {
        return 28L * size() + 4L * leafNormal.length + points.bytes();
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
