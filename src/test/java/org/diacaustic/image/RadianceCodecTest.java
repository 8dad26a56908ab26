package org.diacaustic.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.twelvemonkeys.imageio.plugins.hdr.HDRImageReadParam;
import com.twelvemonkeys.imageio.plugins.hdr.HDRImageReaderSpi;
import com.twelvemonkeys.imageio.plugins.hdr.tonemap.NullToneMapper;
import java.awt.image.Raster;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import javax.imageio.ImageReader;
import javax.imageio.stream.MemoryCacheImageInputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class RadianceCodecTest {
    private static final String HEADER = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n";

    /** That reader takes every file for one with run lengths, so narrower images are out of its reach. */
    @ParameterizedTest
    @CsvSource({"8, 5", "9, 4", "127, 3", "128, 3", "513, 3", "32767, 2"})
    void write_givenImage_isReadByTwelveMonkeysWithinOneStep(int width, int height) throws IOException {
        LinearImage image = TestImages.lively(width, height);
        ImageReader reader = new HDRImageReaderSpi().createReaderInstance(null);
        HDRImageReadParam param = (HDRImageReadParam) reader.getDefaultReadParam();
        param.setToneMapper(new NullToneMapper());
        byte[] file = CodecBytes.write(ImageFormat.HDR, image);
        reader.setInput(new MemoryCacheImageInputStream(new ByteArrayInputStream(file)));
        Raster raster = reader.read(0, param).getRaster();
        assertThat(raster.getWidth()).isEqualTo(width);
        assertThat(raster.getHeight()).isEqualTo(height);
        float[] pixel = new float[3];
        for (int i = 0; i < width * height; i++) {
            raster.getPixel(i % width, i / width, pixel);
            float[] samples = image.samples();
            float largest = Math.max(samples[3 * i], Math.max(samples[3 * i + 1], samples[3 * i + 2]));
            for (int channel = 0; channel < 3; channel++) {
                assertThat(Math.abs(pixel[channel] - samples[3 * i + channel])).isLessThanOrEqualTo(largest / 256);
            }
        }
    }

    private static String sizeAndPixels(int width) {
        byte[] file = CodecBytes.write(ImageFormat.HDR, TestImages.constant(width, 1, 1, 0.5, 0.25));
        return new String(file, StandardCharsets.ISO_8859_1).substring(HEADER.length());
    }

    @Test
    void write_givenWidth_choosesFlatOrRunLengths() {
        String pixel = "\u0080\u0040\u0020\u0081";
        assertThat(sizeAndPixels(7)).isEqualTo("-Y 1 +X 7\n" + pixel.repeat(7));
        assertThat(sizeAndPixels(8))
                .isEqualTo("-Y 1 +X 8\n\2\2\0\u0008" + "\u0088\u0080\u0088\u0040\u0088\u0020\u0088\u0081");
        // 200 = 127 + 73; 128 + 73 is 201.
        assertThat(sizeAndPixels(200)).startsWith("-Y 1 +X 200\n\2\2\0\u00c8\u00ff\u0080\u00c9\u0080\u00ff\u0040");
        assertThat(sizeAndPixels(32767)).startsWith("-Y 1 +X 32767\n\2\2\u007f\u00ff");
        assertThat(sizeAndPixels(32768)).isEqualTo("-Y 1 +X 32768\n" + pixel.repeat(32768));
    }

    @Test
    void read_givenOldRunLengths_repeatsThePixelBefore() throws IOException {
        // One pixel, repeated 2 + 1·256 times: the second count is shifted by eight bits.
        byte[] file =
                CodecBytes.join(HEADER, "-Y 1 +X 260\n", 128, 64, 32, 129, 1, 1, 1, 2, 1, 1, 1, 1, 128, 0, 0, 130);
        LinearImage image = CodecBytes.read(ImageFormat.HDR, file);
        for (int x = 0; x < 259; x++) {
            assertThat(image.get(x, 0).red()).isEqualTo(1);
            assertThat(image.get(x, 0).blue()).isEqualTo(0.25);
        }
        assertThat(image.get(259, 0).red()).isEqualTo(2);
    }

    @Test
    void read_givenExposures_undoesThem() throws IOException {
        byte[] file = CodecBytes.join("#?RGBE\nEXPOSURE=4\n# a comment\nEXPOSURE= 0.5\n\n-Y 1 +X 1\n", 128, 64, 0, 129);
        assertThat(CodecBytes.read(ImageFormat.HDR, file).samples()).containsExactly(0.5f, 0.25f, 0);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "RADIANCE\n\n-Y 1 +X 1\n",
                "#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n",
                "#?RADIANCE\nEXPOSURE=0\n\n-Y 1 +X 1\n",
                "#?RADIANCE\nEXPOSURE=x\n\n-Y 1 +X 1\n",
                "#?RADIANCE\n\n+Y 1 +X 1\n",
                "#?RADIANCE\n\n-Y 0 +X 1\n",
                "#?RADIANCE\n\n-Y 1 +X 8\n\2\2\0\u0009",
                "#?RADIANCE\n\n-Y 1 +X 8\n\2\2\0\u0008\u0089\1",
                "#?RADIANCE\n\n-Y 1 +X 8\n\2\2\0\u0008\0\1",
                "#?RADIANCE\n\n-Y 1 +X 2\n\1\1\1\1",
            })
    void read_givenFault_namesIt(String start) {
        byte[] file = CodecBytes.join(start, new byte[64]);
        assertThatThrownBy(() -> CodecBytes.read(ImageFormat.HDR, file))
                .isInstanceOf(IOException.class)
                .hasMessageMatching("(not a Radiance|the |a r).*");
    }

    /** Rounding or truncation are both legal: a mantissa may differ by 1 from the one given. */
    @ParameterizedTest
    @CsvSource({
        "1, 0.5, 0.25, 128, 64, 32, 129",
        "1e-33, 0, 0, 0, 0, 0, 0",
        "1e30, 1e-30, 1, 201, 0, 0, 228",
        "0.999, 0.1, 0, 255, 25, 0, 128",
        "Infinity, 3e38, NaN, 255, 255, 0, 255",
        "-5, 0, NaN, 0, 0, 0, 0"
    })
    void encode_givenColour_isWithinOneMantissa(float red, float green, float blue, int r, int g, int b, int e) {
        byte[] pixel = new byte[4];
        Rgbe.encode(red, green, blue, pixel, 0);
        assertThat(pixel[0] & 0xff).isBetween(r - 1, r + 1);
        assertThat(pixel[1] & 0xff).isBetween(g - 1, g + 1);
        assertThat(pixel[2] & 0xff).isBetween(b - 1, b + 1);
        assertThat(pixel[3] & 0xff).isEqualTo(e);
    }

    @Test
    void decode_givenEncodedColour_isWithin256thOfTheLargest() {
        float[] samples = TestImages.lively(500, 3).samples();
        byte[] pixel = new byte[4];
        byte[] again = new byte[4];
        float[] back = new float[3];
        for (int i = 0; i < samples.length; i += 3) {
            Rgbe.encode(samples[i], samples[i + 1], samples[i + 2], pixel, 0);
            Rgbe.decode(pixel, 0, 1, back, 0);
            float largest = Math.max(samples[i], Math.max(samples[i + 1], samples[i + 2]));
            for (int channel = 0; channel < 3; channel++) {
                assertThat(Math.abs(back[channel] - samples[i + channel])).isLessThanOrEqualTo(largest / 256);
            }
            Rgbe.encode(back[0], back[1], back[2], again, 0);
            assertThat(again).isEqualTo(pixel);
        }
    }
}
