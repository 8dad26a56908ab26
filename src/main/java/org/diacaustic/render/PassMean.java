package org.diacaustic.render;

import org.diacaustic.image.LinearImage;
import org.diacaustic.math.Rgb;

/** The mean of the pictures of all passes so far. Pixels may be added by different threads, but each by one at a time. */
final class PassMean {
    /** Less noise than this ÷ mean is that of sums. */
    private static final double ROUNDING = 1e-12;

    private final LinearImage image;
    /** By how much the last pass' picture would change with a coarser map; null if there is none. */
    private final LinearImage differences;

    /** Sums over the passes, three colours a pixel; null if there is only one pass. */
    private final double[] sums;

    /** Sums of squared distances from the mean of the passes, as sums are; null if there is only one pass. */
    private final double[] spreads;

    /** @param isMean whether there may be more than one pass */
    PassMean(int width, int height, boolean isMean, boolean hasDifferences) {
        image = new LinearImage(width, height);
        differences = hasDifferences ? new LinearImage(width, height) : null;
        sums = isMean ? new double[3 * width * height] : null;
        spreads = isMean ? new double[3 * width * height] : null;
    }

    /** Adds what a pass found for a pixel; it must have been given what all passes before it found. */
    void add(int pass, int x, int y, Rgb radiance) {
        if (sums != null) {
            int i = 3 * (y * image.width() + x);
            addTo(i, pass, radiance.red);
            addTo(i + 1, pass, radiance.green);
            addTo(i + 2, pass, radiance.blue);
            radiance.set(sums[i], sums[i + 1], sums[i + 2]).scale(1.0 / (pass + 1));
        }
        image.set(x, y, radiance);
    }

    /** Adds to sum and spread [Welford 1962]. */
    private void addTo(int i, int pass, double value) {
        double fromMean = pass == 0 ? 0 : value - sums[i] / pass;
        sums[i] += value;
        spreads[i] += fromMean * (value - sums[i] / (pass + 1));
    }

    /** Notes by how much a pixel would change with a coarser map. */
    void addDifference(int x, int y, Rgb difference) {
        if (differences != null) {
            differences.set(x, y, difference);
        }
    }

    /** By how much pixels would change with a coarser map; null if there is none. */
    LinearImage differences() {
        return differences;
    }

    /** The mean; black where no pass came. */
    LinearImage image() {
        return image;
    }

    /** The mean, as it is now. */
    LinearImage copy() {
        LinearImage copy = new LinearImage(image.width(), image.height());
        System.arraycopy(image.samples(), 0, copy.samples(), 0, copy.samples().length);
        return copy;
    }

    /**
     * The standard error of the mean that single passes tell by how they differ: root of the mean square over the picture ÷
     * mean of the picture. Not a number if there are less than two passes, or all are alike but for rounding.
     *
     * @param passes that have come to every pixel
     */
    double noise(int passes) {
        if (passes < 2) {
            return Double.NaN;
        }
        double squares = 0;
        double sum = 0;
        for (int i = 0; i < sums.length; i++) {
            squares += spreads[i];
            sum += sums[i];
        }
        double variance = squares / sums.length / (passes - 1) / passes;
        double noise = Math.sqrt(variance) / (sum / sums.length / passes);
        return noise > ROUNDING ? noise : Double.NaN;
    }
}
