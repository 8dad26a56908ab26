package org.diacaustic.study;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Map;
import java.util.Optional;
import java.util.Random;
import org.diacaustic.image.ImageMask;
import org.diacaustic.image.LinearImage;
import org.junit.jupiter.api.Test;

class ErrorMeterTest {
    private static final int SIDE = 200;
    private static final double NOISE = 0.05;

    @Test
    void measure_givenAReferenceWithoutNoise_isWhatIsMeasured() {
        Reference reference =
                new Reference(Reference.Origin.GIVEN, constant(2), Optional.empty(), Optional.empty(), 0, 0, 0);
        ErrorMeter meter = new ErrorMeter(reference, constant(1.5), ImageMask.ALL);
        Map<Measure, Double> error = meter.measure(constant(2.5));
        // 0.5 too bright everywhere, of 2.
        assertThat(error)
                .containsEntry(Measure.MEASURED_RMS_ERROR, 0.25)
                .containsEntry(Measure.RMS_ERROR, 0.25)
                .containsEntry(Measure.ABSOLUTE_ERROR, 0.25)
                .containsEntry(Measure.WORST_BLOCK, 0.25);
        // 0.5 too much where the light under test is 0.5 of 2.
        assertThat(error.get(Measure.BRIGHTNESS)).isEqualTo(1);
        assertThat(meter.measure(constant(1.5)).get(Measure.BRIGHTNESS)).isEqualTo(-1);
        // 0.25 of 4.0004: the offset is the square of a hundredth of the mean.
        assertThat(error.get(Measure.RELATIVE_SQUARE_ERROR)).isCloseTo(0.25 / 4.0004, within(1e-12));
        assertThat(meter.noise()).isZero();
        assertThat(meter.pixels()).isEqualTo(SIDE * SIDE);
    }

    @Test
    void measure_givenANoisyReference_takesItsNoiseOut() {
        // The picture's error is ±0.02 of the mean, less than half of the reference's noise.
        LinearImage picture = new LinearImage(SIDE, SIDE);
        for (int i = 0; i < SIDE * SIDE; i++) {
            double value = 2 * (1 + (i % 2 == 0 ? 0.02 : -0.02));
            picture.set(i % SIDE, i / SIDE, value, value, value);
        }
        ErrorMeter meter = new ErrorMeter(noisy(2), constant(0), ImageMask.ALL);
        Map<Measure, Double> error = meter.measure(picture);
        assertThat(meter.noise()).isCloseTo(NOISE, within(1e-4));
        assertThat(error.get(Measure.MEASURED_RMS_ERROR)).isCloseTo(Math.hypot(0.02, NOISE), within(0.0005));
        assertThat(error.get(Measure.RMS_ERROR)).isCloseTo(0.02, within(0.001));
    }

    @Test
    void measure_givenAMask_looksAtItsPixelsOnly() {
        LinearImage picture = constant(2);
        picture.set(0, 0, 100, 100, 100);
        ErrorMeter meter = new ErrorMeter(noisy(2), constant(0), (x, y) -> x > 0);
        assertThat(meter.pixels()).isEqualTo((SIDE - 1) * SIDE);
        assertThat(meter.measure(picture).get(Measure.MEASURED_RMS_ERROR)).isCloseTo(NOISE, within(0.001));
        assertThat(meter.noise()).isCloseTo(NOISE, within(1e-4));
    }

    @Test
    void spread_givenBiasAndChance_tellsThemApart() {
        // Four pictures: the mean is 10 % too bright; single ones scatter by 20 % of the mean; the reference is noisy,
        // too.
        ErrorMeter meter = new ErrorMeter(noisy(2), constant(0), ImageMask.ALL);
        ErrorMeter.Spread spread = meter.spread();
        Random random = new Random(7);
        for (int k = 0; k < 4; k++) {
            LinearImage picture = new LinearImage(SIDE, SIDE);
            for (int i = 0; i < SIDE * SIDE; i++) {
                double value = 2 * (1.1 + 0.2 * random.nextGaussian());
                picture.set(i % SIDE, i / SIDE, value, value, value);
            }
            spread.add(picture);
        }
        // 40,000 pixels with 3 degrees of freedom each: √(2 ÷ 120,000) = 0.4 % of the variance.
        assertThat(spread.variance()).isCloseTo(0.04, within(0.0008));
        // What chance leaves in the mean, 0.04/4, and the reference's 0.0025, are not bias.
        assertThat(spread.squaredBias()).isCloseTo(0.01, within(0.0005));
    }

    @Test
    void spread_givenOnePicture_doesNotKnow() {
        ErrorMeter.Spread spread = new ErrorMeter(noisy(2), constant(0), ImageMask.ALL).spread();
        spread.add(constant(2));
        assertThat(spread.variance()).isNaN();
        assertThat(spread.squaredBias()).isNaN();
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
        return new Reference(
                Reference.Origin.LIGHT_TRACED, image, Optional.of(constant(value * NOISE)), Optional.empty(), 1, 16, 1);
    }
}
