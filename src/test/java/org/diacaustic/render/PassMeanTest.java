package org.diacaustic.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.diacaustic.math.Rgb;
import org.junit.jupiter.api.Test;

class PassMeanTest {
    private static void add(PassMean mean, int pass, double first, double second) {
        mean.add(pass, 0, 0, new Rgb().set(first, first, first));
        mean.add(pass, 1, 0, new Rgb().set(second, second, second));
    }

    @Test
    void noise_givenTwoPasses_isTheStandardErrorOfTheirMean() {
        PassMean mean = new PassMean(2, 1, true, false);
        add(mean, 0, 1, 5);
        add(mean, 1, 3, 5);
        // First pixel: 1 and 3, mean 2, variance 2, of the mean 1. Second: 5 without variance. √((1 + 0) ÷ 2) ÷ ((2 +
        // 5) ÷ 2).
        assertThat(mean.noise(2)).isCloseTo(Math.sqrt(0.5) / 3.5, within(1e-15));
        assertThat(mean.image().samples()).containsExactly(2, 2, 2, 5, 5, 5);
    }

    @Test
    void noise_givenManyPasses_fallsLikeOneOverTheRoot() {
        PassMean mean = new PassMean(2, 1, true, false);
        for (int pass = 0; pass < 1000; pass++) {
            add(mean, pass, 1 + pass % 2 * 2, 7 - pass % 2 * 4);
        }
        // Variances 1 and 4 about means 2 and 5, times 1000 ÷ 999 for they are of samples.
        assertThat(mean.noise(1000)).isCloseTo(Math.sqrt((1.0 + 4) / 2 / 999) / 3.5, within(1e-12));
    }

    @Test
    void noise_givenOnePassOrPassesThatAreAlike_isNotANumber() {
        PassMean mean = new PassMean(2, 1, true, false);
        add(mean, 0, 0.1, 0.7);
        assertThat(mean.noise(1)).isNaN();
        for (int pass = 1; pass < 9; pass++) {
            add(mean, pass, 0.1, 0.7);
        }
        assertThat(mean.noise(9)).isNaN();
    }
}
