package org.diacaustic.study;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.diacaustic.image.LinearImage;
import org.junit.jupiter.api.Test;

class ErrorChartTest {

    private static TechniqueStudy study(String name, double power, double resolved) {
        List<StudyRun> runs = new ArrayList<>();
        for (long rays = 1000; rays <= 100_000; rays *= 10) {
            double rms = Math.pow(rays / 1000.0, power);
            PictureError error = new PictureError(rms, rms, rms, rms, 0, 0, resolved, 1);
            runs.add(new StudyRun(rays, rays, 1, 1, new LinearImage(1, 1), error));
        }
        return new TechniqueStudy(new Technique(name, Technique.Way.OVER_A_MAP, Map.of()), runs, "");
    }

    @Test
    void constructor_givenNoErrorThatIsResolved_isRefused() {
        List<TechniqueStudy> studies = List.of(study("all", -1, 2));
        assertThat(ErrorChart.hasSomething(studies)).isFalse();
        assertThatThrownBy(() -> new ErrorChart(studies)).isInstanceOf(IllegalArgumentException.class);
    }

    @Test
    void svg_givenErrorsThatFallLikeAPower_drawsAStraightLine() {
        String svg = new ErrorChart(List.of(study("mesh", -1, 0), study("chance", -0.5, 0))).svg();
        // 1000 to 100,000 rays are two decades on 444 units, from 56; errors from 1 to 0.01 two decades on 316, from
        // 40.
        assertThat(svg).contains("points=\"56.0,40.0 278.0,198.0 500.0,356.0\"");
        assertThat(svg).contains("points=\"56.0,40.0 278.0,119.0 500.0,198.0\"");
        assertThat(svg).contains(">mesh<", ">chance<");
    }

    @Test
    void svg_givenErrorsThatAreNotResolved_leavesThemOut() {
        String svg = new ErrorChart(List.of(study("mesh", -1, 0.05), study("chance", -0.5, 0))).svg();
        // Of the mesh 1 and 0.1, but not 0.01; and so there is but one decade of errors.
        assertThat(svg).contains("points=\"56.0,40.0 278.0,356.0\"");
        assertThat(svg.split("<circle").length - 1).isEqualTo(2 + 3 + 2);
    }

    @Test
    void svg_givenLinesThatEndTogether_keepsTheirNamesApart() {
        String svg = new ErrorChart(List.of(study("one", -1, 0), study("other", -1, 0))).svg();
        assertThat(svg).contains("<text x=\"522.0\" y=\"359.0\">one<", "<text x=\"522.0\" y=\"372.0\">other<");
    }
}
