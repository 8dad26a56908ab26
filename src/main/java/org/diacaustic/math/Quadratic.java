package org.diacaustic.math;

/** The real roots of a·x² − 2·b·x + c = 0, and of the usual a·x² + b·x + c. */
public final class Quadratic {
    /** Discriminants that are smaller or larger may have lost digits to the range of doubles. */
    private static final double SMALLEST = 0x1p-900;

    private static final double LARGEST = 0x1p1000;

    private Quadratic() {}

    /**
     * Solves a·t² − 2·b·t + c = 0, the form in which rays meet quadrics: b is then −(half the linear coefficient). The
     * discriminant is a difference of products without cancellation, and no root is computed by subtracting nearly
     * equal numbers [Kahan 2004].
     *
     * @param roots receives the roots in ascending order: {@code roots[0]}, {@code roots[1]}
     * @return the number of real roots, 0, 1 (a = 0) or 2 (a double root counts twice); 0 too if all coefficients
     *     vanish or one is not a number
     */
    public static int solveHalf(double a, double b, double c, double[] roots) {
        if (a == 0) {
            if (b == 0) {
                return 0;
            }
            roots[0] = c / (2 * b);
            return Double.isNaN(roots[0]) ? 0 : 1;
        }
        double discriminant = Arithmetic.differenceOfProducts(b, b, a, c);
        if (!(Math.abs(discriminant) > SMALLEST && Math.abs(discriminant) < LARGEST)) {
            return solveScaled(a, b, c, roots);
        }
        return solve(a, b, c, discriminant, roots);
    }

    /** The same where a product may have left the range of doubles: all coefficients and the unknown in units of powers of two. */
    private static int solveScaled(double a, double b, double c, double[] roots) {
        if (!(Double.isFinite(a) && Double.isFinite(b) && Double.isFinite(c))) {
            return 0;
        }
        // With x = u·y, where u² is about |c ÷ a|, a·u² and c are alike; then b, the larger or the smaller, decides.
        int exponentA = Math.getExponent(a);
        int exponentC = c == 0 ? 2 * Math.getExponent(b) - exponentA : Math.getExponent(c);
        int half = (exponentC - exponentA) / 2;
        int common = Math.max(exponentC, Math.getExponent(b) + half);
        double scaledA = Math.scalb(Math.scalb(a, half), half - common);
        double scaledB = Math.scalb(b, half - common);
        double scaledC = Math.scalb(c, -common);
        double discriminant = Arithmetic.differenceOfProducts(scaledB, scaledB, scaledA, scaledC);
        int count = scaledA == 0 ? 0 : solve(scaledA, scaledB, scaledC, discriminant, roots);
        for (int i = 0; i < count; i++) {
            roots[i] = Math.scalb(roots[i], half);
        }
        return count;
    }

    private static int solve(double a, double b, double c, double discriminant, double[] roots) {
        if (!(discriminant >= 0)) {
            return 0;
        }
        double q = b + Math.copySign(Math.sqrt(discriminant), b);
        double first = q / a;
        double second = q == 0 ? first : c / q;
        roots[0] = Math.min(first, second);
        roots[1] = Math.max(first, second);
        return 2;
    }

    /** Solves a·x² + b·x + c = 0; otherwise as {@link #solveHalf}. */
    public static int solve(double a, double b, double c, double[] roots) {
        return solveHalf(a, -b / 2, c, roots);
    }
}
