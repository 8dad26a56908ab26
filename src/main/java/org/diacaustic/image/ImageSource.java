package org.diacaustic.image;

import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/**
 * An image file that is being read: its bytes, and the memory that the image may take.
 *
 * @param in the content, buffered
 * @param limit bytes of memory that decoding may take
 */
record ImageSource(InputStream in, long limit) {
    private static final int LONGEST_LINE = 1 << 12;

    /**
     * An image of the size that the header names, to be called before anything else is allocated.
     *
     * @param decodingBytes what the decoder itself will need, beside the image
     */
    LinearImage newImage(long width, long height, long decodingBytes) throws IOException {
        checkSize(width, height, decodingBytes);
        return new LinearImage((int) width, (int) height);
    }

    /** As {@link #newImage}, without an image. */
    void checkSize(long width, long height, long decodingBytes) throws IOException {
        if (width <= 0 || height <= 0) {
            throw new IOException("the header names a size of " + width + " x " + height + " pixels");
        }
        if (width > ImageFormat.LARGEST_SIDE || height > ImageFormat.LARGEST_SIDE) {
            // Sides of any number of digits: the product of some is no long, and the nearest one tells enough.
            long about = (long) (LinearImage.bytes(1, 1) * (double) width * height);
            throw new ImageTooLargeException(width, height, about, Math.min(limit, LinearImage.LARGEST_BYTES));
        }
        long needed = LinearImage.bytes(width, height) + decodingBytes;
        if (needed > limit || !LinearImage.fits(width, height)) {
            throw new ImageTooLargeException(width, height, needed, Math.min(limit, LinearImage.LARGEST_BYTES));
        }
    }

    /** The next bytes, little-endian; the array is the caller's and filled whole. */
    ByteBuffer next(byte[] into) throws IOException {
        return next(into, into.length);
    }

    ByteBuffer next(byte[] into, int count) throws IOException {
        if (in.readNBytes(into, 0, count) < count) {
            throw new EOFException();
        }
        return ByteBuffer.wrap(into, 0, count).order(ByteOrder.LITTLE_ENDIAN);
    }

    int nextByte() throws IOException {
        int value = in.read();
        if (value < 0) {
            throw new EOFException();
        }
        return value;
    }

    /** The bytes up to the next one that is {@code end}, which is left out, as ISO 8859-1 text. */
    String nextText(char end) throws IOException {
        StringBuilder text = new StringBuilder();
        for (int c = nextByte(); c != end; c = nextByte()) {
            if (text.length() == LONGEST_LINE) {
                throw new IOException("a header line is longer than " + LONGEST_LINE + " bytes");
            }
            text.append((char) c);
        }
        return text.toString();
    }
}
