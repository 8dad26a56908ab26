package org.diacaustic.index;

import org.diacaustic.math.Arithmetic;
import org.diacaustic.math.Bounds;
import org.diacaustic.math.Ray;

/**
 * A binary tree of axis-aligned boxes over n items, which are known by their boxes only. It hands out, nearest boxes
 * first, the leaves whose boxes a ray enters; what lies in them is the caller's to ask:
 *
 * <pre>{@code
 * int base = tree.enter(ray);
 * for (int leaf = tree.next(ray, base); leaf != BoxHierarchy.DONE; leaf = tree.next(ray, base)) {
 *     int end = BoxHierarchy.end(leaf);
 *     for (int position = BoxHierarchy.first(leaf); position < end; position++) {
 *         ask(tree.item(position));   // shortens ray.tMax where it is hit
 *     }
 * }
 * }</pre>
 *
 * A caller that stops before {@link #DONE} must {@link #leave}. Between two leaves the ray may go through other
 * hierarchies: each keeps its open nodes in the ray's stack, above those of the one outside it. Nothing is allocated.
 *
 * <p>Planes are floats, rounded outward, in a frame of the tree's own: relative to the centre of all boxes, in units of
 * a power of two that holds them. So a tree far from the origin keeps its digits, and a tree of any size is the same
 * tree. Immutable, and safe for many threads.
 */
public final class BoxHierarchy {
    /** What {@link #next} returns when no leaf is left. No leaf is negative. */
    public static final int DONE = -1;

    /** The largest number of items in a leaf. */
    public static final int LARGEST_LEAF = 1 << BoxHierarchyBuilder.COUNT_BITS;

    /** What a ray keeps on its stack for this tree, below its open nodes: three numbers an axis and the start. */
    private static final int FRAME = 10;

    /** Bounds the relative error of a slab's far end, and of the near end that it is compared with [Ize 2013]. */
    private static final double ROUND_OUT = 1 + 2 * Arithmetic.gamma(4);

    /** Bounds the relative error of origin ÷ direction in the tree's frame. */
    private static final double ORIGIN_ERROR = Arithmetic.gamma(4);

    /** Stands for 1 ÷ 0: infinite for every plane there is, but its product with 0 is 0. */
    private static final double LARGEST_INVERSE = 0x1p900;

    private static final int NO_CHILD = Integer.MIN_VALUE;

    /** Two boxes of six planes a node: low and high x of the first child, y, z, then the second child's. */
    private final float[] planes;

    /** Two children a node: the number of a node, or ~leaf. */
    private final int[] children;

    private final int[] items;
    private final int root;
    private final double originX;
    private final double originY;
    private final double originZ;
    private final double scale;
    private final Bounds bounds;

    BoxHierarchy(BoxHierarchyBuilder builder) {
        this.planes = builder.planes();
        this.children = builder.children();
        this.items = builder.items();
        this.root = builder.root();
        this.originX = builder.originX();
        this.originY = builder.originY();
        this.originZ = builder.originZ();
        this.scale = builder.scale();
        this.bounds = builder.bounds();
    }

    /**
     * Builds the tree of n boxes by the binned surface area heuristic [Wald 2007]. The same boxes give the same tree.
     *
     * @param boxes 6·n numbers: smallest x, y, z and largest x, y, z of each item; read only while building
     * @throws IllegalArgumentException if a box is empty or not finite, or the length is not a multiple of 6
     */
    public static BoxHierarchy over(double[] boxes) {
        return new BoxHierarchy(new BoxHierarchyBuilder(boxes).build());
    }

    /** The number of items. */
    public int size() {
        return items.length;
    }

    /** The box around all items; {@link Bounds#EMPTY} if there are none. */
    public Bounds bounds() {
        return bounds;
    }

    /** The item at a position of the tree's own order, in which every leaf is one range. */
    public int item(int position) {
        return items[position];
    }

    /** The first position of a leaf. */
    public static int first(int leaf) {
        return leaf >>> BoxHierarchyBuilder.COUNT_BITS;
    }

    /** One past the last position of a leaf; a leaf holds at least one item. */
    public static int end(int leaf) {
        return first(leaf) + (leaf & LARGEST_LEAF - 1) + 1;
    }

    /**
     * Begins the walk of the ray from its origin to {@code ray.tMax}, which may shorten meanwhile.
     *
     * @return the place on the ray's stack that {@link #next} must be given
     */
    public int enter(Ray ray) {
        ray.reserveStack(FRAME + BoxHierarchyBuilder.LARGEST_DEPTH + 1);
        int base = ray.stackTop + FRAME;
        double[] frame = ray.stackDistance;
        setSlabs(frame, base - 10, (ray.originX - originX) / scale, ray.directionX);
        setSlabs(frame, base - 7, (ray.originY - originY) / scale, ray.directionY);
        setSlabs(frame, base - 4, (ray.originZ - originZ) / scale, ray.directionZ);
        // What lies at the start may lie a rounding error behind it.
        double start = ray.leaving == Ray.FREE ? 0 : -ray.departureError;
        frame[base - 1] = start;
        ray.stackTop = base;
        if (items.length > 0) {
            ray.stack[base] = root;
            frame[base] = start;
            ray.stackTop = base + 1;
        }
        return base;
    }

