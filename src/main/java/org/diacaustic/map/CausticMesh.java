package org.diacaustic.map;

import org.diacaustic.index.BoxTree;
import org.diacaustic.math.Arithmetic;
import org.diacaustic.math.Vector3;
import org.diacaustic.parallel.Workers;

/**
 * The caustic mesh: cells of light, arranged to be found by place. A lookup sums the power of every cell times the part of it
 * that lies in a footprint, over the footprint's area: exact coverage, without noise and without a radius.
 *
 * <p>Vertices are kept as single-precision offsets from the middle of the box of their leaf, which holds a few cells side by
 * side: they are off by at most 2^-24 of that box, so about 1e-7 of a cell, however small cells are in the scene. Immutable
 * and shared by threads.
 */
public final class CausticMesh implements IlluminationMap {
    /** The largest number of cells in a leaf. */
    static final int LARGEST_LEAF = 6;

    /** Numbers of a cell: x, y and z of three vertices; red, green and blue power. */
    static final int NUMBERS = 12;

    /** Where among them power begins. */
    static final int POWER = 9;

    /** Cells read by one task. */
    private static final int TASK = 1 << 14;

    final BoxTree tree;

    /** Vertices in units of length, from the middle of the leaf's box; power in units of power. */
    final float[] numbers;

    /** Of each cell: the packed normal, and the receiver, which is object · 2 + front. */
    final int[] tags;

    /** Null if they are not kept. */
    final CellSeeds seeds;

    private final Vector3 origin;
    private final double lengthUnit;
    private final double powerUnit;
    private final double largestExtent;

    private CausticMesh(CellStore store, Workers workers) {
        int size = store.size();
        origin = store.origin();
        powerUnit = store.powerUnit();
        double unit = unit(store, workers);
        lengthUnit = unit * store.lengthUnit();
        numbers = new float[NUMBERS * size];
        tags = new int[2 * size];
        seeds = store.keepsSeeds() ? new CellSeeds(size) : null;
        float[] extents = new float[size];
        tree = tree(store, unit, extents, workers);
        largestExtent = largest(extents);
        store.forget();
    }

    /**
     * Moves the cells of a store into a mesh; the store is empty afterwards. The same cells give the same mesh for any number
     * of threads, unless the workers are stopped, which leaves it unfinished.
     */
    public static CausticMesh movedFrom(CellStore store, Workers workers) {
        return new CausticMesh(store, workers);
    }

    /** A power of two about as large as the farthest offset of a vertex from the origin, in units of the store. */
    private static double unit(CellStore store, Workers workers) {
        int tasks = tasks(store.size());
        double[] largest = new double[tasks];
        workers.run(tasks, () -> {
            CellReader reader = new CellReader(store, 1);
            return task -> {
                double farthest = 0;
                int end = end(task, store.size());
                for (int cell = task * TASK; cell < end; cell++) {
                    reader.read(cell);
                    farthest = Math.max(farthest, reader.farthest());
                }
                largest[task] = farthest;
            };
        });
        double farthest = 0;
        for (double part : largest) {
            farthest = Math.max(farthest, part);
        }
        return farthest == 0 ? 1 : Arithmetic.powerOfTwoNear(farthest);
    }

    private static double largest(float[] extents) {
        double largest = 0;
        for (float extent : extents) {
            largest = Math.max(largest, extent);
        }
        return largest;
    }

    /** @param extents set to the longest side of each cell's box, in units of length, in any order */
    private BoxTree tree(CellStore store, double unit, float[] extents, Workers workers) {
        int size = store.size();
        float[] x = new float[size];
        float[] y = new float[size];
        float[] z = new float[size];
        int[] order = new int[size];
        workers.run(tasks(size), () -> {
            CellReader reader = new CellReader(store, unit);
            return task -> {
                int end = end(task, size);
                for (int cell = task * TASK; cell < end; cell++) {
                    reader.read(cell);
                    x[cell] = (float) reader.middle(0);
                    y[cell] = (float) reader.middle(1);
                    z[cell] = (float) reader.middle(2);
                    extents[cell] = (float) reader.extent();
                    order[cell] = cell;
                }
            };
        });
        return BoxTree.over(
                x,
                y,
                z,
                extents,
                order,
                LARGEST_LEAF,
                () -> {
                    CellReader reader = new CellReader(store, unit);
                    return (leaf, first, end, boxes, place) -> arrange(reader, order, first, end, boxes, place);
                },
                workers);
    }

    /** Moves the cells of a leaf to their places. */
    private void arrange(CellReader reader, int[] order, int first, int end, float[] boxes, int place) {
        for (int axis = 0; axis < 3; axis++) {
            boxes[place + axis] = Float.POSITIVE_INFINITY;
            boxes[place + 3 + axis] = Float.NEGATIVE_INFINITY;
        }
        for (int i = first; i < end; i++) {
            reader.read(order[i]);
            for (int axis = 0; axis < 3; axis++) {
                boxes[place + axis] = Math.min(boxes[place + axis], (float) reader.smallest(axis));
                boxes[place + 3 + axis] = Math.max(boxes[place + 3 + axis], (float) reader.largest(axis));
            }
        }
        double x = BoxTree.middle(boxes, place);
        double y = BoxTree.middle(boxes, place + 1);
        double z = BoxTree.middle(boxes, place + 2);
        for (int i = first; i < end; i++) {
            reader.read(order[i]);
            reader.write(x, y, z, numbers, NUMBERS * i, tags, 2 * i);
            reader.writeSeed(seeds, i);
        }
    }

    private static int tasks(int size) {
        return (size + TASK - 1) / TASK;
    }

    private static int end(int task, int size) {
        return (int) Math.min(size, (task + 1L) * TASK);
    }

    @Override
    public FootprintLookup lookup() {
        return new FootprintLookup(this, null);
    }

    /**
     * A reader for one task that asks about points more exactly: in each triangle that a point is in, it looks for the light ray
     * that lands at the very point. Where there is none, as where light is folded, the triangle's own density counts.
     * Footprints are read as ever.
     *
     * @param paths of the light that the mesh was made of, owned by the same task
     * @throws IllegalStateException if the mesh was made of a store that does not keep seeds
     */
    public FootprintLookup lookup(LightPaths paths) {
        if (seeds == null) {
            throw new IllegalStateException("a mesh follows light rays only if its cells keep their seeds");
        }
        return new FootprintLookup(this, paths);
    }

    @Override
    public boolean readsFootprints() {
        return true;
    }

    /** The number of cells. */
    public int size() {
        return tree.size();
    }

    @Override
    public long bytes() {
        return (4L * NUMBERS + 8 + (seeds == null ? 0 : CellSeeds.BYTES)) * size() + tree.bytes();
    }

    Vector3 origin() {
        return origin;
    }

    /** The longest side of the box of any cell, in units of length. */
    double largestExtent() {
        return largestExtent;
    }

    /** In scene units. */
    double lengthUnit() {
        return lengthUnit;
    }

    /** In W. */
    double powerUnit() {
        return powerUnit;
    }
}
