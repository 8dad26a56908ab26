package org.diacaustic.image;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;

/**
 * Portable float maps [Debevec 2001]: a short text header, then floats, the bottom row first. Written little-endian
 * (scale −1) in colour; both byte orders and grey are read. The amount of the scale names a unit that files do not
 * agree upon and is not applied, as in other readers.
 */
final class FloatMapCodec implements ImageCodec {

    @Override
    public void write(LinearImage image, Exposure exposure, OutputStream out) throws IOException {
        String header = "PF\n" + image.width() + " " + image.height() + "\n-1.0\n";
        out.write(header.getBytes(StandardCharsets.US_ASCII));
        int rowSamples = 3 * image.width();
        ByteBuffer row = ByteBuffer.allocate(Float.BYTES * rowSamples).order(ByteOrder.LITTLE_ENDIAN);
        for (int y = image.height() - 1; y >= 0; y--) {
            row.asFloatBuffer().put(image.samples(), image.offset(0, y), rowSamples);
            out.write(row.array());
        }
    }

    @Override
    public LinearImage read(ImageSource source) throws IOException {
        String magic = token(source);
        if (!magic.equals("PF") && !magic.equals("Pf")) {
            throw new IOException("not a portable float map: it does not begin with PF or Pf");
        }
        boolean grey = magic.equals("Pf");
        long width = side(token(source));
        long height = side(token(source));
        ByteOrder order = byteOrder(token(source));
        LinearImage image = source.newImage(width, height, 0);
        readRows(source, image, grey, order);
        return image;
    }

    private static void readRows(ImageSource source, LinearImage image, boolean grey, ByteOrder order)
            throws IOException {
        int rowSamples = grey ? image.width() : 3 * image.width();
        byte[] row = new byte[Float.BYTES * rowSamples];
        float[] samples = image.samples();
        for (int y = image.height() - 1; y >= 0; y--) {
            ByteBuffer bytes = source.next(row).order(order);
            int offset = image.offset(0, y);
            if (!grey) {
                bytes.asFloatBuffer().get(samples, offset, rowSamples);
                continue;
            }
            for (int x = 0; x < rowSamples; x++) {
                float value = bytes.getFloat();
                samples[offset++] = value;
                samples[offset++] = value;
                samples[offset++] = value;
            }
        }
    }

    /** The next word of the header, and the one white-space character that ends it. */
    private static String token(ImageSource source) throws IOException {
        StringBuilder word = new StringBuilder();
        for (int c = source.nextByte(); !Character.isWhitespace(c) || word.length() == 0; c = source.nextByte()) {
            if (!Character.isWhitespace(c)) {
                word.append((char) c);
            }
            if (word.length() > 40) {
                throw new IOException("not a portable float map: the header is no text");
            }
        }
        return word.toString();
    }

    private static long side(String word) throws IOException {
        try {
            return Long.parseLong(word);
        } catch (NumberFormatException e) {
            throw new IOException("the header gives the size as \"" + word + "\"", e);
        }
    }

    /** The sign of the scale tells the byte order. */
    private static ByteOrder byteOrder(String word) throws IOException {
        try {
            double scale = Double.parseDouble(word);
            if (scale != 0 && Double.isFinite(scale)) {
                return scale < 0 ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN;
            }
        } catch (NumberFormatException e) {
            throw new IOException("the header gives the scale as \"" + word + "\"", e);
        }
        throw new IOException("the header gives the scale, whose sign tells the byte order, as " + word);
    }
}
