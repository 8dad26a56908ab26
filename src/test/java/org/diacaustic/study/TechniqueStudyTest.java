package org.diacaustic.study;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;

class TechniqueStudyTest {

    @Test
    void errorFit_givenErrorsThatFallLikeAPower_isThatPower() {
        PowerFit fit = StudyPoints.study(0, 1, 0.1, 0.01).errorFit(Measure.PROCESSOR_SECONDS);
        assertThat(fit.power()).isCloseTo(-1, within(1e-12));
        assertThat(fit.decades()).isCloseTo(2, within(1e-12));
    }

    @Test
    void errorFit_givenErrorsThatTheReferenceDoesNotResolve_leavesThemOut() {
        // Five times 0.01 is the least that is told.
        PowerFit fit = StudyPoints.study(0.01, 1, 0.1, 0.04).errorFit(Measure.LIGHT_RAYS);
        assertThat(fit.points()).isEqualTo(2);
        assertThat(fit.power()).isCloseTo(-1, within(1e-12));
    }

    @Test
    void errorFit_givenNoPoints_hasNoPower() {
        assertThat(StudyPoints.study(0).errorFit(Measure.LIGHT_RAYS).power()).isNaN();
    }

    @Test
    void errorFit_givenSeveralRuns_countsThemAll() {
        TechniqueStudy study = study(
                StudyPoints.point(1000, 0, 0, 0, 1.1, 0.9, 1), StudyPoints.point(10_000, 0, 0, 0, 0.11, 0.09, 0.1));
        assertThat(study.errorFit(Measure.LIGHT_RAYS).points()).isEqualTo(6);
        assertThat(study.errorFit(Measure.LIGHT_RAYS).power()).isCloseTo(-1, within(1e-12));
    }

    @Test
    void varianceFit_givenVarianceThatFallsLikeOneOverRays_isMinusOne() {
        TechniqueStudy study = study(
                StudyPoints.point(1000, 1e-9, 1e-2, 0, 1, 1),
                StudyPoints.point(10_000, 1e-9, 1e-3, 0, 1, 1),
                StudyPoints.point(100_000, 1e-9, 1e-4, 0, 1, 1));
        assertThat(study.varianceFit().power()).isCloseTo(-1, within(1e-12));
    }

    @Test
    void biasFit_givenBiasThatReferenceOrChanceMayExplain_leavesItOut() {
        TechniqueStudy study = study(
                // As large as a mean of two varies.
                StudyPoints.point(100, 4e-2, 1e-1, 1e-3, 1, 1),
                StudyPoints.point(1000, 1e-2, 1e-3, 1e-3, 1, 1),
                StudyPoints.point(10_000, 1e-4, 1e-5, 1e-3, 1, 1),
                // Below four times the squared error of the reference, and below 0 by chance.
                StudyPoints.point(100_000, 3e-6, 1e-7, 1e-3, 1, 1),
                StudyPoints.point(1_000_000, -1e-7, 1e-7, 1e-3, 1, 1));
        assertThat(study.biasFit().points()).isEqualTo(2);
        assertThat(study.biasFit().power()).isCloseTo(-2, within(1e-12));
    }

    @Test
    void fits_givenSingleRuns_knowNoVarianceAndNoBias() {
        TechniqueStudy study = StudyPoints.study(0, 1, 0.1, 0.01);
        assertThat(study.varianceFit().points()).isZero();
        assertThat(study.biasFit().points()).isZero();
    }

    private static TechniqueStudy study(StudyPoint... points) {
        return new TechniqueStudy(StudyPoints.TECHNIQUE, List.of(points), "");
    }
}
