package org.diacaustic.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.zip.Deflater;
import org.diacaustic.math.Color;
import org.junit.jupiter.api.Test;

/** OpenEXR files put together by hand from the description of the format. */
class ExrCodecTest {
    private static final int HALF_ONE = 0x3c00;

    private static byte[] littleEndian(int... values) {
        ByteBuffer bytes = ByteBuffer.allocate(4 * values.length).order(ByteOrder.LITTLE_ENDIAN);
        bytes.asIntBuffer().put(values);
        return bytes.array();
    }

    private static byte[] shorts(int... values) {
        ByteBuffer bytes = ByteBuffer.allocate(2 * values.length).order(ByteOrder.LITTLE_ENDIAN);
        for (int value : values) {
            bytes.putShort((short) value);
        }
        return bytes.array();
    }

    private static int bits(double value) {
        return Float.floatToIntBits((float) value);
    }

    private static byte[] attribute(String name, String type, byte[] value) {
        return CodecBytes.join(name, 0, type, 0, littleEndian(value.length), value);
    }

    /** A name with the number of its type after it: 0 integer, 1 half, 2 float. */
    private static byte[] channels(String... namesAndTypes) {
        ByteArrayOutputStream list = new ByteArrayOutputStream();
        for (String channel : namesAndTypes) {
            int last = channel.length() - 1;
            list.writeBytes(
                    CodecBytes.join(channel.substring(0, last), 0, littleEndian(channel.charAt(last) - '0', 0, 1, 1)));
        }
        list.write(0);
        return list.toByteArray();
    }

    private static byte[] start(int version, int compression, int[] window, String... channels) {
        return CodecBytes.join(
                littleEndian(20000630, version),
                attribute("owner", "string", "someone".getBytes()),
                attribute("channels", "chlist", channels(channels)),
                attribute("compression", "compression", new byte[] {(byte) compression}),
                attribute("dataWindow", "box2i", littleEndian(window)),
                0);
    }

    private static byte[] block(int y, byte[] data) {
        return CodecBytes.join(littleEndian(y, data.length), data);
    }

    /** Two rows, the second one first, in a window that begins at (10, −1); alpha and an integer channel between. */
    @Test
    void read_givenUncompressedHalfsAndFloats_findsItsChannels() throws IOException {
        byte[] file = CodecBytes.join(
                start(2, 0, new int[] {10, -1, 11, 0}, "A1", "B1", "G2", "Id0", "R1"),
                new byte[16],
                block(
                        0,
                        CodecBytes.join(
                                shorts(HALF_ONE, HALF_ONE),
                                shorts(0x7bff, 0x0001),
                                littleEndian(bits(5), bits(6)),
                                littleEndian(77, 78),
                                shorts(0xc000, 0x7c00))),
                block(
                        -1,
                        CodecBytes.join(
                                shorts(0, 0),
                                shorts(0x3800, 0x3400),
                                littleEndian(bits(7), bits(8)),
                                littleEndian(1, 2),
                                shorts(0x4000, 0x0400))));
        // Halfs: 3800 is 1/2, 3400 is 1/4, 4000 is 2, 0400 the smallest normal, 0001 the smallest, 7bff the largest.
        assertThat(CodecBytes.read(ImageFormat.EXR, file).samples())
                .containsExactly(2, 7, 0.5f, 0x1p-14f, 8, 0.25f, -2, 5, 65504, Float.POSITIVE_INFINITY, 6, 0x1p-24f);
    }

    /** One row to a block; bytes at even places first, then differences plus 128, then deflated. */
    @Test
    void read_givenGreyInZippedRows_givesGrey() throws IOException {
        float[] values = new float[40];
        int[] bits = new int[40];
        for (int i = 0; i < values.length; i++) {
            values[i] = 1 + i / 10;
            bits[i] = bits(values[i]);
        }
        byte[] raw = littleEndian(bits);
        byte[] ordered = new byte[raw.length];
        for (int i = 0; i < raw.length; i++) {
            ordered[i % 2 == 0 ? i / 2 : raw.length / 2 + i / 2] = raw[i];
        }
        byte[] differences = ordered.clone();
        for (int i = 1; i < raw.length; i++) {
            differences[i] = (byte) (ordered[i] - ordered[i - 1] + 128);
        }
        Deflater deflater = new Deflater();
        deflater.setInput(differences);
        deflater.finish();
        byte[] packed = new byte[raw.length];
        int length = deflater.deflate(packed);
        deflater.end();
        assertThat(length).isLessThan(raw.length);
        byte[] file = CodecBytes.join(
                start(2, 2, new int[] {0, 0, 39, 0}, "Y2"), new byte[8], block(0, Arrays.copyOf(packed, length)));
        LinearImage image = CodecBytes.read(ImageFormat.EXR, file);
        for (int x = 0; x < 40; x++) {
            assertThat(image.get(x, 0)).isEqualTo(Color.grey(values[x]));
        }
    }

    private static void assertRefused(String part, byte[]... parts) {
        byte[] file = CodecBytes.join((Object[]) parts);
        assertThatThrownBy(() -> CodecBytes.read(ImageFormat.EXR, file))
                .isInstanceOf(IOException.class)
                .hasMessageContaining(part);
    }

    @Test
    void read_givenWhatIsNotSupported_saysWhat() {
        int[] window = {0, 0, 0, 0};
        byte[] rest = new byte[100];
        assertRefused("not an OpenEXR file", rest);
        assertRefused("tiles", start(0x202, 0, window, "B2", "G2", "R2"), rest);
        assertRefused("tiles", start(0x1002, 0, window, "B2", "G2", "R2"), rest);
        assertRefused("PIZ", start(2, 4, window, "B2", "G2", "R2"), rest);
        assertRefused("number 77", start(2, 77, window, "B2", "G2", "R2"), rest);
        assertRefused("[Z]", start(2, 0, window, "Z2"), rest);
        assertRefused("[G, R]", start(2, 0, window, "G2", "R2"), rest);
        assertRefused("integers", start(2, 0, window, "B2", "G0", "R2"), rest);
        assertRefused("unknown type", start(2, 0, window, "B2", "G9", "R2"), rest);
        assertRefused("0 x 1", start(2, 0, new int[] {0, 0, -1, 0}, "B2", "G2", "R2"), rest);
        assertRefused("lacks", littleEndian(20000630, 2), rest);
    }

    @Test
    void read_givenBadBlocks_saysWhich() {
        byte[] start = start(2, 0, new int[] {0, 0, 0, 1}, "B2", "G2", "R2");
        byte[] table = new byte[16];
        byte[] pixel = new byte[12];
        assertRefused("row 2", start, table, block(2, pixel));
        assertRefused("row 0", start, table, block(0, pixel), block(0, pixel));
        assertRefused("13 bytes", start, table, block(0, new byte[13]));
        assertRefused("too short", start, table, block(0, new byte[11]));
        byte[] zipped = start(2, 3, new int[] {0, 0, 0, 1}, "B2", "G2", "R2");
        assertRefused("compressed block", zipped, new byte[8], block(0, new byte[11]));
    }

    /** 2³¹ pixels wide, and beyond: nothing is allocated for what the header claims. */
    @Test
    void read_givenHugeWindow_refuses() {
        assertRefused("bytes of memory", start(2, 0, new int[] {-2147483648, 0, 2147483647, 0}, "B2", "G2", "R2"));
        assertRefused("bytes of memory", start(2, 3, new int[] {0, 0, 49_999, 49_999}, "B2", "G2", "R2"));
    }
}
