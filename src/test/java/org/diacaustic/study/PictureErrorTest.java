package org.diacaustic.study;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Optional;
import java.util.Random;
import org.diacaustic.image.ImageMask;
import org.diacaustic.image.LinearImage;
import org.junit.jupiter.api.Test;

class PictureErrorTest {
    private static final int SIDE = 200;
    private static final double NOISE = 0.05;

    @Test
    void of_givenAReferenceWithoutNoise_isWhatIsMeasured() {
        Reference reference = new Reference(constant(2), Optional.empty(), 0, 0, 0);
        PictureError error = PictureError.of(constant(2.5), reference, ImageMask.ALL);
        // 0.5 too bright everywhere, of 2.
        assertThat(error.measuredRms()).isEqualTo(0.25);
        assertThat(error.rms()).isEqualTo(0.25);
        assertThat(error.absolute()).isEqualTo(0.25);
        assertThat(error.bias()).isEqualTo(0.25);
        assertThat(error.noiseRms()).isZero();
        assertThat(error.isResolved()).isTrue();
        assertThat(error.pixels()).isEqualTo(SIDE * SIDE);
    }

    @Test
    void of_givenANoisyReference_takesItsNoiseOut() {
        // The picture's error is ±0.02 of the mean, less than half of the reference's noise.
        LinearImage picture = new LinearImage(SIDE, SIDE);
        for (int i = 0; i < SIDE * SIDE; i++) {
            double value = 2 * (1 + (i % 2 == 0 ? 0.02 : -0.02));
            picture.set(i % SIDE, i / SIDE, value, value, value);
        }
        PictureError error = PictureError.of(picture, noisy(2), ImageMask.ALL);
        assertThat(error.noiseRms()).isCloseTo(NOISE, within(1e-4));
        assertThat(error.measuredRms()).isCloseTo(Math.hypot(0.02, NOISE), within(0.0005));
        assertThat(error.rms()).isCloseTo(0.02, within(0.001));
        assertThat(error.isResolved()).isTrue();
    }

    @Test
    void of_givenThePictureThatANoisyReferenceIsOf_saysThatItsErrorIsNotResolved() {
        PictureError error = PictureError.of(constant(2), noisy(2), ImageMask.ALL);
        // Two standard deviations of a sum of 40,000 squares: 2·√(2 ÷ 40,000) of it.
        assertThat(error.leastRms()).isCloseTo(NOISE * Math.sqrt(2 * Math.sqrt(2.0 / (SIDE * SIDE))), within(1e-5));
        assertThat(error.rms()).isLessThan(error.leastRms());
        assertThat(error.absolute()).isLessThan(error.leastRms());
        assertThat(error.isResolved()).isFalse();
    }

    @Test
    void of_givenAMask_looksAtItsPixelsOnly() {
        LinearImage picture = constant(2);
        picture.set(0, 0, 100, 100, 100);
        PictureError error = PictureError.of(picture, noisy(2), (x, y) -> x > 0);
        assertThat(error.pixels()).isEqualTo((SIDE - 1) * SIDE);
        assertThat(error.measuredRms()).isCloseTo(NOISE, within(0.001));
        assertThat(error.noiseRms()).isCloseTo(NOISE, within(1e-4));
    }

    private static LinearImage constant(double value) {
        LinearImage image = new LinearImage(SIDE, SIDE);
        for (int i = 0; i < SIDE * SIDE; i++) {
            image.set(i % SIDE, i / SIDE, value, value, value);
        }
        return image;
    }

    /** A picture of the value, with noise that is the same in all colours, and said. */
    private static Reference noisy(double value) {
        Random random = new Random(5);
        LinearImage image = new LinearImage(SIDE, SIDE);
        for (int i = 0; i < SIDE * SIDE; i++) {
            double noisy = value * (1 + NOISE * random.nextGaussian());
            image.set(i % SIDE, i / SIDE, noisy, noisy, noisy);
        }
        return new Reference(image, Optional.of(constant(value * NOISE)), 1, 16, 1);
    }
}
