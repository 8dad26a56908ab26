package org.diacaustic.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class ExposureTest {
    @ParameterizedTest
    @ValueSource(doubles = {0, -1, Double.NaN, Double.POSITIVE_INFINITY})
    void fixed_givenFactorNotPositiveAndFinite_refuses(double factor) {
        assertThatThrownBy(() -> Exposure.fixed(factor))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining(String.valueOf(factor));
    }

    @ParameterizedTest
    @CsvSource({
        "0, 0",
        "0.0031308, 10",
        "0.18, 118",
        "0.5, 188",
        "1, 255",
        "1e30, 255",
        "-1, 0",
        "NaN, 0",
        "Infinity, 255",
        "-Infinity, 0"
    })
    void srgb8_givenLinearValue_isNearestCode(double linear, int code) {
        assertThat(Exposure.fixed(1).srgb8(linear)).isEqualTo(code);
        assertThat(Exposure.fixed(4).srgb8(linear / 4)).isEqualTo(code);
    }

    /** The look-up of steps against the curve itself, on a fine grid and next to every step. */
    @Test
    void srgb8_givenAnyLinearValue_isRoundedCurve() {
        Exposure exposure = Exposure.fixed(1);
        for (int i = 0; i <= 100_000; i++) {
            double linear = i / 100_000.0;
            assertThat(exposure.srgb8(linear)).isEqualTo((int) Math.round(255 * SrgbCurve.encode(linear)));
        }
        for (int code = 0; code < 255; code++) {
            double step = SrgbCurve.decode((code + 0.5) / 255);
            assertThat(exposure.srgb8(step * (1 - 1e-12))).isEqualTo(code);
            assertThat(exposure.srgb8(step * (1 + 1e-12))).isEqualTo(code + 1);
            assertThat(exposure.srgb8(SrgbCurve.decodeByte(code))).isEqualTo(code);
        }
    }

    /** 1 − e⁻¹ = 0.63212055882855767…; a tiny value is kept, a huge one is white. */
    @Test
    void map_givenExponential_keepsItsDigits() {
        assertThat(ToneMapping.EXPONENTIAL.map(1e-30)).isEqualTo(1e-30);
        assertThat(ToneMapping.EXPONENTIAL.map(1)).isCloseTo(0.6321205588285576784, within(2e-16));
        assertThat(ToneMapping.EXPONENTIAL.map(1e30)).isEqualTo(1);
        assertThat(ToneMapping.EXPONENTIAL.map(-3)).isZero();
        Exposure film = Exposure.fixed(2).with(ToneMapping.EXPONENTIAL);
        // 0.632… is sRGB 0.8159, 208.06 of 255.
        assertThat(film.srgb8(0.5)).isEqualTo(208);
        assertThat(film.srgb8(Double.POSITIVE_INFINITY)).isEqualTo(255);
        assertThat(film.srgb8(Double.NaN)).isZero();
    }

    @Test
    void auto_givenBlackOrNonFiniteImage_isOne() {
        assertThat(Exposure.auto(new LinearImage(4, 4))).isEqualTo(Exposure.fixed(1));
        assertThat(Exposure.auto(TestImages.grey(Double.NaN, -2, Double.POSITIVE_INFINITY)))
                .isEqualTo(Exposure.fixed(1));
    }

    /** Luminances 1…1000 on black: the 990th of the lit ones becomes 0.9, whatever the black pixels and a few spikes. */
    @Test
    void auto_givenKnownLuminances_mapsHighPercentileNearWhite() {
        double[] values = new double[5000];
        for (int i = 0; i < 1000; i++) {
            values[4999 - i] = i < 5 ? 1e20 : 1001 - (i + 1);
        }
        float bright = (float) (0.2126 * 990 + 0.7152 * 990 + 0.0722 * 990);
        assertThat(Exposure.auto(TestImages.grey(values)).factor()).isEqualTo(0.9 / bright);
    }

    @ParameterizedTest
    @ValueSource(ints = {-40, -1, 1, 13, 60})
    void auto_givenImageScaledByPowerOfTwo_scalesInverselyAndExactly(int power) {
        LinearImage image = TestImages.lively(61, 47);
        double factor = Exposure.auto(image).factor();
        LinearImage scaled = TestImages.scaled(image, Math.scalb(1.0, power));
        assertThat(Exposure.auto(scaled).factor()).isEqualTo(Math.scalb(factor, -power));
    }
}
