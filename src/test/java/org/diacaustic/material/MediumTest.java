package org.diacaustic.material;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class MediumTest {
    @ParameterizedTest
    @CsvSource({
        // exp(−a·d), and 1 − exp(−a·d).
        "0.7, 3, 0.1224564282529819265, 0.8775435717470180735",
        "1e-20, 1, 1, 1e-20",
        "1e4, 1, 0, 1",
        "0, Infinity, 1, 0",
        "Infinity, 0, 1, 0",
        "2, Infinity, 0, 1",
        "1e-300, 1e-300, 1, 0",
    })
    void transmittance_givenPath_isBeersLawAndTheRestIsAbsorbed(
            double absorption, double distance, double left, double lost) {
        assertThat(Medium.transmittance(absorption, distance)).isCloseTo(left, within(4e-16 * left));
        assertThat(Medium.absorbed(absorption, distance)).isCloseTo(lost, within(4e-16 * lost));
    }
}
