package org.diacaustic.image;

import java.util.Arrays;

/**
 * Exact rank statistics over pixels, found by counting: positive floats order like their bits, so two passes, one for the
 * upper half of the bits and one for the lower, find any rank without sorting or copying.
 */
final class PixelRank {
    private static final int HALF = 1 << 16;

    private PixelRank() {}

    /** A value of the pixel whose samples begin at an offset. */
    interface PixelValue {
        float at(int offset);
    }

    /**
     * The smallest value that at least the given share of the positive, finite values does not exceed; 0 if there are
     * none.
     *
     * @param sampleCount three for every pixel
     * @param share above 0, at most 1
     */
    static float positive(int sampleCount, PixelValue value, double share) {
        int[] counts = new int[HALF];
        long total = 0;
        for (int offset = 0; offset < sampleCount; offset += 3) {
            float v = value.at(offset);
            if (isPositive(v)) {
                counts[Float.floatToRawIntBits(v) >>> 16]++;
                total++;
            }
        }
        if (total == 0) {
            return 0;
        }
        long rank = (long) Math.ceil(share * total) - 1;
        int upper = 0;
        while (rank >= counts[upper]) {
            rank -= counts[upper++];
        }
        Arrays.fill(counts, 0);
        for (int offset = 0; offset < sampleCount; offset += 3) {
            float v = value.at(offset);
            int bits = Float.floatToRawIntBits(v);
            if (isPositive(v) && bits >>> 16 == upper) {
                counts[bits & (HALF - 1)]++;
            }
        }
        int lower = 0;
        while (rank >= counts[lower]) {
            rank -= counts[lower++];
        }
        return Float.intBitsToFloat(upper << 16 | lower);
    }

    private static boolean isPositive(float value) {
        return value > 0 && value < Float.POSITIVE_INFINITY;
    }
}
