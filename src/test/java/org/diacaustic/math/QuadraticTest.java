package org.diacaustic.math;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class QuadraticTest {
    private final double[] roots = new double[2];

    @Test
    void solve_givenKahansCoefficients_separatesTheRoots() {
        // The roots are 1 and 1.000000028975958351…; the plain formula gives one double root between them.
        assertThat(Quadratic.solve(94906265.625, -189812534.0, 94906268.375, roots))
                .isEqualTo(2);
        assertThat(roots[0]).isCloseTo(1, within(1e-15));
        assertThat(roots[1]).isCloseTo(1.000000028975958351, within(1e-15));
    }

    @Test
    void solve_givenRootsFarApart_keepsTheDigitsOfTheSmallOne() {
        assertThat(Quadratic.solve(1, -1e8, 1, roots)).isEqualTo(2);
        assertThat(roots[0]).isCloseTo(1.0000000000000001e-8, within(4e-24));
        assertThat(roots[1]).isCloseTo(99999999.99999999, within(4e-8));
    }

    @Test
    void solve_givenTinyLeadingCoefficient_keepsTheFiniteRoot() {
        assertThat(Quadratic.solve(1e-20, 2, -3, roots)).isEqualTo(2);
        assertThat(roots[0]).isCloseTo(-2.000000000000000109708457e20, within(7e5));
        assertThat(roots[1]).isCloseTo(1.5, within(1e-15));
    }

    @Test
    void solve_givenNoQuadraticTerm_hasOneRoot() {
        assertThat(Quadratic.solve(0, 2, -3, roots)).isEqualTo(1);
        assertThat(roots[0]).isEqualTo(1.5);
    }

    @Test
    void solve_givenNoLinearTerm_hasOppositeRoots() {
        assertThat(Quadratic.solve(1, 0, -4, roots)).isEqualTo(2);
        assertThat(roots).containsExactly(-2, 2);
    }

    @Test
    void solve_givenDiscriminantBelowZeroByRounding_hasNone() {
        // (x + 1)² + 2.2e-16 is positive everywhere.
        assertThat(Quadratic.solve(1, 2, 1.0000000000000002, roots)).isZero();
    }

    @Test
    void solve_givenNothingToSolve_hasNone() {
        assertThat(Quadratic.solve(0, 0, 1, roots)).isZero();
        assertThat(Quadratic.solve(0, 0, 0, roots)).isZero();
        assertThat(Quadratic.solve(1, Double.NaN, 0, roots)).isZero();
    }

    @Test
    void solve_givenCoefficientsOfAnySize_neitherLosesNorInventsRoots() {
        // (x − 2)(x + 3) times anything; the products of the coefficients leave the range of doubles.
        for (double scale : new double[] {0x1p-1000, 0x1p-600, 0x1p600, 0x1p1000}) {
            assertThat(Quadratic.solve(scale, scale, -6 * scale, roots)).isEqualTo(2);
            assertThat(roots).containsExactly(-3, 2);
            assertThat(Quadratic.solve(scale, 0, scale, roots)).isZero();
        }
    }
}
