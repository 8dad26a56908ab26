package org.diacaustic.study;

import org.diacaustic.image.ImageMask;
import org.diacaustic.image.ImageMetrics;
import org.diacaustic.image.LinearImage;

/**
 * How far a picture lies from the truth, judged by a reference that has noise of its own. What is measured against such a
 * reference is the picture's error and the reference's noise together; they are independent, so their squares add, and the
 * noise, which the reference's batches tell, is taken out of the squares. For absolute errors that holds only as far as
 * both are spread alike. All numbers are relative to the mean of the reference over the pixels that count.
 *
 * @param measuredRms √(mean of d²), d the difference to the reference
 * @param rms the same without the noise of the reference; 0 if that explains all of it
 * @param measuredAbsolute mean of |d|
 * @param absolute the same without the noise of the reference
 * @param bias mean of d
 * @param noiseRms √(mean of squared standard errors of the reference); 0 if they are not known
 * @param leastRms what {@code rms} must exceed, to be more than chance of the noise: two standard deviations
 * @param pixels that count
 */
public record PictureError(
        double measuredRms,
        double rms,
        double measuredAbsolute,
        double absolute,
        double bias,
        double noiseRms,
        double leastRms,
        long pixels) {
    /** E|x| ÷ √E[x²] of a normal distribution. */
    private static final double NORMAL_ABSOLUTE = Math.sqrt(2 / Math.PI);

    private static final double STANDARD_DEVIATIONS = 2;

    static PictureError of(LinearImage picture, Reference reference, ImageMask mask) {
        ImageMetrics metrics = ImageMetrics.of(picture, reference.picture(), mask);
        double noiseSquared = 0;
        double noiseAbsolute = 0;
        double spread = 0;
        if (reference.standardError().isPresent()) {
            LinearImage error = reference.standardError().get();
            double mean = metrics.referenceMean();
            double squares = 0;
            double absolutes = 0;
            double fourths = 0;
            for (int y = 0; y < error.height(); y++) {
                for (int x = 0; x < error.width(); x++) {
                    if (mask.includes(x, y)) {
                        double variance = variance(error, error.offset(x, y));
                        squares += variance;
                        absolutes += Math.sqrt(variance);
                        fourths += variance * variance;
                    }
                }
            }
            double pixels = metrics.comparedPixels();
            noiseSquared = squares / (pixels * mean * mean);
            noiseAbsolute = NORMAL_ABSOLUTE * absolutes / (pixels * mean);
            // The variance of a squared normal number is twice its squared variance.
            spread = Math.sqrt(2 * fourths) / (pixels * mean * mean);
        }
        double rms = metrics.relativeRootMeanSquareError();
        double absolute = metrics.relativeMeanAbsoluteError();
        return new PictureError(
                rms,
                Math.sqrt(Math.max(0, rms * rms - noiseSquared)),
                absolute,
                Math.sqrt(Math.max(0, absolute * absolute - noiseAbsolute * noiseAbsolute)),
                metrics.bias(),
                Math.sqrt(noiseSquared),
                Math.sqrt(STANDARD_DEVIATIONS * spread),
                metrics.comparedPixels());
    }

    /** The mean of the colours' variances; their noise is one and the same. */
    private static double variance(LinearImage error, int offset) {
        double sum = 0;
        for (int i = offset; i < offset + 3; i++) {
            sum += (double) error.samples()[i] * error.samples()[i];
        }
        return sum / 3;
    }

    /** Whether the reference is good enough to tell the error from its own noise. */
    public boolean isResolved() {
        return rms > leastRms;
    }
}
