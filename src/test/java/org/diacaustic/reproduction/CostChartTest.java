package org.diacaustic.reproduction;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Set;
import org.diacaustic.chart.Ink;
import org.diacaustic.image.LinearImage;
import org.junit.jupiter.api.Test;

class CostChartTest {

    @Test
    void of_givenScene_drawsABarForEachNumber() {
        String svg = chart().svg();
        assertThat(svg).contains("3,000,741 thesis", "3,000,741 ours");
        // Five techniques with two maps: ten outlines and ten full bars, besides two in the legend.
        assertThat(svg.split("line-individual|line-global").length - 1).isEqualTo(10);
        assertThat(svg.split("fill-individual|fill-global").length - 1).isEqualTo(12);
    }

    @Test
    void image_givenBar_endsAtItsNumber() {
        // 3,000,741 tests: log10 = 6.4772, so the bar from x = 8 ends 520·1.4772/3 = 256.1 further: at pixel 2·264 =
        // 528.
        LinearImage image = chart().image();
        int row = 2 * (64 + 18 + 12 + 5);
        assertThat(image.get(526, row).red()).isEqualTo((float) Ink.INDIVIDUAL.red);
        assertThat(image.get(530, row).red()).isEqualTo(1);
    }

    private static CostChart chart() {
        ReproductionReport report =
                new Reproduction(Set.of(ThesisScene.CONTROL), 1, 1, new FakeLaboratory()).run(1, (done, total) -> {});
        return CostChart.of(ThesisScene.CONTROL, report.comparisons());
    }
}
