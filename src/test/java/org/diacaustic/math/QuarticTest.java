package org.diacaustic.math;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.apache.commons.math3.analysis.solvers.LaguerreSolver;
import org.apache.commons.math3.complex.Complex;
import org.junit.jupiter.api.Test;

class QuarticTest {
    private final double[] roots = new double[4];

    @Test
    void solve_givenSimpleRoots_findsThemInOrder() {
        // (x + 3)(x + 1)(x − 2)(x − 5) = x⁴ − 3x³ − 15x² + 19x + 30
        assertThat(Quartic.solve(1, -3, -15, 19, 30, -10, 10, roots)).isEqualTo(4);
        assertThat(roots).containsExactly(new double[] {-3, -1, 2, 5}, within(1e-14));
    }

    @Test
    void solve_givenInterval_findsOnlyTheRootsInIt() {
        assertThat(Quartic.solve(1, -3, -15, 19, 30, 0, 3, roots)).isEqualTo(1);
        assertThat(roots[0]).isCloseTo(2, within(1e-15));
    }

    @Test
    void solve_givenVanishingLeadingCoefficients_solvesWhatRemains() {
        // 2x − 3, x² − 4, (x − 1)(x + 2)(x − 4) = x³ − 3x² − 6x + 8
        assertThat(Quartic.solve(0, 0, 0, 2, -3, -10, 10, roots)).isEqualTo(1);
        assertThat(roots[0]).isEqualTo(1.5);
        assertThat(Quartic.solve(0, 0, 1, 0, -4, -10, 10, roots)).isEqualTo(2);
        assertThat(roots[1]).isEqualTo(2);
        assertThat(Quartic.solve(0, 1, -3, -6, 8, -10, 10, roots)).isEqualTo(3);
        assertThat(roots[0]).isCloseTo(-2, within(1e-15));
        assertThat(Quartic.solve(0, 0, 0, 0, 0, -10, 10, roots)).isZero();
    }

    @Test
    void solve_givenNearlyDoubleRoots_findsPairsOrNone() {
        // (x² − 1)² − 1e-12: pairs of roots at ±√(1 ± 1e-6), 1e-6 apart.
        assertThat(Quartic.solve(1, 0, -2, 0, 1 - 1e-12, -3, 3, roots)).isEqualTo(4);
        assertThat(roots[2]).isCloseTo(Math.sqrt(1 - 1e-6), within(1e-10));
        assertThat(roots[3]).isCloseTo(Math.sqrt(1 + 1e-6), within(1e-10));
        // (x² − 1)² + 1e-12 has none.
        assertThat(Quartic.solve(1, 0, -2, 0, 1 + 1e-12, -3, 3, roots)).isZero();
    }

    @Test
    void solve_givenQuadrupleRootLoweredSlightly_findsBothSides() {
        // (x − 1)⁴ = ε has the roots 1 ± ε^¼; ε = 2⁻³² gives 1 ± 2⁻⁸.
        assertThat(Quartic.solve(1, -4, 6, -4, 1 - 0x1p-32, -3, 3, roots)).isEqualTo(2);
        assertThat(roots[0]).isCloseTo(1 - 0x1p-8, within(1e-8));
        assertThat(roots[1]).isCloseTo(1 + 0x1p-8, within(1e-8));
    }

    @Test
    void solve_givenRandomQuartics_agreesWithLaguerreAndBisection() {
        SplittableRandom random = new SplittableRandom(11);
        LaguerreSolver laguerre = new LaguerreSolver();
        int compared = 0;
        for (int i = 0; i < 2000; i++) {
            double[] c = random.doubles(5, -1, 1).toArray();
            int count = Quartic.solve(c[0], c[1], c[2], c[3], c[4], -4, 4, roots);
            double[] expected = Arrays.stream(laguerre.solveAllComplex(new double[] {c[4], c[3], c[2], c[1], c[0]}, 0))
                    .filter(z -> Math.abs(z.getImaginary()) < 1e-7 && Math.abs(z.getReal()) <= 4)
                    .mapToDouble(Complex::getReal)
                    .sorted()
                    .toArray();
            assertThat(count).as("roots of %s", Arrays.toString(c)).isEqualTo(expected.length);
            for (int k = 0; k < count; k++) {
                compared++;
                assertThat(roots[k]).isCloseTo(expected[k], within(1e-9));
                // The sign changes within a few units in the last place of the terms.
                double x = roots[k];
                double size = Math.abs(c[0] * x * x * x * x)
                        + Math.abs(c[1] * x * x * x)
                        + Math.abs(c[2] * x * x)
                        + Math.abs(c[3] * x)
                        + Math.abs(c[4]);
                double value = (((c[0] * x + c[1]) * x + c[2]) * x + c[3]) * x + c[4];
                assertThat(Math.abs(value)).isLessThan(16 * 0x1p-53 * size);
            }
        }
        assertThat(compared).isGreaterThan(2000);
    }
}
