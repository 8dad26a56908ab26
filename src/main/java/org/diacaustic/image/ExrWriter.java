package org.diacaustic.image;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.zip.Deflater;

/**
 * Writes OpenEXR: 32-bit floats in the channels B, G, R, blocks of 16 rows, each compressed by ZIP. Blocks are kept,
 * compressed, until all are known, because the table of their places comes first.
 */
final class ExrWriter {
    private static final String[] CHANNELS = {"B", "G", "R"};

    /** As in OpenEXR itself: higher levels gain little on floats. */
    private static final int COMPRESSION_LEVEL = 4;

    private ExrWriter() {}

    static void write(LinearImage image, OutputStream out) throws IOException {
        byte[] header = header(image.width(), image.height());
        List<byte[]> blocks = blocks(image);
        out.write(header);
        ByteBuffer table = ByteBuffer.allocate(Long.BYTES * blocks.size()).order(ByteOrder.LITTLE_ENDIAN);
        long position = header.length + table.capacity();
        for (byte[] block : blocks) {
            table.putLong(position);
            position += 2 * Integer.BYTES + block.length;
        }
        out.write(table.array());
        int row = 0;
        for (byte[] block : blocks) {
            writeInt(out, row);
            writeInt(out, block.length);
            out.write(block);
            row += Exr.ROWS_PER_ZIP_BLOCK;
        }
    }

    private static byte[] header(int width, int height) throws IOException {
        ByteArrayOutputStream header = new ByteArrayOutputStream();
        writeInt(header, Exr.MAGIC);
        writeInt(header, Exr.VERSION);
        attribute(header, "channels", "chlist", channels());
        attribute(header, "compression", "compression", new byte[] {Exr.ZIP});
        attribute(header, "dataWindow", "box2i", ints(0, 0, width - 1, height - 1));
        attribute(header, "displayWindow", "box2i", ints(0, 0, width - 1, height - 1));
        byte[] increasingY = {0};
        attribute(header, "lineOrder", "lineOrder", increasingY);
        attribute(header, "pixelAspectRatio", "float", ints(Float.floatToIntBits(1)));
        attribute(header, "screenWindowCenter", "v2f", ints(0, 0));
        attribute(header, "screenWindowWidth", "float", ints(Float.floatToIntBits(1)));
        header.write(0);
        return header.toByteArray();
    }

    private static byte[] channels() throws IOException {
        ByteArrayOutputStream list = new ByteArrayOutputStream();
        for (String name : CHANNELS) {
            writeText(list, name);
            int notPerceptuallyLinear = 0;
            list.write(ints(Exr.FLOAT, notPerceptuallyLinear, 1, 1));
        }
        list.write(0);
        return list.toByteArray();
    }

    private static void attribute(OutputStream out, String name, String type, byte[] value) throws IOException {
        writeText(out, name);
        writeText(out, type);
        writeInt(out, value.length);
        out.write(value);
    }

    private static List<byte[]> blocks(LinearImage image) {
        List<byte[]> blocks = new ArrayList<>();
        int rows = Math.min(Exr.ROWS_PER_ZIP_BLOCK, image.height());
        byte[] raw = new byte[LinearImage.BYTES_PER_PIXEL * image.width() * rows];
        byte[] reordered = new byte[raw.length];
        Deflater deflater = new Deflater(COMPRESSION_LEVEL);
        try {
            for (int top = 0; top < image.height(); top += rows) {
                int length = gather(image, top, Math.min(rows, image.height() - top), raw);
                Exr.predict(raw, reordered, length);
                blocks.add(smaller(deflater, raw, reordered, length));
            }
        } finally {
            deflater.end();
        }
        return blocks;
    }

    /** Rows one after the other, in each first all of channel B, then G, then R. */
    private static int gather(LinearImage image, int top, int rows, byte[] raw) {
        ByteBuffer bytes = ByteBuffer.wrap(raw).order(ByteOrder.LITTLE_ENDIAN);
        float[] samples = image.samples();
        for (int y = top; y < top + rows; y++) {
            int offset = image.offset(0, y);
            for (int channel = 2; channel >= 0; channel--) {
                for (int x = 0; x < image.width(); x++) {
                    bytes.putInt(Float.floatToRawIntBits(samples[offset + 3 * x + channel]));
                }
            }
        }
        return bytes.position();
    }

    /** The compressed block, or, as the format asks, the raw one if compression does not make it smaller. */
    private static byte[] smaller(Deflater deflater, byte[] raw, byte[] reordered, int length) {
        deflater.reset();
        deflater.setInput(reordered, 0, length);
        deflater.finish();
        byte[] compressed = new byte[length];
        int size = deflater.deflate(compressed);
        return deflater.finished() && size < length ? Arrays.copyOf(compressed, size) : Arrays.copyOf(raw, length);
    }

    private static byte[] ints(int... values) {
        ByteBuffer bytes = ByteBuffer.allocate(Integer.BYTES * values.length).order(ByteOrder.LITTLE_ENDIAN);
        for (int value : values) {
            bytes.putInt(value);
        }
        return bytes.array();
    }

    private static void writeInt(OutputStream out, int value) throws IOException {
        out.write(ints(value));
    }

    private static void writeText(OutputStream out, String text) throws IOException {
        out.write(text.getBytes(StandardCharsets.US_ASCII));
        out.write(0);
    }
}
