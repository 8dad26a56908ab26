package org.diacaustic.index;

import org.diacaustic.parallel.Workers;

/**
 * A balanced kd-tree over n points in single precision. The points are brought into an order in which every leaf is one
 * range of them, and the tree hands out the leaves that a ball touches, nearest boxes first; the points in them are the
 * caller's to look at:
 *
 * <pre>{@code
 * tree.start(walk, x, y, z, radiusSquared);
 * for (int leaf = tree.next(walk); leaf != PointTree.DONE; leaf = tree.next(walk)) {
 *     int end = tree.end(leaf);
 *     for (int i = tree.first(leaf); i < end; i++) {
 *         ask(i);   // may shrink walk.radiusSquared, as a search for the k nearest does
 *     }
 * }
 * }</pre>
 *
 * <p>Balls are closed: a point belongs to one if its squared distance, computed in floats as (dx² + dy²) + dz², is at
 * most {@code radiusSquared}. No such point is missed, for boxes are asked in the same arithmetic, which is monotonic. A
 * radius may be 0 or infinite.
 *
 * <p>Every range is halved at its median along the widest side of its box, equal coordinates in the order of the
 * points' numbers, so neither equal nor collinear points make the tree deeper. The tree keeps the box of every node, 24
 * bytes. Nothing is allocated by a walk. Immutable, and safe for many threads.
 */
public final class PointTree {
    /** What {@link #next} returns when no leaf is left. No leaf is negative. */
    public static final int DONE = -1;

    /** The largest number of points in a leaf; leaves of a tree that has several hold at least half as many. */
    public static final int LARGEST_LEAF = 32;

    /** No path from the root is longer. */
    static final int LARGEST_DEPTH = 32;

    private final int size;
    private final int levels;

    /** The number of leaves, a power of two. Node 1 is the root, the children of node i are 2i and 2i + 1. */
    private final int leaves;

    /** Six planes a node: smallest and largest x, y, z of its points. */
    private final float[] boxes;

    PointTree(PointTreeBuilder builder) {
        this.size = builder.size();
        this.levels = builder.levels();
        this.leaves = 1 << levels;
        this.boxes = builder.boxes();
    }

    /**
     * Builds the tree. All four arrays are brought into the tree's order; the coordinates must not change afterwards. The
     * same points and numbers give the same order and tree for any number of threads, unless the workers are stopped,
     * which leaves both unfinished.
     *
     * @param numbers one for each point, all different, n in all: equal coordinates are kept in their order. If they
     *     are the points' places before, they tell afterwards where each point came from
     * @throws IllegalArgumentException if a coordinate is not finite, or there are fewer coordinates than numbers
     */
    public static PointTree over(float[] x, float[] y, float[] z, int[] numbers, Workers workers) {
        return new PointTree(new PointTreeBuilder(x, y, z, null, numbers, LARGEST_LEAF).build(workers));
    }

    /** The number of points. */
    public int size() {
        return size;
    }

    /** The number of nodes on a path from the root to a leaf, which is the same for all. */
    public int depth() {
        return size == 0 ? 0 : levels + 1;
    }

    /** The memory that the tree takes, without the points. */
    public long bytes() {
        return 4L * boxes.length;
    }

    /** The number of leaves, a power of two; 0 if there are no points. */
    public int leafCount() {
        return size == 0 ? 0 : leaves;
    }

    /** The first point of a leaf. */
    public int first(int leaf) {
        return first(leaf, size, levels);
    }

    /** One past the last point of a leaf; a leaf holds at least one. */
    public int end(int leaf) {
        return first(leaf + 1, size, levels);
    }

    /** Where leaf i of 2^levels begins, if they share n points as evenly as can be. */
    static int first(int leaf, int size, int levels) {
        return (int) ((long) leaf * size >>> levels);
    }

    /**
     * Begins the walk through the leaves that a ball touches.
     *
     * @throws IllegalArgumentException if the centre or the radius is not a number
     */
    public void start(PointWalk walk, float x, float y, float z, float radiusSquared) {
        if (Float.isNaN(x) || Float.isNaN(y) || Float.isNaN(z) || !(radiusSquared >= 0)) {
            throw new IllegalArgumentException(
                    "no ball: [" + x + ", " + y + ", " + z + "], squared radius " + radiusSquared);
        }
        walk.x = x;
        walk.y = y;
        walk.z = z;
        walk.radiusSquared = radiusSquared;
        walk.open = 0;
        if (size > 0) {
            walk.nodes[0] = 1;
            walk.distancesSquared[0] = distanceSquared(6, x, y, z);
            walk.open = 1;
        }
    }

    /** The next leaf whose box the ball touches, or {@link #DONE}. */
    public int next(PointWalk walk) {
        int[] nodes = walk.nodes;
        float[] distances = walk.distancesSquared;
        float x = walk.x;
        float y = walk.y;
        float z = walk.z;
        float radiusSquared = walk.radiusSquared;
        int open = walk.open;
        while (open > 0) {
            open--;
            int node = nodes[open];
            float nearest = distances[open];
            while (nearest <= radiusSquared && node < leaves) {
                walk.examined++;
                int first = 2 * node;
                float toFirst = distanceSquared(6 * first, x, y, z);
                float toSecond = distanceSquared(6 * first + 6, x, y, z);
                boolean firstIsNearer = toFirst <= toSecond;
                float farther = firstIsNearer ? toSecond : toFirst;
                nearest = firstIsNearer ? toFirst : toSecond;
                node = firstIsNearer ? first : first + 1;
                if (farther <= radiusSquared) {
                    nodes[open] = node ^ 1;
                    distances[open++] = farther;
                }
            }
            if (nearest <= radiusSquared) {
                walk.open = open;
                int leaf = node - leaves;
                walk.examined += end(leaf) - first(leaf);
                return leaf;
            }
        }
        walk.open = 0;
        return DONE;
    }

    /** The squared distance of a point from the box whose planes begin at a place. */
    private float distanceSquared(int place, float x, float y, float z) {
        float dx = Math.max(Math.max(boxes[place] - x, x - boxes[place + 1]), 0);
        float dy = Math.max(Math.max(boxes[place + 2] - y, y - boxes[place + 3]), 0);
        float dz = Math.max(Math.max(boxes[place + 4] - z, z - boxes[place + 5]), 0);
        return dx * dx + dy * dy + dz * dz;
    }
}
