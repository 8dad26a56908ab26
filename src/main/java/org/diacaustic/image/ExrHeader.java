package org.diacaustic.image;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * What the header of an OpenEXR file says of its pixels.
 *
 * @param channels in the order in which a row holds them
 * @param compression the number of the method
 * @param top the y of the first row; the display window is not looked at
 */
record ExrHeader(List<Channel> channels, int compression, int top, long width, long height) {
    private static final int LARGEST_ATTRIBUTE = 1 << 16;
    private static final int VERSION_BYTE = 0xff;
    private static final int LONG_NAMES = 0x400;
    private static final String[] COMPRESSIONS = {
        "none", "RLE", "ZIPS", "ZIP", "PIZ", "PXR24", "B44", "B44A", "DWAA", "DWAB"
    };

    /** One channel: its name and the type of its samples. */
    record Channel(String name, int type) {
        int bytes() {
            return type == Exr.HALF ? Short.BYTES : Integer.BYTES;
        }
    }

    static ExrHeader read(ImageSource source) throws IOException {
        ByteBuffer start = source.next(new byte[2 * Integer.BYTES]);
        if (start.getInt() != Exr.MAGIC) {
            throw new IOException("not an OpenEXR file: the first four bytes are others");
        }
        int version = start.getInt();
        if ((version & VERSION_BYTE) != Exr.VERSION || (version & ~(VERSION_BYTE | LONG_NAMES)) != 0) {
            throw new IOException("only OpenEXR files of one part in scan lines are read, not tiles, deep data or more"
                    + " parts (version field 0x" + Integer.toHexString(version) + ")");
        }
        List<Channel> channels = null;
        int compression = -1;
        ByteBuffer window = null;
        for (String name = source.nextText('\0'); !name.isEmpty(); name = source.nextText('\0')) {
            source.nextText('\0');
            int length = source.next(new byte[Integer.BYTES]).getInt();
            switch (name) {
                case "channels" -> channels = channels(value(source, name, length));
                case "compression" -> compression = value(source, name, length)[0];
                case "dataWindow" -> window = ByteBuffer.wrap(value(source, name, length));
                default -> skip(source, name, length);
            }
        }
        return checked(channels, compression, window);
    }

    private static ExrHeader checked(List<Channel> channels, int compression, ByteBuffer window) throws IOException {
        if (channels == null || compression < 0 || window == null || window.capacity() != 4 * Integer.BYTES) {
            throw new IOException("the header lacks channels, compression or dataWindow");
        }
        if (compression != Exr.NO_COMPRESSION && compression != Exr.ZIP_SINGLE_ROWS && compression != Exr.ZIP) {
            String name = compression < COMPRESSIONS.length ? COMPRESSIONS[compression] : "number " + compression;
            throw new IOException("the compression is " + name + "; only none, ZIPS and ZIP are read");
        }
        window.order(ByteOrder.LITTLE_ENDIAN);
        int left = window.getInt();
        int top = window.getInt();
        long width = (long) window.getInt() - left + 1;
        long height = (long) window.getInt() - top + 1;
        return new ExrHeader(channels, compression, top, width, height);
    }

    private static List<Channel> channels(byte[] list) throws IOException {
        List<Channel> channels = new ArrayList<>();
        ByteBuffer bytes = ByteBuffer.wrap(list).order(ByteOrder.LITTLE_ENDIAN);
        while (true) {
            int start = bytes.position();
            int end = start;
            while (end < list.length && list[end] != 0) {
                end++;
            }
            if (end == start) {
                return channels;
            }
            if (list.length - end < 1 + 4 * Integer.BYTES) {
                throw new IOException("the list of channels ends early");
            }
            String name = new String(list, start, end - start, StandardCharsets.ISO_8859_1);
            bytes.position(end + 1);
            int type = bytes.getInt();
            bytes.getInt();
            if (type < Exr.UNSIGNED || type > Exr.FLOAT) {
                throw new IOException("channel " + name + " has the unknown type " + type);
            }
            if (bytes.getInt() != 1 || bytes.getInt() != 1) {
                throw new IOException("channel " + name + " does not have a sample for every pixel");
            }
            channels.add(new Channel(name, type));
        }
    }

    private static byte[] value(ImageSource source, String name, int length) throws IOException {
        if (length < 1 || length > LARGEST_ATTRIBUTE) {
            throw new IOException("the attribute " + name + " has " + length + " bytes");
        }
        byte[] value = new byte[length];
        source.next(value);
        return value;
    }

    private static void skip(ImageSource source, String name, int length) throws IOException {
        if (length < 0) {
            throw new IOException("the attribute " + name + " has " + length + " bytes");
        }
        source.in().skipNBytes(length);
    }

    int rowsPerBlock() {
        return compression == Exr.ZIP ? Exr.ROWS_PER_ZIP_BLOCK : 1;
    }

    /** The bytes of one pixel in all channels. */
    int bytesPerPixel() {
        return channels.stream().mapToInt(Channel::bytes).sum();
    }

    /**
     * For each channel, which of red (0), green (1) and blue (2) it is; grey (Y, if there is no R) is red, −1 is any
     * other.
     */
    int[] roles() throws IOException {
        boolean grey = isGrey();
        int[] roles = channels.stream()
                .mapToInt(c -> grey
                        ? (c.name().equals("Y") ? 0 : -1)
                        : List.of("R", "G", "B").indexOf(c.name()))
                .toArray();
        long found = Arrays.stream(roles).filter(r -> r >= 0).count();
        if (found != (grey ? 1 : 3)) {
            List<String> names = channels.stream().map(Channel::name).toList();
            throw new IOException("the channels are " + names + "; R, G and B, or Y, are needed");
        }
        for (int i = 0; i < roles.length; i++) {
            if (roles[i] >= 0 && channels.get(i).type() == Exr.UNSIGNED) {
                throw new IOException(
                        "channel " + channels.get(i).name() + " holds integers; halfs and floats are read");
            }
        }
        return roles;
    }

    boolean isGrey() {
        return channels.stream().noneMatch(c -> c.name().equals("R"));
    }
}
