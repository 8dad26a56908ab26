package org.diacaustic.chart;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;

class LogScaleTest {
    private static final Offset<Double> ROUNDING = Offset.offset(1e-9);

    @Test
    void constructor_givenZero_throws() {
        assertThatThrownBy(() -> new LogScale(0, 1, 0, 100)).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> new LogScale(1, 1, 0, 100)).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> new LogScale(Double.NaN, 1, 0, 100)).isInstanceOf(IllegalArgumentException.class);
    }

    @Test
    void place_givenGeometricMean_isTheMiddle() {
        LogScale scale = new LogScale(0.01, 4, 300, 100);
        assertThat(scale.place(0.01)).isCloseTo(300, ROUNDING);
        assertThat(scale.place(0.2)).isCloseTo(200, ROUNDING);
        assertThat(scale.place(4)).isCloseTo(100, ROUNDING);
    }

    @Test
    void ticks_givenOneDecadeAndAHalf_areOneTwoFive() {
        assertThat(new LogScale(0.03, 1.1, 0, 1).ticks()).containsExactly(0.05, 0.1, 0.2, 0.5, 1.0);
    }

    @Test
    void ticks_givenManyDecades_arePowersOfTen() {
        assertThat(new LogScale(0.5, 2000, 0, 1).ticks()).containsExactly(1.0, 10.0, 100.0, 1000.0);
        assertThat(new LogScale(1e-10, 1.5, 0, 1).ticks()).containsExactly(1e-10, 1e-8, 1e-6, 1e-4, 1e-2, 1.0);
    }
}
