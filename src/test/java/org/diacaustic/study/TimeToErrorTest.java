package org.diacaustic.study;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

/** Points are of 1000, 10,000, ... light rays, which take 1, 10, ... seconds. */
class TimeToErrorTest {

    private static TimeToError of(TechniqueStudy study, double target) {
        return TimeToError.of(study, target, Measure.PROCESSOR_SECONDS);
    }

    private static double reached(TimeToError time) {
        assertThat(time).isInstanceOf(TimeToError.Reached.class);
        return ((TimeToError.Reached) time).cost();
    }

    @Test
    void of_givenTargetThatIsNotPositive_isRefused() {
        TechniqueStudy study = StudyPoints.study(0, 1);
        assertThatThrownBy(() -> of(study, 0)).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> of(study, Double.NaN)).isInstanceOf(IllegalArgumentException.class);
    }

    @Test
    void of_givenTargetBetweenPoints_isOnTheLineOfTheirLogarithms() {
        // From 0.4 to 0.1 in a decade: 0.2 is half way.
        assertThat(reached(of(StudyPoints.study(0, 0.8, 0.4, 0.1), 0.2))).isCloseTo(10 * Math.sqrt(10), within(1e-9));
        assertThat(reached(of(StudyPoints.study(0, 0.8, 0.4, 0.1), 0.4))).isCloseTo(10, within(1e-9));
        assertThat(reached(of(StudyPoints.study(0, 0.8, 0.4, 0.1), 0.1))).isCloseTo(100, within(1e-9));
    }

    @Test
    void of_givenAnotherCost_isInItsUnit() {
        TimeToError rays = TimeToError.of(StudyPoints.study(0, 0.8, 0.4, 0.1), 0.4, Measure.LIGHT_RAYS);
        assertThat(reached(rays)).isCloseTo(30_000, within(1e-6));
    }

    @Test
    void of_givenFirstPointBelow_isAtMostItsCost() {
        assertThat(of(StudyPoints.study(0, 0.1, 0.05), 0.2)).isEqualTo(new TimeToError.AtMost(1));
    }

    @Test
    void of_givenTargetNeverReached_tellsTheBestError() {
        assertThat(of(StudyPoints.study(0, 0.8, 0.4, 0.5), 0.2)).isEqualTo(new TimeToError.NotReached(0.4));
    }

    @Test
    void of_givenErrorThatRisesAgain_countsTheLastCrossing() {
        // Below at 10 s, above at 100 s, below for good from 100·√10 s on.
        assertThat(reached(of(StudyPoints.study(0, 0.8, 0.1, 0.4, 0.1), 0.2)))
                .isCloseTo(100 * Math.sqrt(10), within(1e-9));
        assertThat(of(StudyPoints.study(0, 0.8, 0.1, 0.4), 0.2)).isEqualTo(new TimeToError.NotReached(0.1));
    }

    @Test
    void of_givenTargetThatTheReferenceDoesNotTell_isNotResolved() {
        assertThat(of(StudyPoints.study(0.01, 0.8, 0.2, 0.02), 0.03)).isEqualTo(new TimeToError.NotResolved(0.05));
        // But an error that is told, and is larger, is not reached.
        assertThat(of(StudyPoints.study(0.01, 0.8, 0.2), 0.03)).isEqualTo(new TimeToError.NotReached(0.2));
    }

    @Test
    void of_givenPointBelowThatIsNotTold_isOnTheLineToWhatIs() {
        // Of 0, no more than the reference's own 0.01 is told: from 1 to 0.01 in a decade, 0.1 is half way.
        assertThat(reached(of(StudyPoints.study(0.01, 1, 0), 0.1))).isCloseTo(Math.sqrt(10), within(1e-9));
        // With an exact reference it is the point's own cost.
        assertThat(reached(of(StudyPoints.study(0, 1, 0), 0.1))).isEqualTo(10);
    }

    @Test
    void of_givenNoPointsOrUnknownCost_isNotReached() {
        assertThat(of(StudyPoints.study(0), 0.1)).isEqualTo(new TimeToError.NotReached(Double.NaN));
        assertThat(TimeToError.of(StudyPoints.study(0, 1, 0.01), 0.1, Measure.MAP_BYTES))
                .isEqualTo(new TimeToError.NotReached(Double.NaN));
    }
}
