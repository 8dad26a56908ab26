package org.diacaustic.render;

import org.diacaustic.image.LinearImage;
import org.diacaustic.math.Rgb;

/** The mean of the pictures of all passes so far. Pixels may be added by different threads, but each by one at a time. */
final class PassMean {
    private final LinearImage image;
    /** By how much the last pass' picture would change with a coarser map; null if there is none. */
    private final LinearImage differences;

    /** Sums over the passes, three colours a pixel; null if there is only one pass. */
    private final double[] sums;

    PassMean(int width, int height, int passes, boolean hasDifferences) {
        image = new LinearImage(width, height);
        differences = hasDifferences ? new LinearImage(width, height) : null;
        sums = passes > 1 ? new double[3 * width * height] : null;
    }

    /** Adds what a pass found for a pixel; it must have been given what all passes before it found. */
    void add(int pass, int x, int y, Rgb radiance) {
        if (sums != null) {
            int i = 3 * (y * image.width() + x);
            sums[i] += radiance.red;
            sums[i + 1] += radiance.green;
            sums[i + 2] += radiance.blue;
            radiance.set(sums[i], sums[i + 1], sums[i + 2]).scale(1.0 / (pass + 1));
        }
        image.set(x, y, radiance);
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
}
