package org.diacaustic.image;

/** The transfer curve of sRGB [IEC 61966-2-1], exact and to the nearest of 256 steps. */
final class SrgbCurve {
    private static final float[] LINEAR_OF_BYTE = new float[256];

    /** Entry i is the linear value where the rounded code changes from i to i + 1. */
    private static final double[] STEP = new double[255];

    static {
        for (int code = 0; code < 256; code++) {
            LINEAR_OF_BYTE[code] = (float) decode(code / 255.0);
            if (code < 255) {
                STEP[code] = decode((code + 0.5) / 255);
            }
        }
    }

    private SrgbCurve() {}

    /** The coded value in 0..1 of a linear value in 0..1. */
    static double encode(double linear) {
        return linear <= 0.0031308 ? 12.92 * linear : 1.055 * StrictMath.pow(linear, 1 / 2.4) - 0.055;
    }

    /** The linear value in 0..1 of a coded value in 0..1. */
    static double decode(double coded) {
        return coded <= 0.04045 ? coded / 12.92 : StrictMath.pow((coded + 0.055) / 1.055, 2.4);
    }

    /** The linear value of an 8-bit code 0..255. */
    static float decodeByte(int code) {
        return LINEAR_OF_BYTE[code];
    }

    /**
     * The nearest 8-bit code: 0 for negative values and not-a-number, 255 for 1 and above. Looking up the step takes
     * the place of a power for every sample.
     */
    static int encodeByte(double linear) {
        int low = 0;
        int high = STEP.length;
        while (low < high) {
            int middle = (low + high) >>> 1;
            if (linear >= STEP[middle]) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        return low;
    }
}
