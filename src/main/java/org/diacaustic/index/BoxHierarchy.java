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

    /** What a ray keeps on its stack for this tree, below its open nodes: three numbers an axis. */
    private static final int FRAME = 9;

    /** Bounds the relative errors of the two ends of a slab, which are computed in floats [Ize 2013]. */
    private static final float ROUND_OUT = 1 + 0x1p-20f;

    /** Bounds the errors of origin ÷ direction in floats, relative to it. */
    private static final double FLOAT_ERROR = 0x1p-21;

    /** Bounds the errors of the origin in the frame of the tree in doubles, relative to it. */
    private static final double ORIGIN_ERROR = 0x1p-49;

    /** Stands for 1 ÷ 0: beyond every plane there is, but its product with 0 is 0. */
    private static final double LARGEST_INVERSE = 0x1p100;

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
    private final double inverseScale;
    private final double halfX;
    private final double halfY;
    private final double halfZ;
    private final Bounds bounds;

    BoxHierarchy(BoxHierarchyBuilder builder) {
        this.planes = builder.planes();
        this.children = builder.children();
        this.items = builder.items();
        this.root = builder.root();
        this.originX = builder.originX();
        this.originY = builder.originY();
        this.originZ = builder.originZ();
        this.inverseScale = 1 / builder.scale();
        this.bounds = builder.bounds();
        this.halfX = halfSize(bounds.minX(), bounds.maxX());
        this.halfY = halfSize(bounds.minY(), bounds.maxY());
        this.halfZ = halfSize(bounds.minZ(), bounds.maxZ());
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

    /** Half the extent of the tree in its own frame, rounded up. */
    private double halfSize(double min, double max) {
        return (max / 2 - min / 2) * inverseScale + 0x1p-50;
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
        ray.stackTop = base;
        if (items.length == 0) {
            return base;
        }
        ray.tests++;
        double ox = (ray.originX - originX) * inverseScale;
        double oy = (ray.originY - originY) * inverseScale;
        double oz = (ray.originZ - originZ) * inverseScale;
        double dx = ray.directionX * inverseScale;
        double dy = ray.directionY * inverseScale;
        double dz = ray.directionZ * inverseScale;
        // Distances on the stack are t · speed, of the order of the tree's own size.
        double speed = Arithmetic.powerOfTwoNear(Math.max(Math.abs(dx), Math.max(Math.abs(dy), Math.abs(dz))));
        dx /= speed;
        dy /= speed;
        dz /= speed;
        double ix = inverse(dx);
        double iy = inverse(dy);
        double iz = inverse(dz);
        double px = -ox * ix;
        double py = -oy * iy;
        double pz = -oz * iz;
        double hx = Math.abs(ix) * (halfX + Math.abs(ox) * ORIGIN_ERROR);
        double hy = Math.abs(iy) * (halfY + Math.abs(oy) * ORIGIN_ERROR);
        double hz = Math.abs(iz) * (halfZ + Math.abs(oz) * ORIGIN_ERROR);
        double entry = Math.max(px - hx, Math.max(py - hy, pz - hz)) * (1 - 0x1p-49);
        double exit = Math.min(px + hx, Math.min(py + hy, pz + hz)) * (1 + 0x1p-49);
        double departure = ray.leaving == Ray.FREE ? 0 : ray.departureError * speed;
        if (!(entry <= exit && exit >= -departure && entry <= ray.tMax * speed)) {
            return base;
        }
        // From far away, the walk begins where the ray reaches the tree, so that floats are enough from there on. What
        // lies at the start of a ray may lie a rounding error behind it.
        double skipped = entry > 0 ? entry : -departure;
        float[] frame = ray.stackDistance;
        setSlabs(frame, base - 9, ix, Math.fma(skipped, dx, ox), ox);
        setSlabs(frame, base - 6, iy, Math.fma(skipped, dy, oy), oy);
        setSlabs(frame, base - 3, iz, Math.fma(skipped, dz, oz), oz);
        ray.stackFrame[base - 2] = skipped;
        ray.stackFrame[base - 1] = speed;
        ray.stack[base] = root;
        frame[base] = 0;
        ray.stackTop = base + 1;
        return base;
    }

    private static double inverse(double direction) {
        return Math.copySign(Math.min(Math.abs(1 / direction), LARGEST_INVERSE), direction);
    }

    /**
     * A ray is at a plane p of this axis at p·inverse + offset. The offset is kept twice, lowered for near planes and
     * raised for far ones, by the rounding errors of all that it comes from.
     */
    private static void setSlabs(float[] frame, int place, double inverse, double start, double origin) {
        double offset = -start * inverse;
        double error = Math.abs(inverse) * (Math.abs(start) * FLOAT_ERROR + Math.abs(origin) * ORIGIN_ERROR);
        frame[place] = (float) inverse;
        frame[place + 1] = (float) (offset - error);
        frame[place + 2] = (float) (offset + error);
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
        float[] distance = ray.stackDistance;
        float inverseX = distance[base - 9];
        float nearX = distance[base - 8];
        float farX = distance[base - 7];
        float inverseY = distance[base - 6];
        float nearY = distance[base - 5];
        float farY = distance[base - 4];
        float inverseZ = distance[base - 3];
        float nearZ = distance[base - 2];
        float farZ = distance[base - 1];
        int lowX = inverseX < 0 ? 1 : 0;
        int lowY = inverseY < 0 ? 3 : 2;
        int lowZ = inverseZ < 0 ? 5 : 4;
        double skipped = ray.stackFrame[base - 2];
        double speed = ray.stackFrame[base - 1];
        float tMax = (float) (ray.tMax * speed * (1 + ORIGIN_ERROR) - skipped) * ROUND_OUT;
        int end = Float.floatToRawIntBits(tMax);
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
                int low1 = Math.max(
                        Math.max(0, bits(Math.fma(planes[first + lowX], inverseX, nearX))),
                        Math.max(
                                bits(Math.fma(planes[first + lowY], inverseY, nearY)),
                                bits(Math.fma(planes[first + lowZ], inverseZ, nearZ))));
                int high1 = Math.min(
                        Math.min(end, bits(Math.fma(planes[first + (lowX ^ 1)], inverseX, farX))),
                        Math.min(
                                bits(Math.fma(planes[first + (lowY ^ 1)], inverseY, farY)),
                                bits(Math.fma(planes[first + (lowZ ^ 1)], inverseZ, farZ))));
                float entry1 = Float.intBitsToFloat(low1);
                boolean entersFirst = entry1 <= Float.intBitsToFloat(high1) * ROUND_OUT;
                int low2 = Math.max(
                        Math.max(0, bits(Math.fma(planes[second + lowX], inverseX, nearX))),
                        Math.max(
                                bits(Math.fma(planes[second + lowY], inverseY, nearY)),
                                bits(Math.fma(planes[second + lowZ], inverseZ, nearZ))));
                int high2 = Math.min(
                        Math.min(end, bits(Math.fma(planes[second + (lowX ^ 1)], inverseX, farX))),
                        Math.min(
                                bits(Math.fma(planes[second + (lowY ^ 1)], inverseY, farY)),
                                bits(Math.fma(planes[second + (lowZ ^ 1)], inverseZ, farZ))));
                float entry2 = Float.intBitsToFloat(low2);
                boolean entersSecond = entry2 <= Float.intBitsToFloat(high2) * ROUND_OUT;
                if (entersFirst) {
                    int child = children[2 * node];
                    if (entersSecond) {
                        int other = children[2 * node + 1];
                        if (entry2 < entry1) {
                            stack[top] = child;
                            distance[top++] = entry1;
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

    private static int bits(float value) {
        return Float.floatToRawIntBits(value);
    }

    /** Ends a walk before it is {@link #DONE}. */
    public void leave(Ray ray, int base) {
        ray.stackTop = base - FRAME;
    }
}
