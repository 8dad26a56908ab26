package org.diacaustic.reproduction;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;

class StatisticTest {

    @Test
    void of_givenNoValue_throws() {
        assertThatIllegalArgumentException().isThrownBy(() -> new Statistic(List.of()));
    }

    @Test
    void deviation_givenValues_isThatOfASample() {
        // Squares about 5: 9 + 1 + 1 + 1 + 0 + 0 + 4 + 16 = 32, over 7.
        Statistic statistic = Statistic.of(2, 4, 4, 4, 5, 5, 7, 9);
        assertThat(statistic.mean()).isEqualTo(5);
        assertThat(statistic.deviation()).isCloseTo(Math.sqrt(32.0 / 7), within(1e-15));
        assertThat(Statistic.of(3).deviation()).isZero();
    }

    @Test
    void difference_givenPublishedNumber_isRelativeToIt() {
        assertThat(cell(Quantity.STORED, 200, 210).difference()).contains(0.05);
        assertThat(cell(Quantity.STORED, 200, 210).deviations()).isEmpty();
        // 190 and 230: mean 210, sd √(2·20²/1) = 28.3.
        assertThat(cell(Quantity.STORED, 200, 190, 230).deviations().orElseThrow())
                .isCloseTo(10 / Math.sqrt(800), within(1e-15));
    }

    @Test
    void difference_givenPercentage_isThatOfWhatIsPrinted() {
        // The thesis prints two decimals: a third one of ours is no difference.
        assertThat(cell(Quantity.PERCENT_STORED, 0.02, 0.0220).difference()).contains(0.0);
        assertThat(cell(Quantity.PERCENT_STORED, 0.02, 0.0252).difference().orElseThrow())
                .isCloseTo(0.5, within(1e-12));
    }

    private static Cell cell(Quantity quantity, double published, double... ours) {
        return new Cell(quantity, Optional.of(published), Statistic.of(ours), Optional.empty());
    }
}
