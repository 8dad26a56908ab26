package org.diacaustic.map;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.function.DoubleUnaryOperator;
import org.diacaustic.math.Rgb;
import org.junit.jupiter.api.Test;

class LandingSlopeTest {
    /** Light of one cell that a formula brings from (s, t) to x; rays farther than so from the middle go another way. */
    private static LandingSlope slope(DoubleUnaryOperator x, double middle, double reach) {
        return new LandingSlope(new LightPaths() {
            @Override
            public void enter(CellSeed cell) {}

            @Override
            public boolean follow(double s, double t, SurfacePoint at, Rgb power) {
                at.x = x.applyAsDouble(s);
                at.y = 7;
                at.z = 3 * t;
                return Math.abs(s - middle) <= reach;
            }
        });
    }

    @Test
    void find_givenSmoothLight_isTheDerivativeToTheLastDigits() {
        LandingSlope slope = slope(s -> Math.exp(0.2 * s), 0.4, 10);
        assertThat(slope.find(0.4, 0.3, 1, 0)).isTrue();
        // (e^(s/5))' = e^(s/5) / 5
        assertThat(slope.x).isCloseTo(0.2 * Math.exp(0.08), within(1e-14));
        assertThat(slope.y).isZero();
        assertThat(slope.z).isZero();
        assertThat(slope.find(0.4, 0.3, 0, 1)).isTrue();
        assertThat(slope.z).isCloseTo(3, within(1e-14));
    }

    @Test
    void find_givenLightThatSpreadsFast_takesSmallerSteps() {
        // 1 / (1.1 − s) at 0.9 has the derivative 1 / 0.2² = 25, and a pole 0.2 away.
        LandingSlope slope = slope(s -> 1 / (1.1 - s), 0.9, 10);
        assertThat(slope.find(0.9, 0, 1, 0)).isTrue();
        assertThat(slope.x).isCloseTo(25, within(25e-11));
    }

    @Test
    void find_givenRaysThatGoAnotherWay_staysAmongTheOthers() {
        LandingSlope slope = slope(s -> Math.abs(s - 0.4) <= 0.01 ? Math.sin(s) : 1000, 0.4, 0.01);
        assertThat(slope.find(0.4, 0, 1, 0)).isTrue();
        assertThat(slope.x).isCloseTo(Math.cos(0.4), within(1e-12));
        assertThat(slope(Math::sin, 0.4, 1e-9).find(0.4, 0, 1, 0)).isFalse();
    }
}
