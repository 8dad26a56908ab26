package org.diacaustic.fault;

import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.zip.CRC32;
import java.util.zip.DeflaterOutputStream;

/** Makes image files that are wrong in one thing. */
final class BrokenPictures {
    private static final long SIGNATURE = 0x89504e470d0a1a0aL;
    private static final int GREY = 0;
    private static final int COLOUR_WITH_ALPHA = 6;

    private BrokenPictures() {}

    /** A grey PNG with a sound header and sound checksums, whose data are those of a few rows at most. */
    static byte[] greyPng(int width, int height) throws IOException {
        return png(width, height, 8, GREY, new byte[6], 0);
    }

    /** The same with 16 bits for each of four channels. */
    static byte[] deepPng(int width, int height) throws IOException {
        return png(width, height, 16, COLOUR_WITH_ALPHA, new byte[6], 0);
    }

    /** A PNG of two by two pixels whose checksums are off by {@code error}; 0 for a sound one. */
    static byte[] smallPng(int error) throws IOException {
        return png(2, 2, 8, GREY, new byte[6], error);
    }

    /** A PNG whose rows have a filter that is not. */
    static byte[] unknownFilter() throws IOException {
        return png(2, 2, 8, GREY, new byte[] {9, 0, 0, 9, 0, 0}, 0);
    }

    private static byte[] png(int width, int height, int bits, int kind, byte[] rows, int error) throws IOException {
        ByteArrayOutputStream header = new ByteArrayOutputStream();
        DataOutputStream fields = new DataOutputStream(header);
        fields.writeInt(width);
        fields.writeInt(height);
        fields.write(new byte[] {(byte) bits, (byte) kind, 0, 0, 0});
        ByteArrayOutputStream data = new ByteArrayOutputStream();
        try (DeflaterOutputStream packed = new DeflaterOutputStream(data)) {
            packed.write(rows);
        }
        ByteArrayOutputStream file = new ByteArrayOutputStream();
        DataOutputStream out = new DataOutputStream(file);
        out.writeLong(SIGNATURE);
        writeChunk(out, "IHDR", header.toByteArray(), 0);
        writeChunk(out, "IDAT", data.toByteArray(), error);
        writeChunk(out, "IEND", new byte[0], 0);
        return file.toByteArray();
    }

    private static void writeChunk(DataOutputStream out, String type, byte[] data, int error) throws IOException {
        byte[] name = type.getBytes(StandardCharsets.US_ASCII);
        CRC32 checksum = new CRC32();
        checksum.update(name);
        checksum.update(data);
        out.writeInt(data.length);
        out.write(name);
        out.write(data);
        out.writeInt((int) checksum.getValue() ^ error);
    }

    /** A header of Targa, true colour, with a few pixels behind it. */
    static byte[] targaHeader(int width, int height) {
        byte[] header = new byte[18 + 999];
        header[2] = 2;
        header[12] = (byte) width;
        header[13] = (byte) (width >> 8);
        header[14] = (byte) height;
        header[15] = (byte) (height >> 8);
        header[16] = 24;
        return header;
    }

    static byte[] ascii(String text) {
        return text.getBytes(StandardCharsets.US_ASCII);
    }

    static byte[] half(byte[] file) {
        return Arrays.copyOf(file, file.length / 2);
    }
}
