package org.diacaustic.page;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class NumbersTest {

    private static String plain(String text) {
        return text.replace('\u00a0', ' ');
    }

    @Test
    void percent_givenFractions_hasThreeDigitsOrSo() {
        assertThat(plain(Numbers.percent(1.234))).isEqualTo("123 %");
        assertThat(plain(Numbers.percent(0.1234))).isEqualTo("12.3 %");
        assertThat(plain(Numbers.percent(0.0421))).isEqualTo("4.21 %");
        assertThat(plain(Numbers.percent(0.000421))).isEqualTo("0.042 %");
        assertThat(plain(Numbers.percent(0))).isEqualTo("0 %");
        assertThat(Numbers.percent(Double.NaN)).isEqualTo("–");
    }

    @Test
    void signedPercent_givenSigns_tellsThem() {
        assertThat(plain(Numbers.signedPercent(0.05))).isEqualTo("+5.00 %");
        assertThat(plain(Numbers.signedPercent(-0.0123))).isEqualTo("−1.23 %");
        assertThat(plain(Numbers.signedPercent(-1e-9))).isEqualTo("0 %");
    }

    @Test
    void roundPercent_givenRoundFractions_hasNoZeros() {
        assertThat(plain(Numbers.roundPercent(0.1))).isEqualTo("10 %");
        assertThat(plain(Numbers.roundPercent(0.03))).isEqualTo("3 %");
        assertThat(plain(Numbers.roundPercent(0.001))).isEqualTo("0.1 %");
        assertThat(plain(Numbers.roundPercent(20))).isEqualTo("2000 %");
    }

    @Test
    void seconds_givenShortTimes_areMilliseconds() {
        assertThat(plain(Numbers.seconds(0.0042))).isEqualTo("4.20 ms");
        assertThat(plain(Numbers.seconds(0.21))).isEqualTo("0.21 s");
        assertThat(plain(Numbers.seconds(125.4))).isEqualTo("125 s");
        assertThat(plain(Numbers.seconds(0))).isEqualTo("0 s");
    }

    @Test
    void count_givenLargeOnes_saysMillions() {
        assertThat(Numbers.count(999_999)).isEqualTo("999,999");
        assertThat(plain(Numbers.count(123_456_789))).isEqualTo("123 million");
        assertThat(plain(Numbers.count(2.5e12))).isEqualTo("2,500 billion");
        assertThat(plain(Numbers.roundCount(1e6))).isEqualTo("1 million");
        assertThat(plain(Numbers.roundBytes(1e4))).isEqualTo("10 kB");
        assertThat(plain(Numbers.roundBytes(1e5))).isEqualTo("100 kB");
    }

    @Test
    void power_givenNegativeZero_hasNoSign() {
        assertThat(Numbers.power(-0.001)).isEqualTo("0.00");
        assertThat(Numbers.power(-0.666)).isEqualTo("−0.67");
    }

    @Test
    void scientific_givenTicks_arePowersOfTen() {
        assertThat(Numbers.scientific(1e-4)).isEqualTo("10⁻⁴");
        assertThat(Numbers.scientific(1)).isEqualTo("10⁰");
        assertThat(Numbers.scientific(5e-3)).isEqualTo("5·10⁻³");
        assertThat(Numbers.scientific(2e12)).isEqualTo("2·10¹²");
    }
}
