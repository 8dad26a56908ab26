package org.diacaustic.fault;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.SplittableRandom;
import javax.imageio.ImageIO;
import org.diacaustic.image.Exposure;
import org.diacaustic.image.ImageFiles;
import org.diacaustic.image.ImageFormat;
import org.diacaustic.image.LinearImage;
import org.junit.jupiter.api.Test;

/** The readers that give a second opinion are told apart from those that would say yes to anything. */
class PlainReadersTest {
    /** Flat on the left, random on the right, so that there are runs and none; both longer than a run can be. */
    private static LinearImage picture(int width, int height) {
        LinearImage picture = new LinearImage(width, height);
        SplittableRandom random = new SplittableRandom(1);
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                boolean flat = x < width / 2;
                picture.set(x, y, flat ? 0.25 : random.nextDouble(), flat ? 0.5 : random.nextDouble(), 0.75);
            }
        }
        return picture;
    }

    private static byte[] file(LinearImage picture, ImageFormat format) {
        return ImageFiles.bytes(picture, Exposure.fixed(1), format);
    }

    @Test
    void png_givenOurs_agreesWithTheJdkAndNoticesAnyBit() throws IOException {
        byte[] file = file(picture(300, 3), ImageFormat.PNG);
        PlainPicture read = PlainPng.read(file);
        assertThat(read.isSameAs(PlainPicture.of(ImageIO.read(new ByteArrayInputStream(file)))))
                .isTrue();
        for (int at : new int[] {0, 12, 20, file.length / 2, file.length - 1}) {
            byte[] broken = file.clone();
            broken[at] ^= 1;
            assertThatThrownBy(() -> PlainPng.read(broken)).isInstanceOf(Exception.class);
        }
    }

    @Test
    void targa_givenOtherOrigin_turnsThePictureOver() throws IOException {
        byte[] file = file(picture(300, 3), ImageFormat.TGA);
        PlainPicture read = PlainReaders.targa(file);
        PlainPicture png = PlainPng.read(file(picture(300, 3), ImageFormat.PNG));
        assertThat(read.isSameAs(png)).isTrue();
        file[17] ^= 0x20;
        PlainPicture turned = PlainReaders.targa(file);
        assertThat(turned.isSameAs(png)).isFalse();
        assertThat(turned.codes()[3 * 299]).isEqualTo(png.codes()[3 * (2 * 300 + 299)]);
    }

    @Test
    void radianceAndFloatMap_givenOurs_findItsSizeAndSamples() throws IOException {
        for (int width : new int[] {3, 8, 300}) {
            LinearImage picture = picture(width, 4);
            PlainPicture radiance = PlainReaders.radiance(file(picture, ImageFormat.HDR));
            assertThat(radiance.width()).isEqualTo(width);
            // 0.25, 0.5, 0.75 have the exponent 2^0, which is stored as 128, and the codes 64, 128, 192.
            assertThat(radiance.codes()).startsWith(64, 128, 192, 128);
            assertThat(PlainReaders.floatMap(file(picture, ImageFormat.PFM), width, 4))
                    .isEqualTo(picture.samples());
        }
    }
}
