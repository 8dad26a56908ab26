package org.diacaustic.study;

import java.util.EnumMap;
import java.util.Map;
import java.util.function.IntToDoubleFunction;
import org.diacaustic.image.ImageMask;
import org.diacaustic.image.ImageMetrics;
import org.diacaustic.image.LinearImage;

/**
 * Says how far pictures lie from the truth, judged by a reference that has noise of its own. What is measured against such a
 * reference is the picture's error and the reference's noise together; they are independent, so their squares add, and the
 * noise, which the reference's batches tell, is taken out of the squares. For absolute errors that holds only as far as
 * both are spread alike; the other measures are left as they are.
 */
final class ErrorMeter {
    /** E|x| ÷ √E[x²] of a normal distribution. */
    private static final double NORMAL_ABSOLUTE = Math.sqrt(2 / Math.PI);

    private final LinearImage reference;
    private final ImageMask mask;
    private final double mean;
    private final long pixels;
    /** The mean of the light that techniques bring ÷ mean. */
    private final double broughtPart;

    private final double noiseSquared;
    private final double noiseAbsolute;

    /** @param direct what the reference would be without the light that techniques bring */
    ErrorMeter(Reference reference, LinearImage direct, ImageMask mask) {
        this.reference = reference.picture();
        this.mask = mask;
        ImageMetrics itself = ImageMetrics.of(this.reference, this.reference, mask);
        this.mean = itself.referenceMean();
        this.pixels = itself.comparedPixels();
        double brought = -ImageMetrics.of(direct, this.reference, mask).bias();
        // Where techniques bring nothing, the picture is all that there is to compare with.
        this.broughtPart = brought > 0 ? brought : 1;
        double squares = 0;
        double absolutes = 0;
        if (reference.standardError().isPresent()) {
            LinearImage error = reference.standardError().get();
            for (int y = 0; y < error.height(); y++) {
                for (int x = 0; x < error.width(); x++) {
                    if (mask.includes(x, y)) {
                        double variance = variance(error, error.offset(x, y));
                        squares += variance;
                        absolutes += Math.sqrt(variance);
                    }
                }
            }
        }
        this.noiseSquared = squares / (pixels * mean * mean);
        this.noiseAbsolute = NORMAL_ABSOLUTE * absolutes / (pixels * mean);
    }

    /** The mean of the colours' variances; their noise is one and the same. */
    private static double variance(LinearImage error, int offset) {
        double sum = 0;
        for (int i = offset; i < offset + 3; i++) {
            sum += (double) error.samples()[i] * error.samples()[i];
        }
        return sum / 3;
    }

    /** All measures of error. */
    Map<Measure, Double> measure(LinearImage picture) {
        ImageMetrics metrics = ImageMetrics.of(picture, reference, mask);
        double rms = metrics.relativeRootMeanSquareError();
        double absolute = metrics.relativeMeanAbsoluteError();
        Map<Measure, Double> measures = new EnumMap<>(Measure.class);
        measures.put(Measure.MEASURED_RMS_ERROR, rms);
        measures.put(Measure.RMS_ERROR, Math.sqrt(Math.max(0, rms * rms - noiseSquared)));
        measures.put(
                Measure.ABSOLUTE_ERROR, Math.sqrt(Math.max(0, absolute * absolute - noiseAbsolute * noiseAbsolute)));
        measures.put(Measure.RELATIVE_SQUARE_ERROR, metrics.relativeMeanSquareError());
        measures.put(Measure.TRIMMED_SQUARE_ERROR, metrics.trimmedRelativeMeanSquareError());
        measures.put(Measure.WORST_BLOCK, metrics.worstBlockError());
        measures.put(Measure.BRIGHTNESS, metrics.bias() / broughtPart);
        return measures;
    }

    /** The reference's own error: √(mean of squared standard errors) ÷ mean; 0 if it has none, or does not tell. */
    double noise() {
        return Math.sqrt(noiseSquared);
    }

    /** The pixels that count. */
    long pixels() {
        return pixels;
    }

    /** Takes pictures of the same thing with different seeds, and tells what they have wrong together and each alone. */
    Spread spread() {
        return new Spread();
    }

    /** Sums over pictures. */
    final class Spread {
        private final double[] sums = new double[reference.samples().length];
        private final double[] squares = new double[sums.length];
        private int count;

        void add(LinearImage picture) {
            for (int i = 0; i < sums.length; i++) {
                // Differences are small where pictures are good, and so are the rounding errors of their squares.
                double difference = (double) picture.samples()[i] - reference.samples()[i];
                sums[i] += difference;
                squares[i] += difference * difference;
            }
            count++;
        }

        /** Mean of the pixels' variances ÷ mean²; not a number after a single picture. */
        double variance() {
            return sum(i -> (squares[i] - sums[i] * sums[i] / count) / (count - 1)) / scale();
        }

        /** Mean of the pixels' (mean − reference)² ÷ mean², without what chance and the noise of the reference put into it. */
        double squaredBias() {
            double measured = sum(i -> sums[i] / count * (sums[i] / count)) / scale();
            return measured - variance() / count - noiseSquared;
        }

        private double scale() {
            return 3.0 * pixels * mean * mean;
        }

        private double sum(IntToDoubleFunction term) {
            double sum = 0;
            for (int y = 0; y < reference.height(); y++) {
                for (int x = 0; x < reference.width(); x++) {
                    if (mask.includes(x, y)) {
                        int offset = reference.offset(x, y);
                        sum += term.applyAsDouble(offset)
                                + term.applyAsDouble(offset + 1)
                                + term.applyAsDouble(offset + 2);
                    }
                }
            }
            return sum;
        }
    }
}
