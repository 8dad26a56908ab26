package org.diacaustic.index;

import java.util.function.Supplier;
import org.diacaustic.parallel.Workers;

/**
 * A balanced tree of boxes over n items that have a place and an extent. The items are brought into an order in which every
 * leaf is one range of them, and the tree hands out the leaves whose boxes a {@link BoxWalk}'s region touches; the items in
 * them are the caller's to look at:
 *
 * <pre>{@code
 * tree.start(walk);
 * for (int leaf = tree.next(walk); leaf != BoxTree.DONE; leaf = tree.next(walk)) {
 *     int end = tree.end(leaf);
 *     for (int i = tree.first(leaf); i < end; i++) {
 *         ask(i);
 *     }
 * }
 * }</pre>
 *
 * <p>Leaves come in the order of their numbers. Every range is halved at the median of the items' places along the
 * widest side, as that of a {@link PointTree} is, or of their extents where those differ more; so no arrangement of the
 * items makes the tree deeper. The boxes are those of the items, 24 bytes a node. Nothing is allocated by a walk. Immutable, and safe for many threads.
 */
public final class BoxTree {
    /** What {@link #next} returns when no leaf is left. No leaf is negative. */
    public static final int DONE = -1;

    /** No path from the root is longer. */
    static final int LARGEST_DEPTH = 32;

    /** The level whose subtrees are one task each, if there are as many. */
    private static final int SHARED_LEVELS = 6;

    private final int size;
    private final int levels;

    /** The number of leaves, a power of two. Node 1 is the root, the children of node i are 2i and 2i + 1. */
    private final int leaves;

    /** Six planes a node: smallest x, y, z, largest x, y, z. */
    private final float[] boxes;

    private BoxTree(PointTreeBuilder builder) {
        this.size = builder.size();
        this.levels = builder.levels();
        this.leaves = 1 << levels;
        this.boxes = builder.boxes();
    }

    /**
     * Builds the tree. All arrays are brought into the tree's order. The same places and numbers give the same order
     * and tree for any number of threads, unless the workers are stopped, which leaves both unfinished.
     *
     * @param x where the items are, as are y and z; anywhere in their boxes, the middle being the best
     * @param extents how large the items are: few large ones among many small ones are parted from them
     * @param numbers one for each item, all different: equal places are kept in their order
     * @param largestLeaf the largest number of items in a leaf, at least 1
     * @param items gives each thread what tells the box of each leaf, once {@code numbers} is in order
     * @throws IllegalArgumentException if a coordinate is not finite, or there are fewer coordinates than numbers
     */
    public static BoxTree over(
            float[] x,
            float[] y,
            float[] z,
            float[] extents,
            int[] numbers,
            int largestLeaf,
            Supplier<Items> items,
            Workers workers) {
        BoxTree tree = new BoxTree(new PointTreeBuilder(x, y, z, extents, numbers, largestLeaf).build(workers));
        if (tree.size > 0) {
            tree.measure(items, workers);
        }
        return tree;
    }

    /** Replaces the boxes of the places by those of the items. */
    private void measure(Supplier<Items> items, Workers workers) {
        int shared = Math.min(SHARED_LEVELS, levels);
        int roots = 1 << shared;
        workers.run(roots, () -> {
            Items own = items.get();
            return i -> measure(own, roots + i, shared);
        });
        for (int node = roots - 1; node > 0; node--) {
            join(node);
        }
    }

    private void measure(Items items, int node, int level) {
        if (level == levels) {
            items.box(node - leaves, first(node - leaves), end(node - leaves), boxes, 6 * node);
        } else {
            measure(items, 2 * node, level + 1);
            measure(items, 2 * node + 1, level + 1);
            join(node);
        }
    }

    private void join(int node) {
        int first = 12 * node;
        for (int i = 0; i < 3; i++) {
            boxes[6 * node + i] = Math.min(boxes[first + i], boxes[first + 6 + i]);
            boxes[6 * node + 3 + i] = Math.max(boxes[first + 3 + i], boxes[first + 9 + i]);
        }
    }

    /** The number of items. */
    public int size() {
        return size;
    }

    /** The number of nodes on a path from the root to a leaf, which is the same for all. */
    public int depth() {
        return size == 0 ? 0 : levels + 1;
    }

    /** The memory that the tree takes, without the items. */
    public long bytes() {
        return 4L * boxes.length;
    }

    /** The number of leaves, a power of two; 0 if there are no items. */
    public int leafCount() {
        return size == 0 ? 0 : leaves;
    }

    /** The first item of a leaf. */
    public int first(int leaf) {
        return PointTree.first(leaf, size, levels);
    }

    /** One past the last item of a leaf; a leaf holds at least one. */
    public int end(int leaf) {
        return PointTree.first(leaf + 1, size, levels);
    }

    /** The middle of a leaf's box along x, y or z: 0, 1 or 2. */
    public double middle(int leaf, int axis) {
        int place = 6 * (leaves + leaf) + axis;
        return middle(boxes, place);
    }

    /** The width of a leaf's box along x, y or z: 0, 1 or 2. */
    public double width(int leaf, int axis) {
        int place = 6 * (leaves + leaf) + axis;
        return (double) boxes[place + 3] - boxes[place];
    }

    /** The middle between the smallest coordinate at a place and the largest. */
    public static double middle(float[] boxes, int place) {
        return 0.5 * ((double) boxes[place] + boxes[place + 3]);
    }

    /** Begins the walk through the leaves that the region touches. */
    public void start(BoxWalk walk) {
        walk.open = 0;
        if (size > 0) {
            int cutting = walk.touches(boxes, 6, walk.allPlanes());
            if (cutting != BoxWalk.APART) {
                walk.nodes[0] = 1;
                walk.cutting[0] = cutting;
                walk.open = 1;
            }
        }
    }

    /** The next leaf whose box the region touches, or {@link #DONE}. */
    public int next(BoxWalk walk) {
        int open = walk.open;
        while (open > 0) {
            open--;
            int node = walk.nodes[open];
            int cutting = walk.cutting[open];
            while (cutting != BoxWalk.APART && node < leaves) {
                walk.examined++;
                node = 2 * node;
                int first = walk.touches(boxes, 6 * node, cutting);
                int second = walk.touches(boxes, 6 * node + 6, cutting);
                if (first == BoxWalk.APART) {
                    node++;
                    cutting = second;
                } else {
                    cutting = first;
                    if (second != BoxWalk.APART) {
                        walk.nodes[open] = node + 1;
                        walk.cutting[open++] = second;
                    }
                }
            }
            if (cutting != BoxWalk.APART) {
                walk.open = open;
                walk.leafCutting = cutting;
                int leaf = node - leaves;
                walk.examined += end(leaf) - first(leaf);
                return leaf;
            }
        }
        walk.open = 0;
        return DONE;
    }

    /** What a tree is built over. */
    @FunctionalInterface
    public interface Items {

        /**
         * Writes the smallest x, y and z and the largest x, y and z of the items from {@code first} to before {@code end}.
         *
         * @param place in {@code boxes} of the first of the six
         */
        void box(int leaf, int first, int end, float[] boxes, int place);
    }
}
