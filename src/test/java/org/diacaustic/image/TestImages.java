package org.diacaustic.image;

import java.util.SplittableRandom;

/** Images with known content. */
final class TestImages {
    private TestImages() {}

    /** Radiance over many orders of magnitude, in rows that alternate with runs of one colour. */
    static LinearImage lively(int width, int height) {
        LinearImage image = new LinearImage(width, height);
        SplittableRandom random = new SplittableRandom(7L * width + height);
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                if (y % 3 == 1 && x % 300 < 200) {
                    image.set(x, y, 0.25, 0.5, 0.75);
                } else {
                    image.set(x, y, radiance(random), radiance(random), radiance(random));
                }
            }
        }
        return image;
    }

    private static double radiance(SplittableRandom random) {
        return StrictMath.exp(14 * random.nextDouble() - 10);
    }

    static LinearImage constant(int width, int height, double red, double green, double blue) {
        LinearImage image = new LinearImage(width, height);
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                image.set(x, y, red, green, blue);
            }
        }
        return image;
    }

    /** One row of grey pixels. */
    static LinearImage grey(double... values) {
        LinearImage image = new LinearImage(values.length, 1);
        for (int x = 0; x < values.length; x++) {
            image.set(x, 0, values[x], values[x], values[x]);
        }
        return image;
    }

    static LinearImage scaled(LinearImage image, double factor) {
        LinearImage result = new LinearImage(image.width(), image.height());
        for (int i = 0; i < image.samples().length; i++) {
            result.samples()[i] = (float) (image.samples()[i] * factor);
        }
        return result;
    }
}
