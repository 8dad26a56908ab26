package org.diacaustic.shape;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import org.diacaustic.math.Arithmetic;
import org.diacaustic.math.Bounds;
import org.diacaustic.math.Ray;

/**
 * Two closed shapes as one: both together, what they have in common, or the first without the second [Roth 1982, "Ray
 * Casting for Modeling Solids"]. A ray is followed through both, boundary by boundary, up to the first at which it goes into
 * the combination or out of it. Boundaries of the two that lie in one place, within the errors of their points, are
 * crossed at once: so faces that coincide leave no slivers.
 *
 * <p>The primitives are those of both shapes in turn: 2·i of the first, 2·i + 1 of the second. Each part of the surface has the
 * map of the shape that it comes from.
 */
public final class Combination implements Shape {
    /** Combinations within combinations, one number of a primitive for each of theirs. */
    private static final int DEEPEST = 12;

    private final Kind kind;
    private final Shape first;
    private final Shape second;
    private final Bounds bounds;
    private final int depth;

    /** What is made of two shapes. */
    public enum Kind {
        /** What lies in either. */
        UNION {
            @Override
            boolean holds(boolean inFirst, boolean inSecond) {
                return inFirst || inSecond;
            }

            @Override
            Bounds bounds(Bounds first, Bounds second) {
                return first.union(second);
            }
        },
        /** What lies in both. */
        INTERSECTION {
            @Override
            boolean holds(boolean inFirst, boolean inSecond) {
                return inFirst && inSecond;
            }

            @Override
            Bounds bounds(Bounds first, Bounds second) {
                return first.intersection(second);
            }
        },
        /** What lies in the first and not in the second. */
        DIFFERENCE {
            @Override
            boolean holds(boolean inFirst, boolean inSecond) {
                return inFirst && !inSecond;
            }

            @Override
            Bounds bounds(Bounds first, Bounds second) {
                return first;
            }
        };

        /** Whether a point belongs to the combination. */
        abstract boolean holds(boolean inFirst, boolean inSecond);

        abstract Bounds bounds(Bounds first, Bounds second);

        /**
         * The stretches of a line that lie in a combination. Stretches that touch become one, and what has no length is left
         * out.
         *
         * @param inFirst beginning and end of each stretch in the first shape, in order; ends may be infinite
         * @param inSecond the same for the second
         * @return the same for the combination
         */
        public double[] intervals(double[] inFirst, double[] inSecond) {
            double[] ends = new double[inFirst.length + inSecond.length + 2];
            int count = 0;
            CombinationWalk<ListedBoundaries> walk =
                    new CombinationWalk<>(new ListedBoundaries(inFirst), new ListedBoundaries(inSecond));
            if (walk.isInside(this)) {
                ends[count++] = Double.NEGATIVE_INFINITY;
            }
            while (walk.seek(this, Double.POSITIVE_INFINITY)) {
                ends[count++] = walk.met().t;
                walk.cross();
            }
            if (count % 2 != 0) {
                ends[count++] = Double.POSITIVE_INFINITY;
            }
            return Arrays.copyOf(ends, count);
        }
    }

    /**
     * Combines two shapes.
     *
     * @throws IllegalArgumentException if one is not closed or has no end, if an intersection would be empty, or too many
     *     combinations are within each other
     */
    public Combination(Kind kind, Shape first, Shape second) {
        String name = kind.name().toLowerCase(Locale.ROOT);
        if (!isSolid(first) || !isSolid(second)) {
            throw new IllegalArgumentException(
                    "shapes of a combination must be closed and have an end, but those of a " + name + " are not");
        }
        this.kind = kind;
        this.first = first;
        this.second = second;
        this.depth = 1 + Math.max(depth(first), depth(second));
        if (depth > DEEPEST) {
            throw new IllegalArgumentException("more than " + DEEPEST + " combinations are within each other");
        }
        Bounds common = kind.bounds(first.bounds(), second.bounds());
        if (common.isEmpty()) {
            throw new IllegalArgumentException("shapes of an intersection must overlap");
        }
        this.bounds = widened(common);
    }

    /**
     * Combines any number of shapes: a difference is the first without all others.
     *
     * @throws IllegalArgumentException if there are none, or as for two
     */
    public static Shape of(Kind kind, List<Shape> shapes) {
        if (shapes.isEmpty()) {
            throw new IllegalArgumentException("a combination needs shapes, but has none");
        }
        if (shapes.size() == 1) {
            return shapes.get(0);
        }
        if (kind == Kind.DIFFERENCE) {
            return new Combination(kind, shapes.get(0), of(Kind.UNION, shapes.subList(1, shapes.size())));
        }
        // By halves, so that many shapes are not many combinations deep.
        int half = shapes.size() / 2;
        return new Combination(kind, of(kind, shapes.subList(0, half)), of(kind, shapes.subList(half, shapes.size())));
    }

