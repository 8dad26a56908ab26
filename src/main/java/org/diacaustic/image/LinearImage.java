package org.diacaustic.image;

import org.diacaustic.math.Color;
import org.diacaustic.math.Rgb;

/**
 * A picture in linear light: red, green and blue radiance in W·m⁻²·sr⁻¹ for every pixel (or a fraction, if it is a
 * texture), with sRGB primaries. Row 0 is at the top, column 0 at the left. Different threads may set different pixels.
 */
public final class LinearImage {
    /** What one pixel takes in memory. */
    static final int BYTES_PER_PIXEL = 3 * Float.BYTES;

    private static final int LARGEST_PIXEL_COUNT = (Integer.MAX_VALUE - 8) / 3;

    static final long LARGEST_BYTES = (long) BYTES_PER_PIXEL * LARGEST_PIXEL_COUNT;

    private final int width;
    private final int height;
    private final float[] samples;

    /**
     * A black image.
     *
     * @param width in pixels
     * @param height in pixels
     * @throws IllegalArgumentException if a side is not positive, or there are more pixels than an array can hold
     */
    public LinearImage(int width, int height) {
        if (width <= 0 || height <= 0) {
            throw new IllegalArgumentException(
                    "an image must be at least 1 x 1 pixels, but is " + width + " x " + height);
        }
        if (!fits(width, height)) {
            throw new IllegalArgumentException("an image of " + width + " x " + height + " pixels needs "
                    + bytes(width, height) + " bytes; at most " + LARGEST_PIXEL_COUNT + " pixels are possible");
        }
        this.width = width;
        this.height = height;
        this.samples = new float[3 * width * height];
    }

    /** Whether an image of these positive sides can be held at all. */
    static boolean fits(long width, long height) {
        return width <= LARGEST_PIXEL_COUNT / height;
    }

    /** The memory that an image of these sides, each below 2^31, takes. */
    static long bytes(long width, long height) {
        return BYTES_PER_PIXEL * width * height;
    }

    public int width() {
        return width;
    }

    public int height() {
        return height;
    }

    /**
     * The samples themselves, not a copy: red, green and blue of pixel (x, y) at {@link #offset}(x, y) and the two
     * places after it.
     */
    public float[] samples() {
        return samples;
    }

    /**
     * Where pixel (x, y) begins in {@link #samples}.
     *
     * @throws IndexOutOfBoundsException if there is no such pixel
     */
    public int offset(int x, int y) {
        if (x < 0 || x >= width || y < 0 || y >= height) {
            throw new IndexOutOfBoundsException(
                    "pixel (" + x + ", " + y + ") of an image of " + width + " x " + height);
        }
        return 3 * (y * width + x);
    }

    /** Sets pixel (x, y); each channel is rounded to float. */
    public void set(int x, int y, double red, double green, double blue) {
        int offset = offset(x, y);
        samples[offset] = (float) red;
        samples[offset + 1] = (float) green;
        samples[offset + 2] = (float) blue;
    }

    public void set(int x, int y, Color color) {
        set(x, y, color.red(), color.green(), color.blue());
    }

    public void set(int x, int y, Rgb rgb) {
        set(x, y, rgb.red, rgb.green, rgb.blue);
    }

    /** The colour of pixel (x, y). Hot loops read {@link #samples} instead and allocate nothing. */
    public Color get(int x, int y) {
        int offset = offset(x, y);
        return new Color(samples[offset], samples[offset + 1], samples[offset + 2]);
    }

    @Override
    public String toString() {
        return width + " x " + height + " pixels";
    }
}
