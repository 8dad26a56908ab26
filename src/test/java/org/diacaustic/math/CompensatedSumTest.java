package org.diacaustic.math;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class CompensatedSumTest {
    private final CompensatedSum sum = new CompensatedSum();

    @Test
    void value_givenNothing_isZero() {
        assertThat(sum.value()).isZero();
    }

    @Test
    void value_givenHugeTermsThatCancel_keepsTheSmallOnes() {
        // The plain sum, and Kahan's, are 0.
        for (double value : new double[] {1, 1e100, 1, -1e100}) {
            sum.add(value);
        }
        assertThat(sum.value()).isEqualTo(2);
    }

    @Test
    void value_givenTenMillionPowers_isExactToTheLastDigits() {
        // 10⁷ times the float nearest 10⁻⁷ is 1.000000011686097423…; a running float sum is 6 % off.
        for (int i = 0; i < 10_000_000; i++) {
            sum.add(1e-7f);
        }
        assertThat(sum.value()).isCloseTo(1.000000011686097423, within(3e-16));
    }

    @Test
    void value_givenWhatIsNotFinite_saysSo() {
        sum.add(1);
        sum.add(Double.POSITIVE_INFINITY);
        sum.add(1);
        assertThat(sum.value()).isEqualTo(Double.POSITIVE_INFINITY);
        sum.add(Double.NEGATIVE_INFINITY);
        assertThat(sum.value()).isNaN();
    }

    /** Half a unit in the last place and a little more is rounded up, however little that is. */
    @Test
    void value_givenALittleMoreThanHalfAUnit_isRoundedUp() {
        for (double value : new double[] {0x1p-565, 0x1p-618, 0x1p-700}) {
            sum.add(value);
        }
        assertThat(sum.value()).isEqualTo(Math.nextUp(0x1p-565));
    }

    @Test
    void value_givenSumsOfManySizesThatCancel_isExact() {
        // What is left is 60 and 120 digits below what was there.
        for (double value : new double[] {1e60, 1, 1e-60, -1e60, -1}) {
            sum.add(value);
        }
        assertThat(sum.value()).isEqualTo(1e-60);
    }
}
