package org.diacaustic.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class FloatMapCodecTest {
    private static byte[] floats(ByteOrder order, float... values) {
        ByteBuffer bytes = ByteBuffer.allocate(Float.BYTES * values.length).order(order);
        bytes.asFloatBuffer().put(values);
        return bytes.array();
    }

    /** The bottom row comes first. */
    @Test
    void write_givenTwoRows_followsTheFormat() {
        LinearImage image = new LinearImage(1, 2);
        image.set(0, 0, 1, 2, 3);
        image.set(0, 1, 4, 5, -6);
        byte[] expected = CodecBytes.join("PF\n1 2\n-1.0\n", floats(ByteOrder.LITTLE_ENDIAN, 4, 5, -6, 1, 2, 3));
        assertThat(CodecBytes.write(ImageFormat.PFM, image)).isEqualTo(expected);
    }

    @Test
    void read_givenBigEndianGrey_givesGrey() throws IOException {
        byte[] file = CodecBytes.join("Pf 2 2\n1.0\n", floats(ByteOrder.BIG_ENDIAN, 3, 4, 1, 2));
        assertThat(CodecBytes.read(ImageFormat.PFM, file).samples())
                .containsExactly(1, 1, 1, 2, 2, 2, 3, 3, 3, 4, 4, 4);
    }

    @Test
    void read_givenBigEndianColour_givesColour() throws IOException {
        byte[] file = CodecBytes.join("PF\n1 1\n2.5\n", floats(ByteOrder.BIG_ENDIAN, 3, 4, 1e-30f));
        assertThat(CodecBytes.read(ImageFormat.PFM, file).samples()).containsExactly(3, 4, 1e-30f);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "P6\n1 1\n255\n",
                "PF\n0 1\n-1\n",
                "PF\n-3 1\n-1\n",
                "PF\n1.5 1\n-1\n",
                "PF\n1 1\n0\n",
                "PF\n1 1\nNaN\n",
                "PF\n1 1\nx\n",
                "PF\n9999999999 1\n-1\n"
            })
    void read_givenBadHeader_namesTheFault(String header) {
        byte[] file = CodecBytes.join(header, new byte[12]);
        assertThatThrownBy(() -> CodecBytes.read(ImageFormat.PFM, file))
                .isInstanceOf(IOException.class)
                .hasMessageMatching(
                        "(not a portable float map|the header |the image of 9999999999 x 1 pixels needs ).*");
    }
}
