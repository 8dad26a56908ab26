package org.diacaustic.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.diacaustic.render.RayForecast.Measured;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class RayForecastTest {
    private final RayForecast forecast = new RayForecast();

    /** A round of which only error and rays matter. */
    private void error(long rays, double error) {
        forecast.add(new Measured(rays, error, 1, 1, 100, 100, 0, 1000));
    }

    @ParameterizedTest
    @CsvSource({
        // Slope −1, aimed at 0.85 of the target: 2000 · 0.05 ÷ (0.85 · 0.01).
        "0.1, 0.05, 0.01, 11764",
        // Slope −1/2: 2000 · (0.05 ÷ (0.85 · 0.02))².
        "0.0707106781, 0.05, 0.02, 17301",
        // Steeper than −1.1 is not believed: 2000 · (0.05 ÷ (0.85 · 0.01))^(1 ÷ 1.1).
        "0.9, 0.05, 0.01, 10013",
        // Flatter than −0.4 neither: 2000 · (0.05 ÷ (0.85 · 0.04))^2.5.
        "0.051, 0.05, 0.04, 5245",
        // Twice as many at least, sixteen times at most.
        "0.1, 0.05, 0.049, 4000",
        "0.1, 0.05, 0.0001, 32000",
        // An error that grew, or is not a number, is no slope.
        "0.04, 0.05, 0.04, 5245",
        "NaN, 0.05, 0.04, 5245"
    })
    void raysForError_givenTwoRounds_followsTheirSlope(double first, double second, double target, long rays) {
        error(1000, first);
        error(2000, second);
        assertThat(forecast.raysForError(target)).isCloseTo(rays, within(2L));
    }

    @Test
    void raysForError_givenNoNumber_takesTheLargestStep() {
        error(1000, Double.POSITIVE_INFINITY);
        assertThat(forecast.raysForError(0.01)).isEqualTo(16_000);
    }

    @Test
    void isStuck_givenTwoRoundsWithoutProgress_isTrueUntilThereIsSome() {
        error(1000, 0.1);
        error(2000, 0.099);
        assertThat(forecast.isStuck()).isFalse();
        error(4000, 0.12);
        assertThat(forecast.isStuck()).isTrue();
        error(8000, 0.05);
        assertThat(forecast.isStuck()).isFalse();
    }

    /** Slow growth is progress if it sums up: what counts is the best so far. */
    @Test
    void isStuck_givenRoundsThatGoUpAndDown_looksAtTheBest() {
        error(1000, 0.1);
        error(2000, 0.2);
        error(4000, 0.15);
        assertThat(forecast.isStuck()).isTrue();
    }

    @Test
    void seconds_givenOneRound_countsWhatIsNotDoneAgain() {
        // Light: 2 s · 10^0.9. Eye: 8 s for 100 lookups, 300 tests of which 200 are not needed again: 8 · (100 ·
        // 10^0.75 + 100) ÷ 400.
        forecast.add(new Measured(1000, 0.1, 2, 8, 100, 300, 200, 0));
        double expected = 2 * Math.pow(10, 0.9) + 8 * (100 * Math.pow(10, 0.75) + 100) / 400;
        assertThat(forecast.seconds(10)).isCloseTo(expected, within(1e-12));
        assertThat(forecast.isFirst()).isTrue();
    }

    @Test
    void seconds_givenTwoRounds_followsTheLookupsSomewhatSteeper() {
        forecast.add(new Measured(1000, 0.1, 1, 1, 100, 100, 0, 0));
        // Lookups grew with the root of the rays: slope 1/2, and 0.2 more.
        forecast.add(new Measured(4000, 0.1, 2, 3, 200, 100, 0, 0));
        double expected = 2 * Math.pow(5, 0.9) + 3 * (200 * Math.pow(5, 0.7) + 100) / 300;
        assertThat(forecast.seconds(5)).isCloseTo(expected, within(1e-12));
        assertThat(forecast.isFirst()).isFalse();
    }

    @ParameterizedTest
    @CsvSource({"0.3, 0", "20, 1000", "600, 1000", "1e7, 1000"})
    void raysForSeconds_givenSeconds_isTheMostThatFits(double seconds, long rays) {
        forecast.add(new Measured(rays == 0 ? 1000 : rays, 0.1, 2, 8, 100, 300, 0, 0));
        long most = forecast.raysForSeconds(seconds);
        if (rays == 0) {
            // Even without any ray the tests of the eye pass take 6 s.
            assertThat(most).isZero();
        } else {
            assertThat(forecast.seconds((double) most / rays)).isLessThanOrEqualTo(seconds);
            assertThat(forecast.seconds(1.01 * most / rays)).isGreaterThan(seconds);
        }
    }

    @Test
    void raysForBytes_givenBytes_leavesRoomToBuild() {
        // Maps took 1000 bytes, and twice that while they were made: 10,000 bytes are for five times the rays.
        error(1000, 0.1);
        assertThat(forecast.raysForBytes(10_000)).isEqualTo(5000);
    }

    @Test
    void raysForBytes_givenEmptyMaps_isEndless() {
        forecast.add(new Measured(1000, 0, 1, 1, 0, 0, 0, 0));
        assertThat(forecast.raysForBytes(10_000)).isEqualTo(Long.MAX_VALUE);
    }
}
