package org.diacaustic.map;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.withinPercentage;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class EstimatorTest {
    @ParameterizedTest
    @ValueSource(doubles = {0, -1, Double.NaN, Double.POSITIVE_INFINITY})
    void constructor_givenANumberOutOfRange_throws(double bad) {
        assertThatThrownBy(() -> new Estimator.Density(bad, Kernel.CONE)).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> new Estimator.ExpectedCount(bad, 1)).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> new Estimator.ExpectedCount(1, bad)).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> Estimator.progressiveRadius(bad, 1)).isInstanceOf(IllegalArgumentException.class);
    }

    @Test
    void nearest_givenNumbersOutOfRange_throws() {
        assertThatThrownBy(() -> new Estimator.Nearest(1, 1, Kernel.CONE)).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> new Estimator.Nearest(2, 0, Kernel.CONE)).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> new Estimator.Nearest(2, Double.NaN, Kernel.CONE))
                .isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> Estimator.progressiveRadius(1, 0)).isInstanceOf(IllegalArgumentException.class);
    }

    @ParameterizedTest
    @CsvSource({"1, 1", "10, 0.713102966103593548", "1000, 0.332807617064241066", "1000000, 0.105248850081658099"})
    void progressiveRadius_givenAPass_isTheGammaQuotient(int pass, double ratio) {
        // (r_N/r_1)² = Γ(N + α) ÷ (Γ(1 + α) N!), α = 2/3.
        assertThat(Estimator.progressiveRadius(3, pass) / 3).isCloseTo(ratio, withinPercentage(1e-8));
    }
}
