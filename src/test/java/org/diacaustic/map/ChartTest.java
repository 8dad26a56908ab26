package org.diacaustic.map;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.diacaustic.math.Ray;
import org.diacaustic.math.Vector3;
import org.junit.jupiter.api.Test;

class ChartTest {
    private static final Chart UPRIGHT = Chart.spherical(Vector3.ZERO, Vector3.UNIT_Y, Vector3.UNIT_X);
    private static final Chart SLANTED = Chart.spherical(v(1, 2, 3), v(1, 1, 0), v(0, 1, 1));
    private static final Chart SKEW = Chart.planar(v(1, 2, 3), v(2, 0, 0), v(1, 0, 3));

    private static Vector3 v(double x, double y, double z) {
        return new Vector3(x, y, z);
    }

    @Test
    void planar_givenParallelSides_refuses() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Chart.planar(Vector3.ZERO, v(1, 1, 0), v(2, 2, 0)))
                .withMessageContaining("parallel");
    }

    @Test
    void spherical_givenEquatorAlongThePole_refuses() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Chart.spherical(Vector3.ZERO, Vector3.UNIT_Y, v(0, -2, 0)));
    }

    @Test
    void planar_givenPointsOffThePlane_projectsThemOnTheSides() {
        // origin + 1/4·(2, 0, 0) + 1/2·(1, 0, 3), 7 above the plane
        assertThat(SKEW.u(2, 9, 4.5)).isCloseTo(0.25, within(1e-15));
        assertThat(SKEW.v(2, 9, 4.5)).isCloseTo(0.5, within(1e-15));
    }

    @Test
    void spherical_givenAxes_runsOnceAroundAndFromSouthToNorth() {
        // pole × equator = y × x = −z
        assertThat(UPRIGHT.u(5, 0, 0)).isZero();
        assertThat(UPRIGHT.u(0, 0, -5)).isEqualTo(0.25);
        assertThat(UPRIGHT.u(-5, 0, 0)).isEqualTo(0.5);
        assertThat(UPRIGHT.u(0, 0, 5)).isEqualTo(0.75);
        assertThat(UPRIGHT.v(5, 0, 0)).isEqualTo(0.5);
        assertThat(UPRIGHT.v(0, -5, 0)).isZero();
        assertThat(UPRIGHT.v(0, 5, 0)).isEqualTo(1);
        assertThat(UPRIGHT.v(1, 1, 0)).isCloseTo(0.75, within(1e-15));
    }

    @Test
    void spherical_givenPointsCloseToThePole_keepsTheirDigits() {
        // The angle to the pole is 1e-12, so v = 1 − 1e-12/π; an arc cosine would give 1.
        assertThat(1 - UPRIGHT.v(1e-12, 1, 0)).isCloseTo(1e-12 / Math.PI, within(1e-16));
    }

    @Test
    void aim_givenAnyCoordinates_givesTheLineThatHasThem() {
        SplittableRandom random = new SplittableRandom(1);
        Ray ray = new Ray();
        for (Chart chart : new Chart[] {UPRIGHT, SLANTED, SKEW}) {
            for (int i = 0; i < 100; i++) {
                double u = random.nextDouble();
                double v = random.nextDouble();
                double t = random.nextDouble(10);
                chart.aim(u, v, ray);
                assertThat(chart.u(ray.pointX(t), ray.pointY(t), ray.pointZ(t))).isCloseTo(u, within(1e-12));
                assertThat(chart.v(ray.pointX(t), ray.pointY(t), ray.pointZ(t))).isCloseTo(v, within(1e-12));
            }
        }
    }

    @Test
    void spread_givenAllCells_addsUpToTheWhole() {
        // A sphere has 4π sr; the parallelogram has the area 2·3.
        double sphere = 0;
        double plane = 0;
        for (int row = 0; row < 7; row++) {
            sphere += 5 * SLANTED.spread(0.2, row / 7.0, (row + 1) / 7.0);
            plane += 5 * SKEW.spread(0.2, row / 7.0, (row + 1) / 7.0);
        }
        assertThat(sphere).isCloseTo(4 * Math.PI, within(1e-14));
        assertThat(plane).isCloseTo(6, within(1e-14));
    }
}
