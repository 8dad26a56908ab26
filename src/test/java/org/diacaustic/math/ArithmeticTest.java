package org.diacaustic.math;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class ArithmeticTest {

    @Test
    void differenceOfProducts_givenProductsThatCancel_isRightToTheLastDigit() {
        // The plain expression gives 5.37660002708…: eight digits are lost.
        double difference = Arithmetic.differenceOfProducts(33962.035, -30438.8, 41563.4, -24871.969);

        assertThat(difference).isCloseTo(5.376599994516417064, within(5.38 * 3.4e-16));
    }

    @Test
    void length_givenComponentsWhoseSquaresLeaveTheRange_isRight() {
        // 2² + 3² + 6² = 7²
        assertThat(Arithmetic.length(2, 3, 6)).isEqualTo(7);
        assertThat(Arithmetic.length(0x2p600, -0x3p600, 0x6p600)).isEqualTo(0x7p600);
        assertThat(Arithmetic.length(0x2p-1000, 0x3p-1000, -0x6p-1000)).isEqualTo(0x7p-1000);
        assertThat(Arithmetic.length(0, Double.MIN_VALUE, 0)).isEqualTo(Double.MIN_VALUE);
        assertThat(Arithmetic.length(0, 0, 0)).isZero();
        assertThat(Arithmetic.length(1, Double.NEGATIVE_INFINITY, 0)).isEqualTo(Double.POSITIVE_INFINITY);
        assertThat(Arithmetic.length(1, Double.NaN, 0)).isNaN();
    }

    @Test
    void powerOfTwoNear_givenAnyPositiveValue_isAtOrJustBelow() {
        assertThat(Arithmetic.powerOfTwoNear(1)).isEqualTo(1);
        assertThat(Arithmetic.powerOfTwoNear(7.9)).isEqualTo(4);
        assertThat(Arithmetic.powerOfTwoNear(Math.nextDown(0.5))).isEqualTo(0.25);
        assertThat(Arithmetic.powerOfTwoNear(Double.MAX_VALUE)).isEqualTo(0x1p1023);
    }

    @Test
    void clamp_givenValue_staysWithinAndKeepsWhatIsNotANumber() {
        assertThat(Arithmetic.clamp(-1, 0, 1)).isEqualTo(0);
        assertThat(Arithmetic.clamp(2, 0, 1)).isEqualTo(1);
        assertThat(Arithmetic.clamp(0.5, 0, 1)).isEqualTo(0.5);
        assertThat(Arithmetic.clamp(Double.NaN, 0, 1)).isNaN();
    }
}
