package org.diacaustic.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class ImageFormatTest {
    @ParameterizedTest
    @ValueSource(strings = {"picture.jpeg2", "picture", "picture.", "folder.png/picture"})
    void of_givenUnknownEnding_listsTheKnown(String name) {
        assertThatThrownBy(() -> ImageFormat.of(Path.of(name)))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining(name)
                .hasMessageContaining(".png, .tga, .hdr, .pfm, .exr");
    }

    @ParameterizedTest
    @CsvSource({"a.png, PNG", "A.PNG, PNG", "x/y.b.Tga, TGA", "a.hdr, HDR", "a.pfm, PFM", "a.eXr, EXR"})
    void of_givenKnownEnding_ignoresCase(String name, ImageFormat format) {
        assertThat(ImageFormat.of(Path.of(name))).isEqualTo(format);
    }

    @Test
    void checkSize_givenSidesBeyond16Bits_isRefusedByTgaOnly() {
        assertThatThrownBy(() -> ImageFormat.TGA.checkSize(65536, 1))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("an image of 65536 x 1 pixels is too large for TGA, whose sides are at most 65535 pixels");
        assertThatThrownBy(() -> ImageFormat.TGA.checkSize(1, 65536)).isInstanceOf(IllegalArgumentException.class);
        ImageFormat.TGA.checkSize(65535, 65535);
        for (ImageFormat format : ImageFormat.values()) {
            if (format != ImageFormat.TGA) {
                assertThatCode(() -> format.checkSize(65536, 65536)).doesNotThrowAnyException();
            }
        }
    }
}
