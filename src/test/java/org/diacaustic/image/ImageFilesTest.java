package org.diacaustic.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;

class ImageFilesTest {
    private static final Exposure EXPOSURE = Exposure.fixed(1);

    @TempDir
    Path folder;

    static Stream<Arguments> formatsAndSizes() {
        int[][] sizes = {{1, 1}, {7, 3}, {8, 2}, {1, 40}, {37, 19}, {200, 33}, {65535, 1}};
        return Stream.of(ImageFormat.values())
                .flatMap(format -> Stream.of(sizes).map(s -> Arguments.of(format, s[0], s[1])));
    }

    @ParameterizedTest
    @MethodSource("formatsAndSizes")
    void read_givenWrittenImage_returnsIt(ImageFormat format, int width, int height) throws IOException {
        LinearImage image = TestImages.lively(width, height);
        Path file = folder.resolve("image." + format.ending());
        ImageFiles.write(image, EXPOSURE, file);
        LinearImage back = ImageFiles.read(file);
        assertThat(back.width()).isEqualTo(width);
        assertThat(back.height()).isEqualTo(height);
        assertThat(back.samples()).isEqualTo(expected(image, format));
    }

    /** What each format keeps: the very floats, pixels with a shared exponent, or the values of sRGB codes. */
    private static float[] expected(LinearImage image, ImageFormat format) {
        float[] samples = image.samples().clone();
        byte[] rgbe = new byte[4];
        for (int i = 0; i < samples.length; i += 3) {
            if (format == ImageFormat.HDR) {
                Rgbe.encode(samples[i], samples[i + 1], samples[i + 2], rgbe, 0);
                Rgbe.decode(rgbe, 0, 1, samples, i);
            } else if (!format.isLinear()) {
                for (int channel = i; channel < i + 3; channel++) {
                    samples[channel] = SrgbCurve.decodeByte(EXPOSURE.srgb8(samples[channel]));
                }
            }
        }
        return samples;
    }

    @ParameterizedTest
    @EnumSource
    void read_givenFileCutShort_namesFileAndFault(ImageFormat format) throws IOException {
        Path file = folder.resolve("image." + format.ending());
        ImageFiles.write(TestImages.lively(31, 17), EXPOSURE, file);
        byte[] whole = Files.readAllBytes(file);
        for (int length : new int[] {0, 3, 10, 20, whole.length / 2, whole.length - 70}) {
            Files.write(file, Arrays.copyOf(whole, length));
            assertThatThrownBy(() -> ImageFiles.read(file))
                    .as("%s cut to %d bytes", format, length)
                    .isInstanceOf(IOException.class)
                    .isNotInstanceOf(ImageTooLargeException.class)
                    .hasMessageContaining(file.toString());
        }
    }

