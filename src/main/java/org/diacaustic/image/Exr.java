package org.diacaustic.image;

import java.io.IOException;
import java.util.zip.DataFormatException;
import java.util.zip.Inflater;

/** What writer and reader of OpenEXR share: the numbers of the format and the reordering before ZIP. */
final class Exr {
    static final int MAGIC = 20000630;

    /** Version 2, and no flag: one part of scan lines, short names. */
    static final int VERSION = 2;

    static final byte NO_COMPRESSION = 0;
    static final byte ZIP_SINGLE_ROWS = 2;
    static final byte ZIP = 3;
    static final int ROWS_PER_ZIP_BLOCK = 16;

    static final int UNSIGNED = 0;
    static final int HALF = 1;
    static final int FLOAT = 2;

    private Exr() {}

    /** Bytes at even places first, then those at odd ones; then each as its difference from the one before, plus 128. */
    static void predict(byte[] raw, byte[] into, int length) {
        int odd = (length + 1) / 2;
        for (int i = 0; i < length; i++) {
            into[(i & 1) * odd + i / 2] = raw[i];
        }
        for (int i = length - 1; i > 0; i--) {
            into[i] = (byte) (into[i] - into[i - 1] + 128);
        }
    }

    /** Undoes {@link #predict}; changes both arrays. */
    private static void undoPredict(byte[] predicted, byte[] into, int length) {
        for (int i = 1; i < length; i++) {
            predicted[i] = (byte) (predicted[i - 1] + predicted[i] - 128);
        }
        int odd = (length + 1) / 2;
        for (int i = 0; i < length; i++) {
            into[i] = predicted[(i & 1) * odd + i / 2];
        }
    }

    /** Unpacks a block of {@code length} bytes; {@code scratch} is as long as {@code into}. */
    static void inflate(byte[] packed, int packedLength, byte[] scratch, byte[] into, int length) throws IOException {
        Inflater inflater = new Inflater();
        try {
            inflater.setInput(packed, 0, packedLength);
            int done = inflater.inflate(scratch, 0, length);
            if (done < length) {
                throw new IOException("a compressed block holds " + done + " of " + length + " bytes");
            }
        } catch (DataFormatException e) {
            throw new IOException("a compressed block is damaged: " + e.getMessage(), e);
        } finally {
            inflater.end();
        }
        undoPredict(scratch, into, length);
    }

    /** The value of a 16-bit float. */
    static float half(short bits) {
        int magnitude = bits & 0x7fff;
        float value;
        if (magnitude >= 0x7c00) {
            value = Float.intBitsToFloat(0x7f800000 | (magnitude & 0x3ff) << 13);
        } else {
            // Moved into place, the exponent is too small by the difference of the biases, 127 − 15.
            value = Float.intBitsToFloat(magnitude << 13) * 0x1p112f;
        }
        return bits < 0 ? -value : value;
    }
}
