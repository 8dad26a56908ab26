package org.diacaustic.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.assertj.core.data.Offset;
import org.diacaustic.math.CompensatedSum;
import org.junit.jupiter.api.Test;

class ImageMetricsTest {
    private static final Offset<Double> ROUNDING = within(1e-14);

    @Test
    void of_givenDifferentSizes_namesBoth() {
        assertThatThrownBy(() -> ImageMetrics.of(new LinearImage(3, 2), new LinearImage(2, 3)))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("3 x 2")
                .hasMessageContaining("2 x 3");
    }

    @Test
    void of_givenIdenticalImages_isExactlyZero() {
        LinearImage image = TestImages.lively(53, 31);
        ImageMetrics metrics = ImageMetrics.of(image, TestImages.scaled(image, 1));
        assertThat(metrics).isEqualTo(new ImageMetrics(0, 0, 0, 0, 0, 0, 0, metrics.referenceMean(), 53 * 31, 0, 0));
        assertThat(metrics.referenceMean()).isPositive();
        assertThat(ImageMetrics.of(new LinearImage(2, 2), new LinearImage(2, 2)))
                .isEqualTo(new ImageMetrics(0, 0, 0, 0, 0, 0, 0, 0, 4, 0, 0));
    }

    /**
     * Reference 1, 3, mean 2; test 2, 2.5, so d = 1, −1/2. RMS √((1 + 1/4)/2) = √0.625; mean |d| 3/4; bias 1/4; offset
     * (0.02)² = 0.0004, relative square errors 1/1.0004 and 0.25/9.0004. Both pixels are in one block.
     */
    @Test
    void of_givenTwoPixels_agreesWithHandComputation() {
        ImageMetrics metrics = ImageMetrics.of(TestImages.grey(2, 2.5), TestImages.grey(1, 3));
        assertThat(metrics.relativeRootMeanSquareError()).isCloseTo(Math.sqrt(0.625) / 2, ROUNDING);
        assertThat(metrics.relativeMeanAbsoluteError()).isCloseTo(0.375, ROUNDING);
        assertThat(metrics.relativeMeanSquareError()).isCloseTo((1 / 1.0004 + 0.25 / 9.0004) / 2, ROUNDING);
        assertThat(metrics.trimmedRelativeMeanSquareError()).isEqualTo(metrics.relativeMeanSquareError());
        assertThat(metrics.worstBlockError()).isCloseTo(Math.sqrt(0.625) / 2, ROUNDING);
        assertThat(metrics.largestAbsoluteError()).isEqualTo(1);
        assertThat(metrics.bias()).isCloseTo(0.125, ROUNDING);
        assertThat(metrics.referenceMean()).isEqualTo(2);
        assertThat(metrics.comparedPixels()).isEqualTo(2);
    }

    /** One channel of one pixel: reference (1, 2, 3), mean 2, d = (0, 0, −3): RMS √3, mean |d| 1, bias −1/2. */
    @Test
    void of_givenOneChannelOff_countsAllChannels() {
        LinearImage reference = TestImages.constant(1, 1, 1, 2, 3);
        ImageMetrics metrics = ImageMetrics.of(TestImages.constant(1, 1, 1, 2, 0), reference);
        assertThat(metrics.relativeRootMeanSquareError()).isCloseTo(Math.sqrt(3) / 2, ROUNDING);
        assertThat(metrics.relativeMeanAbsoluteError()).isCloseTo(0.5, ROUNDING);
        assertThat(metrics.relativeMeanSquareError()).isCloseTo(9 / 9.0004 / 3, ROUNDING);
        assertThat(metrics.bias()).isCloseTo(-0.5, ROUNDING);
    }

    /**
     * 50 × 40 pixels of 1, all off by 0.1 but two that are off by 30: 0.1 % of 2000 are exactly those two. Without them
     * every term is 0.01/1.0001. Both lie in the last, smaller block, columns 48 and 49, rows 32 to 39: 16 pixels.
     */
    @Test
    void of_givenTwoFireflies_trimsThemAndFindsTheirBlock() {
        LinearImage reference = TestImages.constant(50, 40, 1, 1, 1);
        LinearImage test = TestImages.constant(50, 40, 1.1, 1.1, 1.1);
        test.set(48, 33, 31, 31, 31);
        test.set(49, 39, 31, 31, 31);
        ImageMetrics metrics = ImageMetrics.of(test, reference);
        double small = (1.1f - 1.0) * (1.1f - 1.0);
        assertThat(metrics.trimmedRelativeMeanSquareError()).isCloseTo(small / 1.0001, ROUNDING);
        assertThat(metrics.relativeMeanSquareError())
                .isCloseTo((1998 * small + 2 * 900) / 1.0001 / 2000, within(1e-12));
        assertThat(metrics.worstBlockError()).isCloseTo(Math.sqrt((14 * small + 2 * 900) / 16), within(1e-12));
        assertThat(metrics.largestAbsoluteError()).isEqualTo(30);
    }

