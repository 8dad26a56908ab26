package org.diacaustic.index;

import java.util.function.IntConsumer;
import org.diacaustic.parallel.Workers;

/**
 * Builds a {@link PointTree} from the top down, in place: every range is halved at its median along the widest side of its
 * box. The nodes of the upper levels are tasks level by level, then every subtree below them is one.
 */
final class PointTreeBuilder {
    /** Trees of fewer points are built by the calling thread. */
    private static final int SHARED_SIZE = 1 << 14;

    /** The level whose subtrees are one task each. */
    private static final int SHARED_LEVELS = 6;

    /** Things are parted by size only where the largest are so many times as large as the smallest. */
    private static final float MUCH_LARGER = 4;

    private final float[] x;
    private final float[] y;
    private final float[] z;

    /** How large the points are that stand for something; null if they do not. */
    private final float[] extents;

    private final int[] numbers;
    private final int size;
    private final int levels;
    private final float[] boxes;

    /**
     * @param extents how large the things are that the points stand for: where some are larger than the place they lie in,
     *     they are parted by size; null if they are all points
     * @param largestLeaf the largest number of points in a leaf
     */
    PointTreeBuilder(float[] x, float[] y, float[] z, float[] extents, int[] numbers, int largestLeaf) {
        this.x = x;
        this.y = y;
        this.z = z;
        this.extents = extents;
        this.numbers = numbers;
        this.size = numbers.length;
        if (x.length < size || y.length < size || z.length < size) {
            throw new IllegalArgumentException(size + " points need as many coordinates, but have " + x.length + ", "
                    + y.length + " and " + z.length);
        }
        int depth = 0;
        while ((long) largestLeaf << depth < size) {
            depth++;
        }
        this.levels = depth;
        this.boxes = new float[size == 0 ? 0 : 12 << depth];
    }

    PointTreeBuilder build(Workers workers) {
        if (size == 0) {
            return this;
        }
        for (int i = 0; i < size; i++) {
            // Not finite times 0 is not a number, and stays so in the sum.
            if (!(0 * x[i] + 0 * y[i] + 0 * z[i] == 0)) {
                throw new IllegalArgumentException("point " + numbers[i] + " of a tree must be finite, but is [" + x[i]
                        + ", " + y[i] + ", " + z[i] + "]");
            }
        }
        if (size < SHARED_SIZE) {
            subtree(1, 0, new MedianSelection(x, y, z, extents, numbers));
            return this;
        }
        int level = 0;
        while (level < SHARED_LEVELS) {
            int depth = level++;
            share(workers, 1 << depth, selection -> node -> split(node, depth, selection));
        }
        share(workers, 1 << SHARED_LEVELS, selection -> node -> subtree(node, SHARED_LEVELS, selection));
        return this;
    }

    /** Runs a task for every node of a level. */
    private void share(Workers workers, int nodes, NodeTask task) {
        workers.run(nodes, () -> {
            IntConsumer work = task.with(new MedianSelection(x, y, z, extents, numbers));
            return i -> work.accept(nodes + i);
        });
    }

    private void subtree(int node, int level, MedianSelection selection) {
        split(node, level, selection);
        if (level < levels) {
            subtree(2 * node, level + 1, selection);
            subtree(2 * node + 1, level + 1, selection);
        }
    }

    /** Measures a node, and if it is no leaf brings the points of its children to their sides. */
    private void split(int node, int level, MedianSelection selection) {
        int below = levels - level;
        int leaf = (node << below) - (1 << levels);
        int start = PointTree.first(leaf, size, levels);
        int end = PointTree.first(leaf + (1 << below), size, levels);
        float widthX = measure(x, start, end, 6 * node);
        float widthY = measure(y, start, end, 6 * node + 2);
        float widthZ = measure(z, start, end, 6 * node + 4);
        if (below > 0) {
            float widest = Math.max(widthX, Math.max(widthY, widthZ));
            float[] along = isUneven(start, end, widest) ? extents : widthX == widest ? x : widthY == widest ? y : z;
            selection.select(along, start, end, PointTree.first(leaf + (1 << below - 1), size, levels));
        }
    }

    /** Whether there are things much larger than others in the range, and larger than where they lie. */
    private boolean isUneven(int start, int end, float widest) {
        if (extents == null) {
            return false;
        }
        float smallest = Float.POSITIVE_INFINITY;
        float largest = 0;
        for (int i = start; i < end; i++) {
            smallest = Math.min(smallest, extents[i]);
            largest = Math.max(largest, extents[i]);
        }
        return largest > widest && largest > MUCH_LARGER * smallest;
    }

    /** Writes the range of the coordinates, and returns its width. */
    private float measure(float[] along, int start, int end, int place) {
        float low = along[start];
        float high = low;
        for (int i = start + 1; i < end; i++) {
            float value = along[i];
            low = value < low ? value : low;
            high = value > high ? value : high;
        }
        boxes[place] = low;
        boxes[place + 1] = high;
        return high - low;
    }

    int size() {
        return size;
    }

    int levels() {
        return levels;
    }

    float[] boxes() {
        return boxes;
    }

    /** What is done with a node, given what a thread works in. */
    private interface NodeTask {
        IntConsumer with(MedianSelection selection);
    }
}
