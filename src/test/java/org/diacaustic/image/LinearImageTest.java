package org.diacaustic.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.diacaustic.math.Color;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class LinearImageTest {
    @ParameterizedTest
    @CsvSource({"0, 0", "0, 5", "5, 0", "-1, 3"})
    void new_givenSideNotPositive_refuses(int width, int height) {
        assertThatThrownBy(() -> new LinearImage(width, height))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining(width + " x " + height);
    }

    /** 65536² is 0 in 32 bits, and 100000² is a positive int: the product must not decide in int. */
    @ParameterizedTest
    @CsvSource({"100000, 100000", "65536, 65536", "2147483647, 2147483647", "715827881, 1"})
    void new_givenTooManyPixels_refusesBeforeAllocation(int width, int height) {
        assertThatThrownBy(() -> new LinearImage(width, height))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining(width + " x " + height)
                .hasMessageContaining(String.valueOf(12L * width * height));
    }

    @Test
    void set_givenPixel_changesThatPixelOnly() {
        LinearImage image = new LinearImage(3, 2);
        image.set(2, 1, new Color(0.5, 0.25, 7));
        assertThat(image.get(2, 1)).isEqualTo(new Color(0.5, 0.25, 7));
        // Row 1 begins after the three pixels of row 0.
        assertThat(image.offset(2, 1)).isEqualTo(15);
        float[] expected = new float[18];
        expected[15] = 0.5f;
        expected[16] = 0.25f;
        expected[17] = 7;
        assertThat(image.samples()).containsExactly(expected);
    }

    @ParameterizedTest
    @CsvSource({"3, 0", "-1, 1", "0, 2", "0, -1"})
    void get_givenNoSuchPixel_throws(int x, int y) {
        LinearImage image = new LinearImage(3, 2);
        assertThatThrownBy(() -> image.get(x, y)).isInstanceOf(IndexOutOfBoundsException.class);
    }
}
