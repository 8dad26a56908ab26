package org.diacaustic.image;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.BitSet;

/**
 * Reads OpenEXR: R, G and B, or Y, as halfs or floats, uncompressed or by ZIP. Other channels are passed over. Blocks
 * say where they belong, so their table is not needed.
 */
final class ExrReader {
    private static final int LARGEST_BLOCK = Integer.MAX_VALUE - 8;

    private final ImageSource source;
    private final ExrHeader header;
    private final int[] roles;
    private final boolean grey;
    private final LinearImage image;
    private final int rowBytes;
    private final byte[] packed;
    private final byte[] scratch;
    private final byte[] raw;

    private ExrReader(ImageSource source, ExrHeader header) throws IOException {
        this.source = source;
        this.header = header;
        this.roles = header.roles();
        this.grey = header.isGrey();
        long rows = Math.min(header.rowsPerBlock(), header.height());
        long blockBytes = header.width() * header.bytesPerPixel() * rows;
        this.image = source.newImage(header.width(), header.height(), 3 * blockBytes);
        if (blockBytes > LARGEST_BLOCK) {
            throw new IOException("a block of rows is " + blockBytes + " bytes long");
        }
        this.rowBytes = image.width() * header.bytesPerPixel();
        this.packed = new byte[(int) blockBytes];
        this.scratch = new byte[(int) blockBytes];
        this.raw = new byte[(int) blockBytes];
    }

    static LinearImage read(ImageSource source) throws IOException {
        return new ExrReader(source, ExrHeader.read(source)).read();
    }

    private LinearImage read() throws IOException {
        int rows = header.rowsPerBlock();
        int blocks = (image.height() - 1) / rows + 1;
        source.in().skipNBytes((long) Long.BYTES * blocks);
        BitSet done = new BitSet(blocks);
        byte[] start = new byte[2 * Integer.BYTES];
        for (int i = 0; i < blocks; i++) {
            ByteBuffer ints = source.next(start);
            long row = (long) ints.getInt() - header.top();
            if (row < 0 || row >= image.height() || row % rows != 0 || done.get((int) row / rows)) {
                throw new IOException("a block says that it begins at row " + row);
            }
            done.set((int) row / rows);
            readBlock((int) row, Math.min(rows, image.height() - (int) row), ints.getInt());
        }
        return image;
    }

    private void readBlock(int top, int rows, int packedLength) throws IOException {
        int length = rows * rowBytes;
        if (packedLength < 0 || packedLength > length) {
            throw new IOException("the block at row " + top + " says that it is " + packedLength + " bytes long");
        }
        source.next(packed, packedLength);
        // A block that compression would not make smaller is stored as it is.
        byte[] block = packed;
        if (packedLength < length) {
            if (header.compression() == Exr.NO_COMPRESSION) {
                throw new IOException("the block at row " + top + " is too short");
            }
            Exr.inflate(packed, packedLength, scratch, raw, length);
            block = raw;
        }
        ByteBuffer bytes = ByteBuffer.wrap(block).order(ByteOrder.LITTLE_ENDIAN);
        for (int y = top; y < top + rows; y++) {
            readRow(bytes, image.offset(0, y));
        }
    }

    private void readRow(ByteBuffer bytes, int offset) {
        float[] samples = image.samples();
        for (int channel = 0; channel < roles.length; channel++) {
            ExrHeader.Channel type = header.channels().get(channel);
            if (roles[channel] < 0) {
                bytes.position(bytes.position() + image.width() * type.bytes());
                continue;
            }
            int at = offset + roles[channel];
            for (int x = 0; x < image.width(); x++, at += 3) {
                float value =
                        type.type() == Exr.HALF ? Exr.half(bytes.getShort()) : Float.intBitsToFloat(bytes.getInt());
                samples[at] = value;
            }
        }
        if (grey) {
            for (int at = offset; at < offset + 3 * image.width(); at += 3) {
                samples[at + 1] = samples[at];
                samples[at + 2] = samples[at];
            }
        }
    }
}
