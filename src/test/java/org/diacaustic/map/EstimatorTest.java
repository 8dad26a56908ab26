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
    @CsvSource({
        "0.5, 2, 0.8660254037844386467637232",
        "0.5, 1e9, 0.005973481591048482673868662",
        "0.8, 5000, 0.4421149412985120730009639",
        "0.8, 1e12, 0.06537860758757029154060496",
        "0.6666666666666666, 4096, 0.2631185710722296654565126",
        "0.6666666666666666, 4097, 0.2631078671456515032809669",
        "0.6666666666666666, 1359265525222004642675004000000000000, 1e-6",
        "0, 1e8, 1e-4",
        "1, 1e300, 1",
    })
    void progressiveRadius_givenAnyAlphaAndManyPasses_isTheGammaQuotient(double alpha, double pass, double ratio) {
        // In 60 digits, from logarithms of gamma functions.
        assertThat(Estimator.progressiveRadius(1, pass, alpha)).isCloseTo(ratio, withinPercentage(1e-11));
    }

    @ParameterizedTest
    @ValueSource(doubles = {-0.1, 1.1, Double.NaN})
    void progressiveRadius_givenAnAlphaOutOfRange_throws(double alpha) {
        assertThatThrownBy(() -> Estimator.progressiveRadius(1, 10, alpha))
                .isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> Estimator.progressiveRadius(1, Double.NaN, 0.5))
                .isInstanceOf(IllegalArgumentException.class);
    }

    @ParameterizedTest
    @CsvSource({"1, 1", "10, 0.713102966103593548", "1000, 0.332807617064241066", "1000000, 0.105248850081658099"})
    void progressiveRadius_givenAPass_isTheGammaQuotient(int pass, double ratio) {
        // (r_N/r_1)² = Γ(N + α) ÷ (Γ(1 + α) N!), α = 2/3.
        assertThat(Estimator.progressiveRadius(3, pass) / 3).isCloseTo(ratio, withinPercentage(1e-8));
    }
}
