package org.diacaustic.image;

/**
 * How far a test image lies from a reference. Sums run over all channels of all pixels that count, mean is the mean of the
 * reference over them, d = test − reference. Pixels where either image has a channel that is not finite are counted and
 * enter nothing else: whoever reports these numbers reports the counts with them. Equal images give exact zeros. If the
 * mean is 0, relative errors of images that differ are infinite; if no pixel counts, all are not-a-number.
 *
 * @param relativeRootMeanSquareError √(mean of d²) ÷ mean
 * @param relativeMeanAbsoluteError mean of |d| ÷ mean
 * @param relativeMeanSquareError mean of d² ÷ (reference² + (0.01·mean)²), [Rousselle et al. 2011] with an offset that
 *     does not depend on the scale of the image
 * @param trimmedRelativeMeanSquareError the same without the largest 0.1 % of the pixels' terms (rounded down)
 * @param worstBlockError the largest √(mean of d²) of the blocks of 8 × 8 pixels from the top left, ÷ mean of the image
 * @param largestAbsoluteError the largest |d|, in the unit of the images
 * @param bias mean of d ÷ mean; positive if the test image is brighter
 * @param referenceMean the mean, in the unit of the images
 * @param comparedPixels the pixels that entered the sums
 * @param nonFiniteTestPixels pixels of the test image that are not finite
 * @param nonFiniteReferencePixels pixels of the reference that are not finite
 */
public record ImageMetrics(
        double relativeRootMeanSquareError,
        double relativeMeanAbsoluteError,
        double relativeMeanSquareError,
        double trimmedRelativeMeanSquareError,
        double worstBlockError,
        double largestAbsoluteError,
        double bias,
        double referenceMean,
        long comparedPixels,
        long nonFiniteTestPixels,
        long nonFiniteReferencePixels) {

    /** Compares all pixels; see {@link #of(LinearImage, LinearImage, ImageMask)}. */
    public static ImageMetrics of(LinearImage test, LinearImage reference) {
        return of(test, reference, ImageMask.ALL);
    }

    /**
     * Compares the pixels that the mask includes.
     *
     * @throws IllegalArgumentException if the sizes differ
     */
    public static ImageMetrics of(LinearImage test, LinearImage reference, ImageMask mask) {
        requireSameSize(test, reference);
        return new ImageComparison(test, reference, mask).metrics();
    }

    static void requireSameSize(LinearImage test, LinearImage reference) {
        if (test.width() != reference.width() || test.height() != reference.height()) {
            throw new IllegalArgumentException(
                    "the images differ in size: the test image is " + test + ", the reference " + reference);
        }
    }
}
