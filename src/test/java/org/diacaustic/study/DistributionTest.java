package org.diacaustic.study;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class DistributionTest {

    @Test
    void of_givenOneValue_knowsNoIntervals() {
        assertThat(Distribution.of(new double[] {0.2}))
                .isEqualTo(new Distribution(1, 0.2, Interval.UNKNOWN, Interval.UNKNOWN));
    }

    @Test
    void of_givenNotANumber_isNotANumber() {
        Distribution distribution = Distribution.of(new double[] {1, Double.NaN, 3});
        assertThat(distribution.mean()).isNaN();
        assertThat(distribution.band()).isEqualTo(Interval.UNKNOWN);
        assertThat(distribution.meanInterval()).isEqualTo(Interval.UNKNOWN);
    }

    @Test
    void of_givenFewValues_hasABandFromTheLeastToTheLargest() {
        for (int count = 2; count < 20; count++) {
            int n = count;
            double[] values = IntStream.range(0, n).mapToDouble(i -> i * 7 % n).toArray();
            double[] sorted = java.util.Arrays.stream(values).sorted().toArray();
            assertThat(Distribution.of(values).band()).isEqualTo(new Interval(sorted[0], sorted[n - 1]));
        }
    }

    @Test
    void of_givenManyValues_hasABandOfPercentiles() {
        // 99 numbers: the r-th is percentile r.
        Distribution distribution =
                Distribution.of(IntStream.rangeClosed(1, 99).mapToDouble(i -> i).toArray());
        assertThat(distribution.count()).isEqualTo(99);
        assertThat(distribution.mean()).isCloseTo(50, within(1e-12));
        assertThat(distribution.band().low()).isCloseTo(5, within(1e-9));
        assertThat(distribution.band().high()).isCloseTo(95, within(1e-9));
        assertThat(distribution.meanInterval().contains(50)).isTrue();
    }

    @Test
    void of_givenAnInfiniteValue_hasAMeanOnly() {
        Distribution distribution = Distribution.of(new double[] {1, Double.POSITIVE_INFINITY});
        assertThat(distribution.mean()).isInfinite();
        assertThat(distribution.meanInterval()).isEqualTo(Interval.UNKNOWN);
    }
}
