package org.diacaustic.study;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.diacaustic.image.LinearImage;
import org.junit.jupiter.api.Test;

class TechniqueStudyTest {
    private static final Technique TECHNIQUE = new Technique("any", Technique.Way.OVER_A_MAP, Map.of());

    @Test
    void slope_givenErrorsThatFallLikeAPower_isThatPower() {
        TechniqueStudy.Slope slope = study(-0.75, 0).slope();
        assertThat(slope.value()).isCloseTo(-0.75, within(1e-12));
        assertThat(slope.standardError()).isCloseTo(0, within(1e-9));
        assertThat(slope.points()).isEqualTo(4);
    }

    @Test
    void slope_givenErrorsThatTheReferenceDoesNotResolve_leavesThemOut() {
        // 1000, 4000, 16000 and 64000 rays have errors of 1, 1/4, 1/16 and 1/64: the last two are not resolved.
        TechniqueStudy.Slope slope = study(-1, 0.1).slope();
        assertThat(slope.value()).isCloseTo(-1, within(1e-12));
        assertThat(slope.points()).isEqualTo(2);
        assertThat(study(-1, 0.5).slope().value()).isNaN();
    }

    private static TechniqueStudy study(double power, double resolved) {
        List<StudyRun> runs = new ArrayList<>();
        for (long rays = 1000; rays <= 64000; rays *= 4) {
            double rms = Math.pow(rays / 1000.0, power);
            PictureError error = new PictureError(rms, rms, rms, rms, 0, 0, resolved, 1);
            // All that became of the rays counts, and here that is three times the rays.
            runs.add(new StudyRun(rays, 3 * rays, 1, 1, new LinearImage(1, 1), error));
        }
        return new TechniqueStudy(TECHNIQUE, runs, "");
    }
}
