package org.diacaustic.material;

import org.diacaustic.image.LinearImage;
import org.diacaustic.math.Rgb;

/**
 * An image laid on the map square: u to the right, v up, texels at the middles of their fields, bilinear between. u goes
 * round, as maps of spheres and cylinders need; v goes round only if the image is repeated, and stops at the edge
 * otherwise.
 */
final class ImageSampler {
    private final LinearImage image;
    private final int repeatU;
    private final int repeatV;

    ImageSampler(LinearImage image, int repeatU, int repeatV) {
        if (repeatU < 1 || repeatV < 1) {
            throw new IllegalArgumentException(
                    "an image must be repeated at least once each way, but is " + repeatU + " and " + repeatV);
        }
        this.image = image;
        this.repeatU = repeatU;
        this.repeatV = repeatV;
    }

    int texelsAcross() {
        return image.width() * repeatU;
    }

    int texelsDown() {
        return image.height() * repeatV;
    }

    void sample(double u, double v, Rgb color) {
        double x = u * repeatU * image.width() - 0.5;
        double y = (1 - v) * repeatV * image.height() - 0.5;
        double floorX = Math.floor(x);
        double floorY = Math.floor(y);
        double right = x - floorX;
        double below = y - floorY;
        int left = column((long) floorX);
        int next = column((long) floorX + 1);
        int top = row((long) floorY);
        int bottom = row((long) floorY + 1);
        color.set(0, 0, 0);
        add(left, top, (1 - right) * (1 - below), color);
        add(next, top, right * (1 - below), color);
        add(left, bottom, (1 - right) * below, color);
        add(next, bottom, right * below, color);
    }

    private void add(int x, int y, double weight, Rgb color) {
        int at = image.offset(x, y);
        float[] samples = image.samples();
        color.add(weight * samples[at], weight * samples[at + 1], weight * samples[at + 2]);
    }

    private int column(long x) {
        return (int) Math.floorMod(x, (long) image.width());
    }

    private int row(long y) {
        return repeatV > 1
                ? (int) Math.floorMod(y, (long) image.height())
                : (int) Math.max(0, Math.min(image.height() - 1, y));
    }
}
