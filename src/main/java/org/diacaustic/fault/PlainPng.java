package org.diacaustic.fault;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.zip.CRC32;
import java.util.zip.DataFormatException;
import java.util.zip.Inflater;

/** Reads PNG of 8-bit true colour after the letter of [ISO 15948]: a second opinion on what is written. */
final class PlainPng {
    private static final long SIGNATURE = 0x89504e470d0a1a0aL;
    private static final int CHANNELS = 3;

    private PlainPng() {}

    /** The picture. */
    static PlainPicture read(byte[] file) throws IOException {
        ByteBuffer in = ByteBuffer.wrap(file);
        require(in.getLong() == SIGNATURE, "signature");
        int width = 0;
        int height = 0;
        ByteArrayOutputStream packed = new ByteArrayOutputStream();
        String type = "";
        while (!type.equals("IEND")) {
            int length = in.getInt();
            CRC32 checksum = new CRC32();
            checksum.update(file, in.position(), 4 + length);
            byte[] name = new byte[4];
            byte[] data = new byte[length];
            in.get(name).get(data);
            require(in.getInt() == (int) checksum.getValue(), "checksum");
            type = new String(name, StandardCharsets.US_ASCII);
            if (type.equals("IHDR")) {
                ByteBuffer header = ByteBuffer.wrap(data);
                width = header.getInt();
                height = header.getInt();
                require(header.get() == 8 && header.get() == 2, "8-bit true colour");
                require(header.get() == 0 && header.get() == 0 && header.get() == 0, "method");
            } else if (type.equals("IDAT")) {
                packed.write(data);
            }
        }
        require(!in.hasRemaining(), "end");
        return new PlainPicture(
                width, height, unfiltered(inflated(packed.toByteArray(), width, height), width, height));
    }

    private static byte[] inflated(byte[] packed, int width, int height) throws IOException {
        byte[] rows = new byte[height * (1 + CHANNELS * width)];
        Inflater inflater = new Inflater();
        try {
            inflater.setInput(packed);
            require(inflater.inflate(rows) == rows.length, "length of data");
            require(inflater.inflate(new byte[1]) == 0 && inflater.finished(), "end of data");
            return rows;
        } catch (DataFormatException broken) {
            throw new IOException(broken);
        } finally {
            inflater.end();
        }
    }

    private static byte[] unfiltered(byte[] rows, int width, int height) throws IOException {
        int rowBytes = CHANNELS * width;
        byte[] pixels = new byte[height * rowBytes];
        for (int y = 0; y < height; y++) {
            int filter = rows[y * (1 + rowBytes)];
            for (int x = 0; x < rowBytes; x++) {
                int left = x < CHANNELS ? 0 : pixels[y * rowBytes + x - CHANNELS] & 0xff;
                int up = y == 0 ? 0 : pixels[(y - 1) * rowBytes + x] & 0xff;
                int upLeft = x < CHANNELS || y == 0 ? 0 : pixels[(y - 1) * rowBytes + x - CHANNELS] & 0xff;
                pixels[y * rowBytes + x] =
                        (byte) (rows[y * (1 + rowBytes) + 1 + x] + predicted(filter, left, up, upLeft));
            }
        }
        return pixels;
    }

    private static int predicted(int filter, int left, int up, int upLeft) throws IOException {
        return switch (filter) {
            case 0 -> 0;
            case 1 -> left;
            case 2 -> up;
            case 3 -> (left + up) / 2;
            case 4 -> paeth(left, up, upLeft);
            default -> throw new IOException("filter " + filter);
        };
    }

    private static int paeth(int left, int up, int upLeft) {
        int estimate = left + up - upLeft;
        int toLeft = Math.abs(estimate - left);
        int toUp = Math.abs(estimate - up);
        int toUpLeft = Math.abs(estimate - upLeft);
        if (toLeft <= toUp && toLeft <= toUpLeft) {
            return left;
        }
        return toUp <= toUpLeft ? up : upLeft;
    }

    private static void require(boolean met, String what) throws IOException {
        if (!met) {
            throw new IOException("PNG: wrong " + what);
        }
    }
}
