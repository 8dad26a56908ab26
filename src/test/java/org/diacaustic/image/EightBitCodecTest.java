package org.diacaustic.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.twelvemonkeys.imageio.plugins.tga.TGAImageReaderSpi;
import java.awt.image.BufferedImage;
import java.awt.image.WritableRaster;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.zip.CRC32;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.MemoryCacheImageInputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** PNG and TGA against readers and writers that are not ours. */
class EightBitCodecTest {
    private static void assertShows(BufferedImage picture, LinearImage image) {
        assertThat(picture.getWidth()).isEqualTo(image.width());
        assertThat(picture.getHeight()).isEqualTo(image.height());
        Exposure exposure = Exposure.fixed(1);
        for (int y = 0; y < image.height(); y++) {
            for (int x = 0; x < image.width(); x++) {
                int offset = image.offset(x, y);
                int expected = exposure.srgb8(image.samples()[offset]) << 16
                        | exposure.srgb8(image.samples()[offset + 1]) << 8
                        | exposure.srgb8(image.samples()[offset + 2]);
                assertThat(picture.getRGB(x, y) & 0xffffff)
                        .as("pixel (%d, %d)", x, y)
                        .isEqualTo(expected);
            }
        }
    }

    /** 300 × 200 noisy pixels take more than one data chunk. */
    @ParameterizedTest
    @CsvSource({"1, 1", "7, 3", "8, 8", "37, 19", "300, 200"})
    void write_givenPng_isReadByTheJdk(int width, int height) throws IOException {
        LinearImage image = TestImages.lively(width, height);
        byte[] file = CodecBytes.write(ImageFormat.PNG, image);
        assertShows(ImageIO.read(new ByteArrayInputStream(file)), image);
    }

    @ParameterizedTest
    @CsvSource({"1, 1", "7, 3", "128, 2", "129, 3", "300, 20"})
    void write_givenTga_isReadByTwelveMonkeys(int width, int height) throws IOException {
        LinearImage image = TestImages.lively(width, height);
        byte[] file = CodecBytes.write(ImageFormat.TGA, image);
        ImageReader reader = new TGAImageReaderSpi().createReaderInstance(null);
        reader.setInput(new MemoryCacheImageInputStream(new ByteArrayInputStream(file)));
        assertShows(reader.read(0), image);
    }

    /** Unpacked by hand: run-length true colour of 24 bits, rows from the top left, blue first. */
    @Test
    void write_givenTga_followsTheFormat() {
        LinearImage image = new LinearImage(5, 2);
        image.set(0, 0, 1, 0.5, 0);
        byte[] file = CodecBytes.write(ImageFormat.TGA, image);
        byte[] header = {0, 0, 10, 0, 0, 0, 0, 0, 0, 0, 0, 0, 5, 0, 2, 0, 24, 0x20};
        assertThat(Arrays.copyOf(file, 18)).isEqualTo(header);
        byte[] codes = new byte[30];
        int at = 18;
        for (int done = 0; done < codes.length; ) {
            boolean run = file[at] < 0;
            int count = (file[at++] & 0x7f) + 1;
            for (int i = 0; i < 3 * count; i++) {
                codes[done++] = file[at + (run ? i % 3 : i)];
            }
            at += run ? 3 : 3 * count;
        }
        byte[] expected = new byte[30];
        expected[1] = (byte) 188;
        expected[2] = (byte) 255;
        assertThat(codes).isEqualTo(expected);
        assertThat(new String(file, file.length - 18, 17)).isEqualTo("TRUEVISION-XFILE.");
        assertThat(at + 26).isEqualTo(file.length);
    }

    @Test
    void write_givenPng_isMarkedAsSrgbAndShrinksPlainPictures() {
        byte[] file = CodecBytes.write(ImageFormat.PNG, TestImages.constant(500, 400, 0.3, 0.2, 0.1));
        assertThat(new String(file, 37, 4)).isEqualTo("sRGB");
        assertThat(new String(file, 50, 23)).isEqualTo("tEXtSoftware\0Diacaustic");
        assertThat(file).hasSizeLessThan(5000);
    }

