package org.diacaustic.math;

/** The real roots of a·x² − 2·b·x + c = 0, and of the usual a·x² + b·x + c. */
public final class Quadratic {
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
