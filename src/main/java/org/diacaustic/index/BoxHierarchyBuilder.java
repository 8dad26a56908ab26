package org.diacaustic.index;

import java.util.Arrays;
import java.util.concurrent.ForkJoinTask;
import org.diacaustic.math.Arithmetic;
import org.diacaustic.math.Bounds;

/**
 * Builds a {@link BoxHierarchy} from the top down: every range of items is cut where the binned surface area heuristic
 * expects the fewest tests, or in the middle where it cannot tell [Wald 2007]. Large right halves are built by other
 * threads into arrays of their own and appended, which gives the arrays that one thread would have made.
 */
final class BoxHierarchyBuilder {
    /** A leaf is first · 2^COUNT_BITS + (count − 1). */
    static final int COUNT_BITS = 4;

    /** No path from the root is longer. */
    static final int LARGEST_DEPTH = 64;

    /** Below this depth ranges are halved, which ends within 2^28 items. */
    private static final int LARGEST_HEURISTIC_DEPTH = LARGEST_DEPTH - 28;

    private static final int LARGEST_LEAF = 8;

    /** Ranges from this size on are shared between threads. */
    private static final int SHARED_SIZE = 1 << 14;

    private final int[] items;
    private final int[] spare;

    /** Six planes an item, in the tree's frame, rounded outward. */
    private final float[] boxes;

    private final double originX;
    private final double originY;
    private final double originZ;
    private final double scale;
    private final Bounds bounds;
    private Branch trunk;
    private int root;

    BoxHierarchyBuilder(double[] itemBoxes) {
        int n = itemBoxes.length / 6;
        if (itemBoxes.length != 6 * n) {
            throw new IllegalArgumentException("boxes must have 6 numbers each, but there are " + itemBoxes.length);
        }
        if (n >= 1 << Integer.SIZE - 1 - COUNT_BITS) {
            throw new IllegalArgumentException("too many items for one hierarchy: " + n);
        }
        double[] low = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
        double[] high = {Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY};
        for (int i = 0; i < itemBoxes.length; i += 6) {
            for (int axis = 0; axis < 3; axis++) {
                double min = itemBoxes[i + axis];
                double max = itemBoxes[i + 3 + axis];
                if (!(min <= max && min > Double.NEGATIVE_INFINITY && max < Double.POSITIVE_INFINITY)) {
                    throw new IllegalArgumentException("the box of item " + i / 6
                            + " must be finite and not empty, but is " + min + ".." + max + " on axis " + axis);
                }
                low[axis] = Math.min(low[axis], min);
                high[axis] = Math.max(high[axis], max);
            }
        }
        this.bounds = n == 0 ? Bounds.EMPTY : new Bounds(low[0], low[1], low[2], high[0], high[1], high[2]);
        this.originX = n == 0 ? 0 : low[0] / 2 + high[0] / 2;
        this.originY = n == 0 ? 0 : low[1] / 2 + high[1] / 2;
        this.originZ = n == 0 ? 0 : low[2] / 2 + high[2] / 2;
        double halfSize = 0;
        for (int axis = 0; axis < 3 && n > 0; axis++) {
            halfSize = Math.max(halfSize, high[axis] / 2 - low[axis] / 2);
        }
        this.scale = halfSize > 0 ? 2 * Arithmetic.powerOfTwoNear(halfSize) : 1;
        this.boxes = new float[6 * n];
        this.items = new int[n];
        this.spare = new int[n];
        for (int item = 0; item < n; item++) {
            items[item] = item;
            int i = 6 * item;
            boxes[i] = below((itemBoxes[i] - originX) / scale);
            boxes[i + 1] = above((itemBoxes[i + 3] - originX) / scale);
            boxes[i + 2] = below((itemBoxes[i + 1] - originY) / scale);
            boxes[i + 3] = above((itemBoxes[i + 4] - originY) / scale);
            boxes[i + 4] = below((itemBoxes[i + 2] - originZ) / scale);
            boxes[i + 5] = above((itemBoxes[i + 5] - originZ) / scale);
        }
    }

