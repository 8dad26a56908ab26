package org.diacaustic.image;

import java.io.FilterInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.util.zip.CRC32;

/**
 * Looks on while a PNG is read and compares the checksum of every chunk, which the reader of the JDK does not do. Other
 * content passes unseen.
 */
final class PngChecksums extends FilterInputStream {
    private static final long SIGNATURE = 0x89504e470d0a1a0aL;
    private static final int TYPE_BYTES = 4;

    /** What the next bytes are. */
    private enum Part {
        SIGNATURE,
        LENGTH,
        TYPE_AND_DATA,
        CHECKSUM,
        UNKNOWN
    }

    private final ByteBuffer field = ByteBuffer.allocate(Long.BYTES);
    private final CRC32 checksum = new CRC32();
    private Part part = Part.SIGNATURE;
    private long left = Long.BYTES;
    private boolean wrong;

    PngChecksums(InputStream in) {
        super(in);
    }

    /** Reads what is left of the file. */
    void requireSound() throws IOException {
        transferTo(OutputStream.nullOutputStream());
        if (wrong) {
            throw new IOException("the content is damaged (a checksum does not fit)");
        }
    }

    @Override
    public int read() throws IOException {
        byte[] one = new byte[1];
        return read(one, 0, 1) < 0 ? -1 : one[0] & 0xff;
    }

    @Override
    public int read(byte[] into, int from, int length) throws IOException {
        int count = in.read(into, from, length);
        for (int done = 0; done < count && part != Part.UNKNOWN; ) {
            int taken = (int) Math.min(left, count - done);
            take(into, from + done, taken);
            done += taken;
        }
        return count;
    }

    private void take(byte[] bytes, int from, int count) {
        if (part == Part.TYPE_AND_DATA) {
            checksum.update(bytes, from, count);
        } else {
            field.put(bytes, from, count);
        }
        left -= count;
        if (left == 0) {
            endPart();
        }
    }

    private void endPart() {
        field.flip();
        switch (part) {
            case SIGNATURE -> begin(field.getLong() == SIGNATURE ? Part.LENGTH : Part.UNKNOWN, Integer.BYTES);
            case LENGTH -> begin(Part.TYPE_AND_DATA, TYPE_BYTES + Integer.toUnsignedLong(field.getInt()));
            case TYPE_AND_DATA -> begin(Part.CHECKSUM, Integer.BYTES);
            default -> {
                wrong |= field.getInt() != (int) checksum.getValue();
                checksum.reset();
                begin(Part.LENGTH, Integer.BYTES);
            }
        }
        field.clear();
    }

    private void begin(Part next, long length) {
        part = next;
        left = length;
    }

    @Override
    public long skip(long count) throws IOException {
        return Math.max(0, read(new byte[(int) Math.min(count, 1 << 13)]));
    }

    @Override
    public boolean markSupported() {
        return false;
    }
}
