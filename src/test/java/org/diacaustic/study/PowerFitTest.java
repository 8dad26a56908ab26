package org.diacaustic.study;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.DoubleUnaryOperator;
import org.apache.commons.math3.random.RandomGenerator;
import org.apache.commons.math3.random.Well19937c;
import org.junit.jupiter.api.Test;

class PowerFitTest {
    private static final int TRIALS = 1000;

    @Test
    void of_givenFewerThanTwoDifferentX_hasNoPower() {
        assertThat(PowerFit.of(new double[0], new double[0]).power()).isNaN();
        assertThat(PowerFit.of(new double[] {2}, new double[] {1}).power()).isNaN();
        PowerFit same = PowerFit.of(new double[] {2, 2, 2}, new double[] {1, 2, 3});
        assertThat(same.power()).isNaN();
        assertThat(same.interval()).isEqualTo(Interval.UNKNOWN);
    }

    @Test
    void of_givenTwoPoints_hasAPowerAndNoInterval() {
        PowerFit fit = PowerFit.of(new double[] {1, 100}, new double[] {5, 0.5});
        assertThat(fit.power()).isCloseTo(-0.5, within(1e-12));
        assertThat(fit.interval()).isEqualTo(Interval.UNKNOWN);
        assertThat(fit.decades()).isCloseTo(2, within(1e-12));
    }

    @Test
    void of_givenWhatHasNoLogarithm_leavesItOut() {
        double[] x = {1, 10, 100, 1000, 10_000, 0, 10, Double.NaN};
        double[] y = {8, 4, 2, 1, 0, 5, Double.POSITIVE_INFINITY, 1};
        PowerFit fit = PowerFit.of(x, y);
        assertThat(fit.points()).isEqualTo(4);
        assertThat(fit.decades()).isCloseTo(3, within(1e-12));
        assertThat(fit.power()).isCloseTo(-Math.log10(2), within(1e-12));
        assertThat(fit.interval().high() - fit.interval().low()).isLessThan(1e-6);
    }

    @Test
    void of_givenPointsOffTheLine_hasStudentsInterval() {
        // Logarithms to base 10: y = 0, 0.3, 0 at x = 0, 1, 2: slope 0; residuals −0.1, 0.2, −0.1; s² = 0.06 ÷ 1, and
        // the slope's standard error √(0.06 ÷ 2); Student's quantile for one degree of freedom is 12.7062.
        PowerFit fit = PowerFit.of(new double[] {1, 10, 100}, new double[] {1, Math.pow(10, 0.3), 1});
        assertThat(fit.power()).isCloseTo(0, within(1e-12));
        assertThat(fit.interval().high()).isCloseTo(12.7062 * Math.sqrt(0.03), within(1e-4));
        assertThat(fit.interval().low()).isCloseTo(-12.7062 * Math.sqrt(0.03), within(1e-4));
    }

    @Test
    void of_givenNoisyPowers_containsTheTruthAsOftenAsItSays() {
        RandomGenerator random = new Well19937c(8);
        double[] x = {1e3, 1e4, 1e5, 1e6};
        int hits = 0;
        for (int trial = 0; trial < TRIALS; trial++) {
            double[] y = Arrays.stream(x)
                    .map(n -> Math.pow(n, -2.0 / 3) * Math.exp(0.1 * random.nextGaussian()))
                    .toArray();
            hits += PowerFit.of(x, y).interval().contains(-2.0 / 3) ? 1 : 0;
        }
        // 95 %, and three times the 0.7 % of chance.
        assertThat(hits / (double) TRIALS).isBetween(0.93, 0.97);
    }

    @Test
    void ofGroups_givenNoisyPowers_containsTheTruthAsOftenAsItSays() {
        RandomGenerator random = new Well19937c(9);
        int hits = 0;
        double width = 0;
        for (int trial = 0; trial < TRIALS; trial++) {
            Interval interval =
                    groups(4, 5, n -> Math.pow(n, -0.5), random, 0.1).interval();
            hits += interval.contains(-0.5) ? 1 : 0;
            width += (interval.high() - interval.low()) / TRIALS;
        }
        // One in twenty is taken for no power, and its interval is wide: a little more than 95 %.
        assertThat(hits / (double) TRIALS).isBetween(0.93, 0.98);
        // With 18 degrees of freedom 2 · 2.10 · 0.1 ÷ √(5 Σ(ln x − mean)²) = 0.036; one in twenty is wider.
        assertThat(width).isBetween(0.03, 0.05);
    }

    /** What is not a power: chance over a floor of bias. The more runs the better its bend is known, not its power. */
    @Test
    void ofGroups_givenABentLaw_isNotNarrowedByMoreRuns() {
        RandomGenerator random = new Well19937c(10);
        DoubleUnaryOperator bent = n -> Math.hypot(Math.pow(n, -0.5), 0.01);
        PowerFit many = groups(4, 200, bent, random, 0.05);
        Interval plain = PowerFit.of(new double[] {1e3, 1e4, 1e5, 1e6}, new double[] {
                    bent.applyAsDouble(1e3), bent.applyAsDouble(1e4), bent.applyAsDouble(1e5), bent.applyAsDouble(1e6)
                })
                .interval();
        double width = many.interval().high() - many.interval().low();
        assertThat(width).isCloseTo(plain.high() - plain.low(), within(0.1 * width));
        // It starts as −1/2 and ends flat: the interval holds what any part of the line says.
        assertThat(many.interval().contains(-0.4)).isTrue();
        assertThat(many.interval().contains(-0.05)).isTrue();
    }

    @Test
    void ofGroups_givenRunsWithoutChance_isThatOfTheirMeans() {
        List<double[]> x = List.of(new double[] {1, 1}, new double[] {10, 10}, new double[] {100, 100});
        List<double[]> exact = List.of(new double[] {8, 8}, new double[] {4, 4}, new double[] {2, 2});
        PowerFit fit = PowerFit.ofGroups(x, exact);
        assertThat(fit.power()).isCloseTo(-Math.log10(2), within(1e-12));
        assertThat(fit.interval().high() - fit.interval().low()).isLessThan(1e-6);
        List<double[]> bent = List.of(new double[] {1, 1}, new double[] {2, 2}, new double[] {1, 1});
        double three = Math.log10(2) / 0.3 * 12.7062 * Math.sqrt(0.03);
        assertThat(PowerFit.ofGroups(x, bent).interval().high()).isCloseTo(three, within(1e-3));
    }

    @Test
    void ofGroups_givenOneRunABudget_isThePlainFit() {
        List<double[]> x = List.of(new double[] {1}, new double[] {10}, new double[] {100});
        List<double[]> y = List.of(new double[] {9}, new double[] {4}, new double[] {2});
        assertThat(PowerFit.ofGroups(x, y)).isEqualTo(PowerFit.of(new double[] {1, 10, 100}, new double[] {9, 4, 2}));
    }

    private static PowerFit groups(
            int budgets, int runs, DoubleUnaryOperator law, RandomGenerator random, double sigma) {
        List<double[]> x = new ArrayList<>();
        List<double[]> y = new ArrayList<>();
        for (int i = 0; i < budgets; i++) {
            double n = Math.pow(10, 3 + i);
            double[] values = new double[runs];
            for (int run = 0; run < runs; run++) {
                values[run] = law.applyAsDouble(n) * Math.exp(sigma * random.nextGaussian());
            }
            double[] same = new double[runs];
            Arrays.fill(same, n);
            x.add(same);
            y.add(values);
        }
        return PowerFit.ofGroups(x, y);
    }
}