    private static byte[] encoded(BufferedImage picture, String kind) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        assertThat(ImageIO.write(picture, kind, out)).isTrue();
        return out.toByteArray();
    }

    /** Java's colour model takes grey codes for linear light and would give 0.5 here. */
    @Test
    void read_givenGreyPng_undoesTheSrgbCurve() throws IOException {
        BufferedImage picture = new BufferedImage(2, 1, BufferedImage.TYPE_BYTE_GRAY);
        picture.getRaster().setSample(1, 0, 0, 128);
        float[] samples =
                CodecBytes.read(ImageFormat.PNG, encoded(picture, "png")).samples();
        float middle = (float) SrgbCurve.decode(128 / 255.0);
        assertThat(middle).isBetween(0.2158f, 0.2159f);
        assertThat(samples).containsExactly(0, 0, 0, middle, middle, middle);
    }

    @Test
    void read_givenSixteenBitGrey_keepsItsSteps() throws IOException {
        BufferedImage picture = new BufferedImage(2, 1, BufferedImage.TYPE_USHORT_GRAY);
        picture.getRaster().setSample(0, 0, 0, 1);
        picture.getRaster().setSample(1, 0, 0, 32768);
        float[] samples =
                CodecBytes.read(ImageFormat.PNG, encoded(picture, "png")).samples();
        // The straight part of the curve: 1 / 65535 / 12.92.
        assertThat(samples[0]).isEqualTo((float) (1 / 65535.0 / 12.92));
        assertThat(samples[3]).isEqualTo((float) SrgbCurve.decode(32768 / 65535.0));
    }

    @ParameterizedTest
    @ValueSource(
            ints = {
                BufferedImage.TYPE_INT_RGB,
                BufferedImage.TYPE_INT_ARGB,
                BufferedImage.TYPE_4BYTE_ABGR,
                BufferedImage.TYPE_BYTE_INDEXED
            })
    void read_givenAnyKindOfPng_givesTheSameLight(int type) throws IOException {
        BufferedImage picture = new BufferedImage(2, 1, type);
        // 0, 51, 102, … are in the palette of indexed pictures.
        picture.setRGB(1, 0, 0xff_66_33_cc);
        float[] samples =
                CodecBytes.read(ImageFormat.PNG, encoded(picture, "png")).samples();
        assertThat(samples)
                .containsExactly(
                        0, 0, 0, SrgbCurve.decodeByte(0x66), SrgbCurve.decodeByte(0x33), SrgbCurve.decodeByte(0xcc));
    }

    @Test
    void read_givenJpegAndBmp_isReadByContent() throws IOException {
        BufferedImage picture = new BufferedImage(16, 8, BufferedImage.TYPE_INT_RGB);
        WritableRaster raster = picture.getRaster();
        for (int i = 0; i < 128; i++) {
            raster.setPixel(i % 16, i / 16, new int[] {188, 188, 188});
        }
        for (String kind : new String[] {"jpg", "bmp"}) {
            LinearImage image = CodecBytes.read(ImageFormat.PNG, encoded(picture, kind));
            assertThat(image).hasToString("16 x 8 pixels");
            // sRGB 188 is 0.5029 in linear light; JPEG may err by a code.
            for (float sample : image.samples()) {
                assertThat(sample).isBetween(0.495f, 0.51f);
            }
        }
    }

    /** The JDK fills up such a file with grey and calls that a warning. */
    @Test
    void read_givenJpegCutShort_refuses() throws IOException {
        BufferedImage picture = new BufferedImage(64, 64, BufferedImage.TYPE_INT_RGB);
        for (int i = 0; i < 4096; i++) {
            picture.setRGB(i % 64, i / 64, i * 7919);
        }
        byte[] file = encoded(picture, "jpg");
        assertThatThrownBy(() -> CodecBytes.read(ImageFormat.PNG, Arrays.copyOf(file, file.length / 2)))
                .isInstanceOf(IOException.class);
    }

    /** A header of 50000 × 50000 pixels, 2.5e9 of 12 bytes and 8 more to decode, with nothing behind it. */
    @Test
    void read_givenImageBomb_refusesFromTheHeader() {
        byte[] type = "IHDR".getBytes();
        byte[] size = ByteBuffer.allocate(13)
                .putInt(50_000)
                .putInt(50_000)
                .put((byte) 8)
                .put((byte) 2)
                .array();
        CRC32 checksum = new CRC32();
        checksum.update(type);
        checksum.update(size);
        byte[] file = CodecBytes.join(
                0x89,
                "PNG\r\n\u001a\n",
                new byte[] {0, 0, 0, 13},
                type,
                size,
                ByteBuffer.allocate(4).putInt((int) checksum.getValue()).array(),
                new byte[] {0, 0, 0, 0},
                "IDAT",
                new byte[] {0x35, (byte) 0xaf, 0x06, 0x1e});
        assertThatThrownBy(() -> CodecBytes.read(ImageFormat.PNG, file))
                .isInstanceOfSatisfying(ImageTooLargeException.class, e -> {
                    assertThat(e.neededBytes()).isEqualTo(50_000_000_000L);
                    assertThat(e.limitBytes()).isEqualTo(1 << 28);
                });
    }
}
