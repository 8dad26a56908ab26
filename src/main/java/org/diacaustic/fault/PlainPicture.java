package org.diacaustic.fault;

import java.awt.image.BufferedImage;
import java.util.Arrays;

/**
 * Pixels as codes.
 *
 * @param codes red, green, blue of 8 bits for each pixel, rows from the top, or red, green, blue and exponent for {@code .hdr}
 */
record PlainPicture(int width, int height, byte[] codes) {

    static PlainPicture of(BufferedImage image) {
        byte[] codes = new byte[3 * image.getWidth() * image.getHeight()];
        int next = 0;
        for (int y = 0; y < image.getHeight(); y++) {
            for (int x = 0; x < image.getWidth(); x++) {
                int colour = image.getRGB(x, y);
                codes[next++] = (byte) (colour >> 16);
                codes[next++] = (byte) (colour >> 8);
                codes[next++] = (byte) colour;
            }
        }
        return new PlainPicture(image.getWidth(), image.getHeight(), codes);
    }

    boolean isSameAs(PlainPicture other) {
        return width == other.width && height == other.height && Arrays.equals(codes, other.codes);
    }
}
