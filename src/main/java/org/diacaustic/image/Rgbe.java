package org.diacaustic.image;

/**
 * Pixels of four bytes: three mantissas and a shared exponent [Ward 1991]. A channel is mantissa·2^(exponent − 136), as
 * most readers take it, so mantissas are rounded to nearest; the error is at most 1/256 of the largest channel.
 */
final class Rgbe {
    /** Below this, by convention, a pixel is black. */
    private static final double SMALLEST = 1e-32;

    private static final int LARGEST_EXPONENT = 127;

    private Rgbe() {}

    /** Negative values and not-a-number are stored as 0, values that are too large as the largest, about 1.7e38. */
    static void encode(float red, float green, float blue, byte[] into, int offset) {
        // A comparison with not-a-number is false.
        double r = red > 0 ? red : 0;
        double g = green > 0 ? green : 0;
        double b = blue > 0 ? blue : 0;
        double largest = Math.max(r, Math.max(g, b));
        if (largest < SMALLEST) {
            into[offset] = 0;
            into[offset + 1] = 0;
            into[offset + 2] = 0;
            into[offset + 3] = 0;
            return;
        }
        int exponent = Math.min(Math.getExponent(largest) + 1, LARGEST_EXPONENT);
        double scale = Math.scalb(1.0, 8 - exponent);
        into[offset] = mantissa(r * scale);
        into[offset + 1] = mantissa(g * scale);
        into[offset + 2] = mantissa(b * scale);
        into[offset + 3] = (byte) (exponent + 128);
    }

    private static byte mantissa(double scaled) {
        return (byte) Math.min(255, scaled + 0.5);
    }

    /** Divides by the exposure; an exponent of 0 is black. */
    static void decode(byte[] from, int offset, double exposure, float[] into, int intoOffset) {
        int exponent = from[offset + 3] & 0xff;
        double scale = exponent == 0 ? 0 : Math.scalb(1.0, exponent - 136) / exposure;
        into[intoOffset] = (float) ((from[offset] & 0xff) * scale);
        into[intoOffset + 1] = (float) ((from[offset + 1] & 0xff) * scale);
        into[intoOffset + 2] = (float) ((from[offset + 2] & 0xff) * scale);
    }
}
