package org.diacaustic.preprocess;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class BatchDensityTest {
    private static final double[] PLACES = {0.02, 0.5, 0.5, 0.5, 0.52, 0.97, 0.55, 0.45, 0.1, 0.1};
    private static final boolean[] CHOSEN = {true, true, true, true, false};

    /** Each batch is a probability density, at the border of the square too. */
    @Test
    void at_givenBatches_integratesToTheirNumber() {
        BatchDensity density = BatchDensity.around(PLACES, CHOSEN, 0.07);
        int steps = 1000;
        double sum = 0;
        for (int i = 0; i < steps * steps; i++) {
            sum += density.at((i % steps + 0.5) / steps, (i / steps + 0.5) / steps) / steps / steps;
        }
        assertThat(density.count()).isEqualTo(4);
        assertThat(sum).isCloseTo(4, within(0.01));
    }

    @Test
    void spread_givenUniformNumbers_staysWhereTheBatchIsDense() {
        BatchDensity density = BatchDensity.around(PLACES, CHOSEN, 0.07);
        for (int batch = 0; batch < density.count(); batch++) {
            for (double s = 0; s < 1; s += 0.1) {
                double p = density.spreadP(batch, s);
                double q = density.spreadQ(batch, 1 - s);
                assertThat(p).isBetween(0.0, 1.0);
                assertThat(q).isBetween(0.0, 1.0);
                assertThat(density.at(p, q)).isGreaterThanOrEqualTo(1 / (0.14 * 0.14) * (1 - 1e-12));
            }
        }
    }

    @Test
    void around_givenNothingFound_isEmpty() {
        BatchDensity density = BatchDensity.around(PLACES, new boolean[5], 0.5);
        assertThat(density.count()).isZero();
        assertThat(density.at(0.5, 0.5)).isZero();
    }
}
