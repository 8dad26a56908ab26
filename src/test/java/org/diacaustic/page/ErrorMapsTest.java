package org.diacaustic.page;

import static org.assertj.core.api.Assertions.assertThat;

import org.assertj.core.data.Offset;
import org.diacaustic.image.LinearImage;
import org.diacaustic.study.StudyReport;
import org.junit.jupiter.api.Test;

/** The reference of a fake study is 1 where pixels count, and its first column does not. */
class ErrorMapsTest {
    private final StudyReport report = new FakeStudy(4, 0.01).report();
    private final LinearImage reference = report.reference().picture();
    private final ErrorMaps maps = new ErrorMaps(report);

    private LinearImage with(double value) {
        LinearImage picture = new LinearImage(4, 4);
        for (int y = 0; y < 4; y++) {
            for (int x = 0; x < 4; x++) {
                picture.set(x, y, value, value, value);
            }
        }
        return picture;
    }

    @Test
    void of_givenBrighterAndDarker_isRedAndBlue() {
        var red = maps.of(with(1.2), reference, 0.2).get(2, 2);
        var blue = maps.of(with(0.8), reference, 0.2).get(2, 2);
        assertThat(red.red()).isGreaterThan(4 * red.blue());
        assertThat(blue.blue()).isGreaterThan(4 * blue.red());
    }

    @Test
    void of_givenPixelThatDoesNotCount_isDim() {
        LinearImage map = maps.of(reference, reference, 0.2);
        assertThat(map.get(0, 1).green()).isLessThan(0.2);
        assertThat(map.get(1, 1).green()).isGreaterThan(0.8);
    }

    @Test
    void of_givenDifferenceBelowAStep_isAsIfThereWereNone() {
        // A 48th of the scale is half a step.
        assertThat(maps.of(with(1 + 0.2 / 49), reference, 0.2).get(2, 2))
                .isEqualTo(maps.of(reference, reference, 0.2).get(2, 2));
        assertThat(maps.of(with(1 + 0.2 / 47), reference, 0.2).get(2, 2))
                .isNotEqualTo(maps.of(reference, reference, 0.2).get(2, 2));
    }

    @Test
    void of_givenNotANumber_isGreen() {
        assertThat(maps.of(with(Double.NaN), reference, 0.2).get(2, 2).green()).isEqualTo(1);
    }

    @Test
    void rootMeanSquare_givenConstant_isThatConstant() {
        assertThat(report.rootMeanSquare(with(0.3))).isCloseTo(0.3, Offset.offset(1e-6));
    }

    @Test
    void roundAbove_givenNumbers_isOneTwoOrFive() {
        assertThat(ErrorMaps.roundAbove(0.031)).isEqualTo(0.05);
        assertThat(ErrorMaps.roundAbove(0.05)).isEqualTo(0.05);
        assertThat(ErrorMaps.roundAbove(0.6)).isEqualTo(1);
        assertThat(ErrorMaps.roundAbove(0)).isEqualTo(1);
    }

    @Test
    void ramp_givenItsEnds_isBlueAndRedAndWhiteBetween() {
        LinearImage ramp = ErrorMaps.ramp();
        int last = ramp.width() - 1;
        assertThat(ramp.get(0, 0).blue()).isGreaterThan(4 * ramp.get(0, 0).red());
        assertThat(ramp.get(last, 0).red()).isGreaterThan(4 * ramp.get(last, 0).blue());
        assertThat(ramp.get(last / 2, 0))
                .isEqualTo(maps.of(reference, reference, 1).get(2, 2));
    }
}
