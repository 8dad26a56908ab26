package org.diacaustic.map;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class TriangleClipTest {
    private static final double ROUNDING = 1e-15;

    private final TriangleClip clip = new TriangleClip();
    private final SplittableRandom random = new SplittableRandom(6);

    @Test
    void fraction_givenNoPlane_isAll() {
        clip.begin();
        assertThat(clip.fraction()).isEqualTo(1);
    }

    @ParameterizedTest
    // A plane that cuts two edges at parts s and t of their lengths cuts off s·t.
    @CsvSource({
        "1, -1, -1, 0.25",
        "-1, 1, 1, 0.75",
        "-1, 1, -3, 0.125",
        "1, -1, 3, 0.875",
        "-1, -1, 3, 0.5625",
        "1, 1, -3, 0.4375",
        "1, 0, -1, 0.5",
        "0, 1, -1, 0.5",
        "-1, 0, 1, 0.5",
        "0, -1, 1, 0.5",
        "1, 0, 0, 1",
        "1e300, -1, -1, 1",
        "1, -1e300, -1e300, 0",
        "1e-300, -1e-300, -1e-300, 0.25",
    })
    void fraction_givenOnePlane_isTheProductOfTheParts(double first, double second, double third, double expected) {
        assertThat(fraction(first, second, third)).isCloseTo(expected, within(ROUNDING));
        assertThat(fraction(second, third, first)).isCloseTo(expected, within(ROUNDING));
        // The same plane twice takes the way of several planes.
        clip.begin();
        clip.add(first, second, third, true);
        clip.add(first, second, third, true);
        assertThat(clip.fraction()).isCloseTo(expected, within(2 * ROUNDING));
    }

    @Test
    void fraction_givenTwoSidesOfAPlane_addsUpToAll() {
        for (int i = 0; i < 10_000; i++) {
            double first = random.nextDouble(-1, 1);
            double second = random.nextDouble(-1, 1);
            double third = random.nextDouble(-1, 1);
            double sum = fraction(first, second, third) + fraction(-first, -second, -third);
            assertThat(sum).isCloseTo(1, within(ROUNDING));
        }
    }

    @Test
    void fraction_givenTheFourQuartersOfTwoPlanes_addsUpToAll() {
        for (int i = 0; i < 10_000; i++) {
            double[] p = {random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1)};
            double[] q = {random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1)};
            double sum = 0;
            for (int quarter = 0; quarter < 4; quarter++) {
                double onP = (quarter & 1) == 0 ? 1 : -1;
                double onQ = (quarter & 2) == 0 ? 1 : -1;
                clip.begin();
                clip.add(onP * p[0], onP * p[1], onP * p[2], true);
                clip.add(onQ * q[0], onQ * q[1], onQ * q[2], true);
                sum += clip.fraction();
            }
            assertThat(sum).isCloseTo(1, within(4 * ROUNDING));
        }
    }

    @ParameterizedTest
    // The other side of the plane has the opposite signs, and holds the plane if this does not.
    @CsvSource({"0, 0, 0", "0, 0, 1", "0, 0, -1", "0, 1, 1", "0, 2, -1", "-0.0, -0.0, -0.0", "0, -0.0, 3"})
    void fraction_givenVerticesInThePlane_belongsToOneSideOnly(double first, double second, double third) {
        for (boolean holdsPlane : new boolean[] {true, false}) {
            clip.begin();
            clip.add(first, second, third, holdsPlane);
            double one = clip.fraction();
            clip.begin();
            clip.add(-first, -second, -third, !holdsPlane);
            assertThat(one + clip.fraction()).isCloseTo(1, within(ROUNDING));
            if (first == 0 && second == 0 && third == 0) {
                assertThat(one).isEqualTo(holdsPlane ? 1 : 0);
            }
        }
    }

    @Test
    void fraction_givenAPlaneThatAllIsBehind_isNothing() {
        clip.begin();
        clip.add(1, 2, -1, true);
        clip.add(-1, -2, -1, true);
        clip.add(3, 2, 1, true);
        assertThat(clip.fraction()).isZero();
    }

    @Test
    void fraction_givenDistancesThatAreNothingButRounding_isAPart() {
        for (int i = 0; i < 100_000; i++) {
            clip.begin();
            double scale = 0x1p-50 * random.nextInt(3);
            for (int plane = 0; plane < 4; plane++) {
                clip.add(tiny() + scale, tiny() - scale, tiny(), true);
            }
            assertThat(clip.fraction()).isBetween(0.0, 1.0);
        }
    }

    private double tiny() {
        return Double.MIN_VALUE * random.nextInt(-2, 3);
    }

    @Test
    void fraction_givenASquareInside_isItsPart() {
        // In the triangle (0,0), (4,0), (0,4), of area 8, the square from (1,1) to (2,2) is one eighth; moved to
        // (1.5,1.5) its corner beyond the hypotenuse, half a square of side 1, is missing.
        assertThat(square(1)).isCloseTo(1 / 8.0, within(ROUNDING));
        assertThat(square(1.5)).isCloseTo(1 / 16.0, within(ROUNDING));
        assertThat(square(2)).isCloseTo(0, within(ROUNDING));
    }

    private double square(double low) {
        clip.begin();
        clip.add(-low, 4 - low, -low, true);
        clip.add(low + 1, low - 3, low + 1, true);
        clip.add(-low, -low, 4 - low, true);
        clip.add(low + 1, low + 1, low - 3, true);
        return clip.fraction();
    }

    private double fraction(double first, double second, double third) {
        clip.begin();
        clip.add(first, second, third, true);
        return clip.fraction();
    }
}