    private static boolean isSolid(Shape shape) {
        return shape.isClosed() && shape.bounds().isFinite();
    }

    private static int depth(Shape shape) {
        if (shape instanceof Transformed moved) {
            return depth(moved.shape());
        }
        return shape instanceof Combination combination ? combination.depth : 0;
    }

    /** By the rounding of points of one shape that are told from the other's. */
    private static Bounds widened(Bounds box) {
        double largest = Math.max(
                Math.max(
                        Math.max(Math.abs(box.minX()), Math.abs(box.maxX())),
                        Math.max(Math.abs(box.minY()), Math.abs(box.maxY()))),
                Math.max(Math.abs(box.minZ()), Math.abs(box.maxZ())));
        double rounding = Arithmetic.gamma(64) * largest;
        return new Bounds(
                box.minX() - rounding,
                box.minY() - rounding,
                box.minZ() - rounding,
                box.maxX() + rounding,
                box.maxY() + rounding,
                box.maxZ() + rounding);
    }

    public Kind kind() {
        return kind;
    }

    public Shape first() {
        return first;
    }

    public Shape second() {
        return second;
    }

    @Override
    public Bounds bounds() {
        return bounds;
    }

    @Override
    public boolean intersect(Ray ray) {
        ray.tests++;
        if (!bounds.isHitBy(ray)) {
            return false;
        }
        CombinationWalk<ShapeBoundaries> walk = walk(ray);
        walk.first().start(first, ray, leaving(ray, 0));
        boolean misses = walk.first().isAtEnd() && kind != Kind.UNION;
        if (!misses) {
            walk.second().start(second, ray, leaving(ray, 1));
            depart(ray, walk);
        }
        boolean found = !misses && walk.seek(kind, ray.tMax);
        ray.tests += walk.first().tests() + (misses ? 0 : walk.second().tests());
        if (found) {
            ShapeBoundaries met = walk.met();
            ray.hit(met.t, met.primitive << 1 | (met == walk.second() ? 1 : 0));
            ray.hitU = met.noteU;
            ray.hitV = met.noteV;
        }
        return found;
    }

    @SuppressWarnings("unchecked")
    private static CombinationWalk<ShapeBoundaries> walk(Ray ray) {
        if (!CombinationWalk.class.isInstance(ray.scratch)) {
            ray.scratch = new CombinationWalk<>(new ShapeBoundaries(), new ShapeBoundaries());
        }
        return (CombinationWalk<ShapeBoundaries>) ray.scratch;
    }

    private static int leaving(Ray ray, int operand) {
        return ray.leaving != Ray.FREE && (ray.leaving & 1) == operand ? ray.leaving >> 1 : Ray.FREE;
    }

    /**
     * Gets a ray that leaves the surface off a boundary of the other shape that lies where it starts. On which side of that
     * rounding has put the start does not matter: whether the ray goes into the combination or away from it, it does
     * where it leaves.
     */
    private void depart(Ray ray, CombinationWalk<ShapeBoundaries> walk) {
        if (ray.leaving == Ray.FREE) {
            return;
        }
        boolean leavesSecond = (ray.leaving & 1) != 0;
        ShapeBoundaries own = leavesSecond ? walk.second() : walk.first();
        ShapeBoundaries other = leavesSecond ? walk.first() : walk.second();
        boolean goesIn = own.inside != isTurned(ray.leaving);
        if (walk.isInside(kind) != goesIn && other.t <= 2 * (ray.departureError + other.error)) {
            other.advance();
        }
    }

    /** Whether the surface of the combination faces the other way than that of the shape it is taken from. */
    private boolean isTurned(int primitive) {
        return kind == Kind.DIFFERENCE && (primitive & 1) != 0;
    }

    private Shape operand(int primitive) {
        return (primitive & 1) == 0 ? first : second;
    }

    @Override
    public void complete(Ray ray, Hit hit) {
        int primitive = hit.primitive;
        hit.primitive = primitive >> 1;
        operand(primitive).complete(ray, hit);
        hit.primitive = primitive;
        if (isTurned(primitive)) {
            hit.turnNormals();
        }
    }

    @Override
    public void inverseMap(Hit hit) {
        int primitive = hit.primitive;
        boolean turned = isTurned(primitive);
        if (turned) {
            hit.turnNormals();
        }
        hit.primitive = primitive >> 1;
        operand(primitive).inverseMap(hit);
        hit.primitive = primitive;
        if (turned) {
            hit.turnNormals();
        }
    }

    @Override
    public int piece(Hit hit) {
        int primitive = hit.primitive;
        hit.primitive = primitive >> 1;
        int piece = operand(primitive).piece(hit);
        hit.primitive = primitive;
        return piece << 1 | (primitive & 1);
    }

    @Override
    public boolean isClosed() {
        return true;
    }
}