    BoxHierarchyBuilder build() {
        int n = items.length;
        trunk = new Branch(n);
        root = n == 0 ? 0 : trunk.build(0, n, 0, -1);
        return this;
    }

    /** A float below a coordinate of the frame, which is within ±1 and uncertain by less than 2^-52. */
    private static float below(double value) {
        double low = value - 0x1p-52;
        float rounded = (float) low;
        return rounded <= low ? rounded : Math.nextDown(rounded);
    }

    private static float above(double value) {
        return -below(-value);
    }

    float[] planes() {
        return Arrays.copyOf(trunk.planes, 12 * trunk.nodes);
    }

    int[] children() {
        return Arrays.copyOf(trunk.children, 2 * trunk.nodes);
    }

    int[] items() {
        return items;
    }

    int root() {
        return root;
    }

    double originX() {
        return originX;
    }

    double originY() {
        return originY;
    }

    double originZ() {
        return originZ;
    }

    double scale() {
        return scale;
    }

    Bounds bounds() {
        return bounds;
    }

    /** A part of the tree with nodes numbered from 0, depth first, and the working storage of one thread. */
    private final class Branch {
        private float[] planes;
        private int[] children;
        private int nodes;

        private final Bins bins = new Bins(boxes, items, spare);

        Branch(int size) {
            int capacity = Math.max(1, size / 2);
            planes = new float[12 * capacity];
            children = new int[2 * capacity];
        }

        /**
         * Builds the subtree of items[start, end).
         *
         * @param place where among the planes the box of the range goes; negative for nowhere
         * @return the number of its root node, or ~leaf
         */
        int build(int start, int end, int depth, int place) {
            int count = end - start;
            bins.measure(start, end);
            if (place >= 0) {
                bins.copyBox(planes, place);
            }
            if (count == 1) {
                return ~(start << COUNT_BITS);
            }
            boolean informed = depth < LARGEST_HEURISTIC_DEPTH && bins.findCut(start, end);
            if (count <= LARGEST_LEAF && (!informed || bins.cutCost() >= count)) {
                return ~(start << COUNT_BITS | count - 1);
            }
            int middle = informed ? bins.partition(start, end) : start + end >>> 1;
            int node = addNode();
            if (count >= SHARED_SIZE) {
                buildShared(node, start, middle, end, depth);
            } else {
                int first = build(start, middle, depth + 1, 12 * node);
                children[2 * node] = first;
                int second = build(middle, end, depth + 1, 12 * node + 6);
                children[2 * node + 1] = second;
            }
            return node;
        }

        private void buildShared(int node, int start, int middle, int end, int depth) {
            Branch other = new Branch(end - middle);
            // Node 0 of the branch only receives the box of its root.
            other.addNode();
            ForkJoinTask<Integer> task = ForkJoinTask.adapt(() -> other.build(middle, end, depth + 1, 0));
            task.fork();
            int first = build(start, middle, depth + 1, 12 * node);
            children[2 * node] = first;
            int root = task.join();
            children[2 * node + 1] = root < 0 ? root : root - 1 + nodes;
            System.arraycopy(other.planes, 0, planes, 12 * node + 6, 6);
            append(other);
        }

        private void append(Branch other) {
            int added = other.nodes - 1;
            reserve(nodes + added);
            System.arraycopy(other.planes, 12, planes, 12 * nodes, 12 * added);
            for (int i = 0; i < 2 * added; i++) {
                int child = other.children[2 + i];
                children[2 * nodes + i] = child < 0 ? child : child - 1 + nodes;
            }
            nodes += added;
        }

        private int addNode() {
            reserve(nodes + 1);
            return nodes++;
        }

        private void reserve(int size) {
            if (12 * size > planes.length) {
                int capacity = Math.max(size, 2 * nodes);
                planes = Arrays.copyOf(planes, 12 * capacity);
                children = Arrays.copyOf(children, 2 * capacity);
            }
        }
    }
}
