package org.diacaustic.fault;

import java.io.IOException;
import java.nio.BufferUnderflowException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/** Reads Targa, Radiance and float-map files after the letter of their descriptions: a second opinion on what is written. */
final class PlainReaders {
    private static final int TOP_ROW_FIRST = 0x20;
    private static final int RUN = 0x80;

    private PlainReaders() {}

    /** Targa, 24-bit true colour with or without run lengths; which row comes first is said by bit 5 of the descriptor. */
    static PlainPicture targa(byte[] file) throws IOException {
        ByteBuffer in = ByteBuffer.wrap(file).order(ByteOrder.LITTLE_ENDIAN);
        int name = in.get() & 0xff;
        require(in.get() == 0, "no colour map");
        int kind = in.get();
        require(kind == 2 || kind == 10, "true colour");
        in.position(12);
        int width = in.getShort() & 0xffff;
        int height = in.getShort() & 0xffff;
        require(in.get() == 24, "24 bits");
        boolean topFirst = (in.get() & TOP_ROW_FIRST) != 0;
        in.position(in.position() + name);
        byte[] codes = new byte[3 * width * height];
        for (int i = 0; i < width * height; ) {
            int head = kind == 10 ? in.get() & 0xff : 0;
            int count = (head & ~RUN) + 1;
            int pixel = 0;
            for (int k = 0; k < count; k++, i++) {
                if (k == 0 || head < RUN) {
                    pixel = in.get() & 0xff | (in.get() & 0xff) << 8 | (in.get() & 0xff) << 16;
                }
                int row = topFirst ? i / width : height - 1 - i / width;
                int at = 3 * (row * width + i % width);
                codes[at] = (byte) (pixel >> 16);
                codes[at + 1] = (byte) (pixel >> 8);
                codes[at + 2] = (byte) pixel;
            }
        }
        return new PlainPicture(width, height, codes);
    }

    /** Radiance: red, green, blue and exponent of each pixel, in rows of run lengths if they are 8 to 32767 pixels wide. */
    static PlainPicture radiance(byte[] file) throws IOException {
        ByteBuffer in = ByteBuffer.wrap(file);
        require(line(in).startsWith("#?"), "signature");
        String line = line(in);
        boolean isRgbe = false;
        while (!line.isEmpty()) {
            isRgbe |= line.equals("FORMAT=32-bit_rle_rgbe");
            line = line(in);
        }
        require(isRgbe, "format");
        String[] size = line(in).split(" ");
        require(size.length == 4 && size[0].equals("-Y") && size[2].equals("+X"), "orientation");
        int height = Integer.parseInt(size[1]);
        int width = Integer.parseInt(size[3]);
        byte[] codes = new byte[4 * width * height];
        for (int y = 0; y < height; y++) {
            if (width < 8 || width > 0x7fff) {
                in.get(codes, 4 * y * width, 4 * width);
                continue;
            }
            require(in.getShort() == 0x0202 && in.getShort() == width, "start of a row");
            for (int channel = 0; channel < 4; channel++) {
                for (int x = 0; x < width; ) {
                    int head = in.get() & 0xff;
                    int count = head > RUN ? head - RUN : head;
                    require(count > 0 && x + count <= width, "run");
                    byte code = 0;
                    for (int k = 0; k < count; k++, x++) {
                        code = k == 0 || head <= RUN ? in.get() : code;
                        codes[4 * (y * width + x) + channel] = code;
                    }
                }
            }
        }
        require(!in.hasRemaining(), "end");
        return new PlainPicture(width, height, codes);
    }

    /** Float map in colour: red, green and blue, rows from the top. */
    static float[] floatMap(byte[] file, int width, int height) throws IOException {
        ByteBuffer in = ByteBuffer.wrap(file);
        require(line(in).equals("PF"), "signature");
        require(line(in).equals(width + " " + height), "size");
        in.order(Double.parseDouble(line(in)) < 0 ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN);
        float[] samples = new float[3 * width * height];
        for (int y = height - 1; y >= 0; y--) {
            for (int i = 0; i < 3 * width; i++) {
                samples[3 * y * width + i] = in.getFloat();
            }
        }
        require(!in.hasRemaining(), "end");
        return samples;
    }

    private static String line(ByteBuffer in) throws IOException {
        StringBuilder line = new StringBuilder();
        try {
            for (int c = in.get(); c != '\n'; c = in.get()) {
                line.append((char) c);
            }
        } catch (BufferUnderflowException early) {
            throw new IOException("a header without end", early);
        }
        return line.toString();
    }

    private static void require(boolean met, String what) throws IOException {
        if (!met) {
            throw new IOException("wrong " + what);
        }
    }
}