    /** Whatever the damage, the answer is an image or an IOException. */
    @ParameterizedTest
    @EnumSource
    void read_givenDamagedBytes_neverThrowsAnythingElse(ImageFormat format) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        format.codec().write(TestImages.lively(9, 5), EXPOSURE, out);
        byte[] bytes = out.toByteArray();
        int refused = 0;
        for (int i = 0; i < Math.min(bytes.length, 400); i++) {
            for (int damage : new int[] {0xff, 0x80, 0x01}) {
                bytes[i] ^= (byte) damage;
                try {
                    format.codec().read(new ImageSource(new ByteArrayInputStream(bytes), 1 << 20));
                } catch (IOException e) {
                    refused++;
                }
                bytes[i] ^= (byte) damage;
            }
        }
        assertThat(refused).isPositive();
    }

    @Test
    void read_givenUnknownContent_saysSo() throws IOException {
        Path file = folder.resolve("image.jpg");
        Files.writeString(file, "this is no image");
        assertThatThrownBy(() -> ImageFiles.read(file))
                .isInstanceOf(IOException.class)
                .hasMessage(file + ": the content is no image of a known kind");
    }

    @Test
    void read_givenMissingFile_throwsNoSuchFile() {
        assertThatThrownBy(() -> ImageFiles.read(folder.resolve("none.exr"))).isInstanceOf(NoSuchFileException.class);
    }

    /** 12 bytes for each pixel of the image; the JDK's decoders are allowed 8 more. */
    @ParameterizedTest
    @EnumSource
    void read_givenLimitBelowNeed_tellsTheNeedAndAllocatesNothing(ImageFormat format) throws IOException {
        Path file = folder.resolve("image." + format.ending());
        ImageFiles.write(TestImages.lively(100, 50), EXPOSURE, file);
        ImageTooLargeException refusal =
                catchThrowableOfType(ImageTooLargeException.class, () -> ImageFiles.read(file, 50_000));
        assertThat(refusal).hasMessageContaining(file.toString()).hasMessageContaining("100 x 50");
        assertThat(refusal.neededBytes()).isBetween(60_000L, 120_000L);
        assertThat(refusal.limitBytes()).isEqualTo(50_000);
        assertThat(ImageFiles.read(file, refusal.neededBytes()).height()).isEqualTo(50);
    }

    @Test
    void write_givenUnknownEndingOrTooLargeImage_writesNothing() throws IOException {
        assertThatThrownBy(() -> ImageFiles.write(new LinearImage(1, 1), EXPOSURE, folder.resolve("a.bmp")))
                .isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> ImageFiles.write(new LinearImage(65536, 1), EXPOSURE, folder.resolve("a.tga")))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("65535");
        assertThat(folder).isEmptyDirectory();
    }

    @ParameterizedTest
    @EnumSource
    void write_givenSameImageTwice_givesSameBytes(ImageFormat format) throws IOException {
        Path first = folder.resolve("first." + format.ending());
        Path second = folder.resolve("second." + format.ending());
        ImageFiles.write(TestImages.lively(50, 40), EXPOSURE, first);
        ImageFiles.write(TestImages.lively(50, 40), EXPOSURE, second);
        assertThat(first).hasSameBinaryContentAs(second);
    }

    /** Not-a-number and −1 are black, +∞ is white; PFM and OpenEXR keep what they are given. */
    @ParameterizedTest
    @EnumSource
    void write_givenValuesThatAreNoRadiance_storesWhatIsDefined(ImageFormat format) throws IOException {
        LinearImage image = TestImages.grey(Double.NaN, -1, Double.POSITIVE_INFINITY, 0);
        Path file = folder.resolve("image." + format.ending());
        ImageFiles.write(image, EXPOSURE, file);
        float[] back = ImageFiles.read(file).samples();
        if (format == ImageFormat.PFM || format == ImageFormat.EXR) {
            assertThat(back).isEqualTo(image.samples());
        } else {
            // The largest RGBE pixel is 255·2^(255 − 136).
            float largest = format == ImageFormat.HDR ? 255 * 0x1p119f : 1;
            assertThat(back).containsExactly(0, 0, 0, 0, 0, 0, largest, largest, largest, 0, 0, 0);
        }
    }

    @Test
    void checkWritable_givenGoodTarget_changesNothing() throws IOException {
        ImageFiles.checkWritable(folder.resolve("a.png"));
        assertThat(folder).isEmptyDirectory();
    }

    @Test
    void checkWritable_givenBadTarget_saysWhy() throws IOException {
        assertThatThrownBy(() -> ImageFiles.checkWritable(folder.resolve("a.gif")))
                .isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> ImageFiles.checkWritable(folder.resolve("none/a.png")))
                .isInstanceOf(NoSuchFileException.class)
                .hasMessageContaining("none");
        Files.createFile(folder.resolve("file"));
        assertThatThrownBy(() -> ImageFiles.checkWritable(folder.resolve("file/a.png")))
                .isInstanceOf(FileSystemException.class);
        Files.createDirectory(folder.resolve("folder.png"));
        assertThatThrownBy(() -> ImageFiles.checkWritable(folder.resolve("folder.png")))
                .isInstanceOf(IOException.class)
                .hasMessageContaining("is a folder");
    }

    @Test
    void bytes_givenEveryFormat_areThoseOfTheFile() throws IOException {
        LinearImage image = TestImages.lively(5, 3);
        for (ImageFormat format : ImageFormat.values()) {
            Path file = folder.resolve("image." + format.ending());
            ImageFiles.write(image, Exposure.fixed(2), file);
            assertThat(ImageFiles.bytes(image, Exposure.fixed(2), format)).isEqualTo(Files.readAllBytes(file));
        }
    }
}
