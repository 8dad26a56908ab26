package org.diacaustic.math;

/**
 * The real roots of polynomials of degree 3 and 4 in an interval, where they change sign. Between two neighbouring roots
 * of its derivative a polynomial is monotonic and has one root or none; each is bracketed so and then closed in by
 * Newton steps that may not leave the bracket. That is slower than a formula, but it loses no root to cancellation,
 * reports none that is not there, and the number of roots always agrees with the signs at the ends.
 *
 * <p>A root that the polynomial touches without crossing it is reported twice or not at all, as rounding has it. Nothing
 * is allocated.
 */
public final class Quartic {
    private static final int MOST_STEPS = 200;

    private Quartic() {}

    /**
     * The roots of a·x⁴ + b·x³ + c·x² + d·x + e in [low, high]. Leading coefficients may vanish.
     *
     * @param roots receives them in ascending order; its length is at least 4
     * @return the number of roots
     */
    public static int solve(double a, double b, double c, double d, double e, double low, double high, double[] roots) {
        int turns = solveCubic(4 * a, 3 * b, 2 * c, d, low, high, roots);
        double first = turns > 0 ? roots[0] : high;
        double second = turns > 1 ? roots[1] : high;
        double third = turns > 2 ? roots[2] : high;
        int count = close(a, b, c, d, e, low, first, roots, 0);
        if (turns > 0) {
            count = close(a, b, c, d, e, first, second, roots, count);
        }
        if (turns > 1) {
            count = close(a, b, c, d, e, second, third, roots, count);
        }
        if (turns > 2) {
            count = close(a, b, c, d, e, third, high, roots, count);
        }
        return count;
    }

    /**
     * The roots of a·x³ + b·x² + c·x + d in [low, high]. Leading coefficients may vanish.
     *
     * @param roots receives them in ascending order; its length is at least 3
     * @return the number of roots
     */
    public static int solveCubic(double a, double b, double c, double d, double low, double high, double[] roots) {
        int turns = Quadratic.solve(3 * a, 2 * b, c, roots);
        double first = turns > 0 ? Arithmetic.clamp(roots[0], low, high) : high;
        double second = turns > 1 ? Arithmetic.clamp(roots[1], low, high) : high;
        int count = close(0, a, b, c, d, low, first, roots, 0);
        if (turns > 0) {
            count = close(0, a, b, c, d, first, second, roots, count);
        }
        if (turns > 1) {
            count = close(0, a, b, c, d, second, high, roots, count);
        }
        return count;
    }

    /** Adds the root between low and high, if the signs there differ. Zero counts as positive. */
    private static int close(
            double a, double b, double c, double d, double e, double low, double high, double[] roots, int count) {
        boolean positiveLow = value(a, b, c, d, e, low) >= 0;
        boolean positiveHigh = value(a, b, c, d, e, high) >= 0;
        if (!(low < high) || positiveLow == positiveHigh) {
            return count;
        }
        double from = low;
        double to = high;
        double x = from + (to - from) / 2;
        double lastStep = to - from;
        for (int step = 0; step < MOST_STEPS; step++) {
            double y = value(a, b, c, d, e, x);
            if (y >= 0 == positiveLow) {
                from = x;
            } else {
                to = x;
            }
            double slope = Math.fma(Math.fma(Math.fma(4 * a, x, 3 * b), x, 2 * c), x, d);
            double newton = x - y / slope;
            if (y == 0 || newton == x) {
                break;
            }
            // A Newton step that leaves the bracket, or that shrinks too slowly, is replaced by halving it.
            boolean trusted = newton > from && newton < to && Math.abs(newton - x) <= lastStep / 2;
            double next = trusted ? newton : from + (to - from) / 2;
            if (next <= from || next >= to) {
                break;
            }
            lastStep = Math.abs(next - x);
            x = next;
        }
        roots[count] = x;
        return count + 1;
    }

    private static double value(double a, double b, double c, double d, double e, double x) {
        return Math.fma(Math.fma(Math.fma(Math.fma(a, x, b), x, c), x, d), x, e);
    }
}