    @Test
    void of_givenMask_comparesOnlyWhatItIncludes() {
        LinearImage test = TestImages.grey(5, 2, 2.5, 9);
        LinearImage reference = TestImages.grey(1, 1, 3, Double.NaN);
        ImageMetrics masked = ImageMetrics.of(test, reference, (x, y) -> x == 1 || x == 2);
        assertThat(masked).isEqualTo(ImageMetrics.of(TestImages.grey(2, 2.5), TestImages.grey(1, 3)));
    }

    @Test
    void of_givenNonFinitePixels_countsThemAndComparesTheRest() {
        LinearImage test = TestImages.grey(Double.NaN, 2, 2.5, 1);
        LinearImage reference = TestImages.grey(1, 1, 3, 1);
        test.set(3, 0, 1, Double.POSITIVE_INFINITY, 1);
        reference.set(3, 0, 1, 1, Double.NaN);
        ImageMetrics metrics = ImageMetrics.of(test, reference);
        assertThat(metrics.nonFiniteTestPixels()).isEqualTo(2);
        assertThat(metrics.nonFiniteReferencePixels()).isEqualTo(1);
        assertThat(metrics.comparedPixels()).isEqualTo(2);
        assertThat(metrics.bias()).isCloseTo(0.125, ROUNDING);
    }

    @Test
    void of_givenNothingToCompare_isNotANumber() {
        ImageMetrics metrics = ImageMetrics.of(TestImages.grey(Double.NaN), TestImages.grey(1));
        assertThat(metrics.relativeRootMeanSquareError()).isNaN();
        assertThat(metrics.relativeMeanSquareError()).isNaN();
        assertThat(metrics.worstBlockError()).isNaN();
        assertThat(metrics.largestAbsoluteError()).isNaN();
        assertThat(metrics.nonFiniteTestPixels()).isEqualTo(1);
    }

    @Test
    void of_givenBlackReference_isInfiniteWhereTheTestIsNot() {
        ImageMetrics metrics = ImageMetrics.of(TestImages.grey(0, 1), new LinearImage(2, 1));
        assertThat(metrics.relativeRootMeanSquareError()).isInfinite();
        assertThat(metrics.relativeMeanSquareError()).isInfinite();
        assertThat(metrics.largestAbsoluteError()).isEqualTo(1);
    }

    /** Both images in other units: relative errors keep every bit, absolute ones scale. */
    @Test
    void of_givenBothScaledByPowerOfTwo_keepsRelativeErrors() {
        LinearImage reference = TestImages.lively(40, 20);
        LinearImage test = TestImages.scaled(reference, 1.25);
        test.set(3, 3, 0, 0, 40);
        ImageMetrics metrics = ImageMetrics.of(test, reference);
        ImageMetrics scaled = ImageMetrics.of(TestImages.scaled(test, 0x1p-30), TestImages.scaled(reference, 0x1p-30));
        assertThat(scaled.relativeRootMeanSquareError()).isEqualTo(metrics.relativeRootMeanSquareError());
        assertThat(scaled.trimmedRelativeMeanSquareError()).isEqualTo(metrics.trimmedRelativeMeanSquareError());
        assertThat(scaled.worstBlockError()).isEqualTo(metrics.worstBlockError());
        assertThat(scaled.bias()).isEqualTo(metrics.bias());
        assertThat(scaled.largestAbsoluteError()).isEqualTo(0x1p-30 * metrics.largestAbsoluteError());
    }

    /** 1 + 10¹⁰⁰ + 1 − 10¹⁰⁰ is 2; added plainly it is 0. */
    @Test
    void add_givenCancellation_losesNothing() {
        CompensatedSum sum = new CompensatedSum();
        for (double term : new double[] {1, 1e100, 1, -1e100}) {
            sum.add(term);
        }
        assertThat(sum.value()).isEqualTo(2);
    }
}
