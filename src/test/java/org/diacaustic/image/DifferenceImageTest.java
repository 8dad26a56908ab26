package org.diacaustic.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.diacaustic.math.Color;
import org.junit.jupiter.api.Test;

class DifferenceImageTest {
    @Test
    void of_givenBadArguments_refuses() {
        LinearImage image = new LinearImage(2, 2);
        assertThatThrownBy(() -> DifferenceImage.of(image, new LinearImage(2, 3)))
                .isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> DifferenceImage.of(image, image, 0)).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> DifferenceImage.of(image, image, Double.NaN))
                .isInstanceOf(IllegalArgumentException.class);
    }

    @Test
    void of_givenIdenticalImages_isWhiteWithScaleZero() {
        LinearImage image = TestImages.lively(5, 4);
        DifferenceImage difference = DifferenceImage.of(image, image);
        assertThat(difference.scale()).isZero();
        for (float sample : difference.picture().samples()) {
            // Oklab lightness 0.97 is 0.97³ = 0.9127 in linear light.
            assertThat(sample).isCloseTo(0.9127f, within(1e-4f));
        }
    }

    @Test
    void of_givenSignedDifferences_isRedWhereBrighterAndBlueWhereDarker() {
        LinearImage test = TestImages.grey(2, 1.25, 1, 0.75, 0, -8, Double.NaN);
        LinearImage picture = DifferenceImage.of(test, TestImages.grey(1, 1, 1, 1, 1, 1, 1), 1)
                .picture();
        Color red = picture.get(0, 0);
        Color blue = picture.get(4, 0);
        assertThat(red.red()).isGreaterThan(20 * red.blue());
        assertThat(blue.blue()).isGreaterThan(4 * blue.red());
        assertThat(picture.get(1, 0).red()).isGreaterThan(picture.get(1, 0).blue());
        assertThat(picture.get(3, 0).blue()).isGreaterThan(picture.get(3, 0).red());
        // Beyond the scale the colour stays full.
        assertThat(picture.get(5, 0)).isEqualTo(blue);
        assertThat(picture.get(6, 0)).isEqualTo(new Color(0, 1, 0));
    }

    @Test
    void of_givenAnyDifference_staysWithinTheDisplay() {
        double[] test = new double[201];
        for (int i = 0; i < test.length; i++) {
            test[i] = (i - 100) / 100.0;
        }
        LinearImage picture = DifferenceImage.of(TestImages.grey(test), new LinearImage(201, 1), 1)
                .picture();
        for (float sample : picture.samples()) {
            assertThat(sample).isBetween(0f, 1f);
        }
    }

    /** Of 200 differing pixels, 1 to 200, 99 % do not exceed 198; the equal ones do not count. */
    @Test
    void of_givenNoScale_takesOneThatFewExceed() {
        double[] test = new double[1000];
        for (int i = 0; i < 200; i++) {
            test[i] = i % 2 == 0 ? i + 1 : -i - 1;
        }
        assertThat(DifferenceImage.of(TestImages.grey(test), new LinearImage(1000, 1))
                        .scale())
                .isEqualTo(198);
    }

    @Test
    void of_givenOppositeChannels_showsTheLarger() {
        LinearImage test = TestImages.constant(1, 1, 1, -2, 0.5);
        Color shown =
                DifferenceImage.of(test, new LinearImage(1, 1), 2).picture().get(0, 0);
        assertThat(shown)
                .isEqualTo(DifferenceImage.of(TestImages.grey(-2), new LinearImage(1, 1), 2)
                        .picture()
                        .get(0, 0));
    }
}