    /**
     * A ray is at a plane p of this axis at t = p·inverse + offset. The offset is kept twice, lowered for near planes and
     * raised for far ones, by the rounding of the origin.
     */
    private void setSlabs(double[] frame, int place, double origin, double direction) {
        double limit = LARGEST_INVERSE;
        double inverse = Math.copySign(Math.min(Math.abs(1 / (direction / scale)), limit), direction);
        double offset = -origin * inverse;
        double error = Math.abs(offset) * ORIGIN_ERROR;
        frame[place] = inverse;
        frame[place + 1] = offset - error;
        frame[place + 2] = offset + error;
    }

    /**
     * Goes on to the next leaf that the ray enters before {@code ray.tMax}.
     *
     * @param base what {@link #enter} returned for this ray
     * @return a leaf for {@link #first} and {@link #end}, or {@link #DONE}, after which the ray has left the tree
     */
    public int next(Ray ray, int base) {
        float[] planes = this.planes;
        int[] children = this.children;
        int[] stack = ray.stack;
        double[] distance = ray.stackDistance;
        double inverseX = distance[base - 10];
        double nearX = distance[base - 9];
        double farX = distance[base - 8];
        double inverseY = distance[base - 7];
        double nearY = distance[base - 6];
        double farY = distance[base - 5];
        double inverseZ = distance[base - 4];
        double nearZ = distance[base - 3];
        double farZ = distance[base - 2];
        double start = distance[base - 1];
        int lowX = inverseX < 0 ? 1 : 0;
        int lowY = inverseY < 0 ? 3 : 2;
        int lowZ = inverseZ < 0 ? 5 : 4;
        double tMax = ray.tMax * ROUND_OUT;
        int top = ray.stackTop;
        int nodes = 0;
        while (top > base) {
            top--;
            if (distance[top] > tMax) {
                continue;
            }
            int node = stack[top];
            while (node >= 0) {
                nodes++;
                int first = 12 * node;
                int second = first + 6;
                double entry = start;
                double exit = tMax;
                double t = Math.fma(planes[first + lowX], inverseX, nearX);
                entry = t > entry ? t : entry;
                t = Math.fma(planes[first + lowY], inverseY, nearY);
                entry = t > entry ? t : entry;
                t = Math.fma(planes[first + lowZ], inverseZ, nearZ);
                entry = t > entry ? t : entry;
                t = Math.fma(planes[first + (lowX ^ 1)], inverseX, farX) * ROUND_OUT;
                exit = t < exit ? t : exit;
                t = Math.fma(planes[first + (lowY ^ 1)], inverseY, farY) * ROUND_OUT;
                exit = t < exit ? t : exit;
                t = Math.fma(planes[first + (lowZ ^ 1)], inverseZ, farZ) * ROUND_OUT;
                exit = t < exit ? t : exit;
                boolean entersFirst = entry <= exit;

                double entry2 = start;
                double exit2 = tMax;
                t = Math.fma(planes[second + lowX], inverseX, nearX);
                entry2 = t > entry2 ? t : entry2;
                t = Math.fma(planes[second + lowY], inverseY, nearY);
                entry2 = t > entry2 ? t : entry2;
                t = Math.fma(planes[second + lowZ], inverseZ, nearZ);
                entry2 = t > entry2 ? t : entry2;
                t = Math.fma(planes[second + (lowX ^ 1)], inverseX, farX) * ROUND_OUT;
                exit2 = t < exit2 ? t : exit2;
                t = Math.fma(planes[second + (lowY ^ 1)], inverseY, farY) * ROUND_OUT;
                exit2 = t < exit2 ? t : exit2;
                t = Math.fma(planes[second + (lowZ ^ 1)], inverseZ, farZ) * ROUND_OUT;
                exit2 = t < exit2 ? t : exit2;
                boolean entersSecond = entry2 <= exit2;

                if (entersFirst) {
                    int child = children[2 * node];
                    if (entersSecond) {
                        int other = children[2 * node + 1];
                        if (entry2 < entry) {
                            stack[top] = child;
                            distance[top++] = entry;
                            node = other;
                        } else {
                            stack[top] = other;
                            distance[top++] = entry2;
                            node = child;
                        }
                    } else {
                        node = child;
                    }
                } else {
                    node = entersSecond ? children[2 * node + 1] : NO_CHILD;
                }
            }
            if (node != NO_CHILD) {
                ray.tests += 2L * nodes;
                ray.stackTop = top;
                return ~node;
            }
        }
        ray.tests += 2L * nodes;
        leave(ray, base);
        return DONE;
    }

    /** Ends a walk before it is {@link #DONE}. */
    public void leave(Ray ray, int base) {
        ray.stackTop = base - FRAME;
    }
}
