package org.diacaustic.study;

import java.util.Arrays;
import org.diacaustic.image.LinearImage;

/** The mean of independent pictures of the same thing, and how far it may lie from what they are pictures of. */
final class PixelBatches {
    private final int width;
    private final int height;
    private final double[] batch;
    private final double[] sums;
    private final double[] squares;
    /** Every other picture with a minus sign. */
    private final double[] alternating;

    private int count;

    PixelBatches(int width, int height) {
        this.width = width;
        this.height = height;
        this.batch = new double[3 * width * height];
        this.sums = new double[batch.length];
        this.squares = new double[batch.length];
        this.alternating = new double[batch.length];
    }

    /** Adds radiance to a pixel of the picture that is being made. */
    void add(int pixel, double red, double green, double blue) {
        batch[3 * pixel] += red;
        batch[3 * pixel + 1] += green;
        batch[3 * pixel + 2] += blue;
    }

    /** Adds a picture, or its negative, to the picture that is being made. */
    void add(LinearImage picture, int sign) {
        for (int i = 0; i < batch.length; i++) {
            batch[i] += sign * (double) picture.samples()[i];
        }
    }

    /** Ends the picture, and begins the next. */
    void next() {
        for (int i = 0; i < batch.length; i++) {
            sums[i] += batch[i];
            squares[i] += batch[i] * batch[i];
            alternating[i] += count % 2 == 0 ? batch[i] : -batch[i];
        }
        Arrays.fill(batch, 0);
        count++;
    }

    /** How many pictures were ended. */
    int count() {
        return count;
    }

    /** The mean of the pictures that were ended. */
    LinearImage mean() {
        LinearImage image = new LinearImage(width, height);
        for (int i = 0; i < sums.length; i++) {
            image.samples()[i] = (float) (sums[i] / count);
        }
        return image;
    }

    /** The standard error of the mean, of each channel of each pixel; not a number if there is one picture only. */
    LinearImage standardError() {
        LinearImage image = new LinearImage(width, height);
        for (int i = 0; i < sums.length; i++) {
            double variance = (squares[i] - sums[i] * sums[i] / count) / ((count - 1.0) * count);
            image.samples()[i] = (float) Math.sqrt(Math.max(0, variance));
        }
        return image;
    }

    /**
     * The mean of one half of the pictures minus the mean of the other.
     *
     * @throws IllegalStateException if there are not two equal halves
     */
    LinearImage halves() {
        if (count == 0 || count % 2 != 0) {
            throw new IllegalStateException(count + " pictures have no equal halves");
        }
        LinearImage image = new LinearImage(width, height);
        for (int i = 0; i < alternating.length; i++) {
            image.samples()[i] = (float) (2 * alternating[i] / count);
        }
        return image;
    }
}
