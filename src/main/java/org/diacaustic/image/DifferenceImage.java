package org.diacaustic.image;

/**
 * A picture of where a test image differs from a reference: white where they agree, the redder the brighter the test
 * image, the bluer the darker. Of the three channels, the one that differs most speaks for the pixel, so no difference
 * hides in a mean. Colours run evenly in Oklab [Ottosson 2020], red and blue equally dark, so the amount can be read
 * without the hue. A pixel that is not finite in either image is green.
 *
 * @param picture to be written with exposure 1
 * @param scale the difference, in the unit of the images, that has the full colour; larger ones have it too. 0 if the
 *     images agree everywhere
 */
public record DifferenceImage(LinearImage picture, double scale) {
    private static final double SHARE_WITHIN_SCALE = 0.99;

    // Lightness and the two colour axes of Oklab.
    private static final double WHITE_LIGHTNESS = 0.97;
    private static final double FULL_LIGHTNESS = 0.5;
    private static final double RED_A = 0.166;
    private static final double RED_B = 0.092;
    private static final double BLUE_A = -0.026;
    private static final double BLUE_B = -0.188;

    /**
     * Takes as scale the difference that 99 % of the differing pixels do not exceed.
     *
     * @throws IllegalArgumentException if the sizes differ
     */
    public static DifferenceImage of(LinearImage test, LinearImage reference) {
        ImageMetrics.requireSameSize(test, reference);
        float scale = PixelRank.positive(
                test.samples().length,
                offset -> (float) Math.abs(difference(test.samples(), reference.samples(), offset)),
                SHARE_WITHIN_SCALE);
        return draw(test, reference, scale);
    }

    /**
     * Takes the given scale, so that several differences can be compared.
     *
     * @throws IllegalArgumentException if the sizes differ, or the scale is not positive and finite
     */
    public static DifferenceImage of(LinearImage test, LinearImage reference, double scale) {
        ImageMetrics.requireSameSize(test, reference);
        if (!(scale > 0 && scale < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException("scale must be positive and finite, but is " + scale);
        }
        return draw(test, reference, scale);
    }

    private static DifferenceImage draw(LinearImage test, LinearImage reference, double scale) {
        LinearImage picture = new LinearImage(test.width(), test.height());
        for (int y = 0; y < test.height(); y++) {
            for (int x = 0; x < test.width(); x++) {
                double difference = difference(test.samples(), reference.samples(), test.offset(x, y));
                if (Double.isNaN(difference)) {
                    picture.set(x, y, 0, 1, 0);
                } else {
                    setColour(picture, x, y, difference == 0 ? 0 : difference / scale);
                }
            }
        }
        return new DifferenceImage(picture, scale);
    }

    /** The signed difference of the channel that differs most; not-a-number if a channel is not finite. */
    private static double difference(float[] test, float[] reference, int offset) {
        double most = 0;
        for (int i = offset; i < offset + 3; i++) {
            if (!Float.isFinite(test[i]) || !Float.isFinite(reference[i])) {
                return Double.NaN;
            }
            double difference = (double) test[i] - reference[i];
            if (Math.abs(difference) > Math.abs(most)) {
                most = difference;
            }
        }
        return most;
    }

    private static void setColour(LinearImage picture, int x, int y, double signed) {
        double amount = Math.min(1, Math.abs(signed));
        double lightness = WHITE_LIGHTNESS + amount * (FULL_LIGHTNESS - WHITE_LIGHTNESS);
        double a = amount * (signed > 0 ? RED_A : BLUE_A);
        double b = amount * (signed > 0 ? RED_B : BLUE_B);
        double l = cube(lightness + 0.3963377774 * a + 0.2158037573 * b);
        double m = cube(lightness - 0.1055613458 * a - 0.0638541728 * b);
        double s = cube(lightness - 0.0894841775 * a - 1.2914855480 * b);
        picture.set(
                x,
                y,
                4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
                -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
                -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s);
    }

    private static double cube(double value) {
        return value * value * value;
    }
}
