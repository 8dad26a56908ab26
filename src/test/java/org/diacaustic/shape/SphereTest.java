package org.diacaustic.shape;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;
import static org.diacaustic.shape.Line.v;

import java.util.List;
import org.diacaustic.math.Ray;
import org.diacaustic.math.Vector3;
import org.junit.jupiter.api.Test;

class SphereTest {
    private final Sphere unit = new Sphere(Vector3.ZERO, 1);

    @Test
    void sphere_givenBadArguments_isRefused() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Sphere(Vector3.ZERO, 0))
                .withMessageContaining("radius");
        assertThatIllegalArgumentException().isThrownBy(() -> new Sphere(Vector3.ZERO, Double.POSITIVE_INFINITY));
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Sphere(v(Double.NaN, 0, 0), 1))
                .withMessageContaining("centre");
    }

    @Test
    void intersect_givenPlanetFromOneMetreAbove_keepsAllDigits() {
        Sphere planet = new Sphere(v(0, -1e6, 0), 1e6);
        List<Double> down = Line.crossings(planet, v(0, 1, 0), v(0, -1, 0));
        assertThat(down.get(0)).isCloseTo(1, within(1e-15));
        assertThat(down.get(1)).isCloseTo(2000001, within(1e-9));
        // Just under the horizon.
        List<Double> out = Line.crossings(planet, v(0, 1, 0), v(0.9999988750018984, -0.0014999983125028476, 0));
        assertThat(out.get(0)).isCloseTo(1000.001375000086042, within(1e-8));
        assertThat(out.get(1)).isCloseTo(1999.998250002234157, within(1e-8));
    }

    @Test
    void intersect_givenGrainFarAway_findsBothSides() {
        Sphere grain = new Sphere(Vector3.ZERO, 1e-5);
        List<Double> through = Line.crossings(grain, v(0, 0, 1e3), v(0, 0, -1));
        assertThat(through.get(0)).isCloseTo(999.99999, within(1.2e-13));
        assertThat(through.get(1)).isCloseTo(1000.00001, within(2.4e-13));
        List<Double> aside = Line.crossings(grain, v(0, 0, 1e3), v(9.9e-9, 0, -1));
        assertThat(aside.get(0)).isCloseTo(999.9999985893263, within(3.6e-12));
        assertThat(aside.get(1)).isCloseTo(1000.0000014106737, within(3.6e-12));
    }

    @Test
    void intersect_givenNearlyTangentRay_tellsHitFromMiss() {
        // The half chord is √(2h − h²) for a depth of h.
        for (double h : new double[] {1e-6, 1e-12}) {
            List<Double> found = Line.crossings(unit, v(-10, 1 - h, 0), v(1, 0, 0));
            double half = Math.sqrt(2 * h);
            assertThat(found.get(0)).isCloseTo(10 - half, within(1e-4 * half));
            assertThat(found.get(1)).isCloseTo(10 + half, within(1e-4 * half));
        }
        assertThat(Line.crossings(unit, v(-10, 1 + 1e-12, 0), v(1, 0, 0))).isEmpty();
    }

    @Test
    void intersect_givenOriginOnTheSurface_findsTheFarSide() {
        Ray ray = new Ray();
        ray.set(v(0, 0, 1), v(0, 0, -1));
        ray.leaving = 0;
        assertThat(unit.intersect(ray)).isTrue();
        assertThat(ray.tMax).isEqualTo(2);
    }

    @Test
    void intersect_givenDirectionOfAnyLength_measuresTInIt() {
        assertThat(Line.meet(unit, v(0, 0, 5), v(0, 0, -0.001)).t).isCloseTo(4000, within(1e-12));
        assertThat(Line.meet(unit, v(0, 0, 5), v(0, 0, -1000)).t).isCloseTo(0.004, within(1e-18));
    }

    @Test
    void leave_givenChordAtSixtyDegrees_hasTheLengthOfTheRadius() {
        // A chord at 60° inside to the normal is 2·R·cos 60° = R long.
        Sphere big = new Sphere(Vector3.ZERO, 1e6);
        double root3 = Math.sqrt(0.75);
        for (int i = 0; i < 360; i++) {
            double angle = StrictMath.toRadians(i);
            double c = StrictMath.cos(angle);
            double s = StrictMath.sin(angle);
            Hit hit = Line.meet(big, v(3e6 * c, 3e6 * s, 0.1), v(-c, -s, 0));
            Vector3 n = Line.normal(hit);
            Vector3 aside = n.cross(Vector3.UNIT_Z).normalized();
            Ray inward = Line.leaving(hit, n.times(-0.5).plus(aside.times(root3)));
            assertThat(big.intersect(inward)).isTrue();
            assertThat(inward.tMax).isCloseTo(1e6, within(1e6 * 1.2e-13));
            assertThat(big.intersect(Line.leaving(hit, n.times(0.5).plus(aside))))
                    .isFalse();
        }
    }

    @Test
    void intersect_givenSphereWithinSphere_findsTheGapOfFortyMicrometres() {
        double outerT = Line.meet(new Sphere(Vector3.ZERO, 1.00004), v(0, 0, 5), v(0, 0, -1)).t;
        double innerT = Line.meet(unit, v(0, 0, 5), v(0, 0, -1)).t;
        assertThat(outerT).isCloseTo(3.99996, within(4e-15));
        assertThat(innerT).isCloseTo(4, within(4e-15));
        assertThat(innerT - outerT).isCloseTo(0.00004000000000004000355602329, within(4e-15));
    }

    /** A ray that starts a little before the surface it leaves: the chord is shorter by that, at any scale. */
    @Test
    void leave_givenAnOffsetAtAnyScale_scalesTheChord() {
        for (int exponent : new int[] {-900, -600, 0, 600, 900}) {
            double k = Math.scalb(1.0, exponent);
            Ray ray = new Ray();
            ray.set(0, 0, k, 0, 0, -1);
            ray.leaving = 0;
            ray.departureError = 0x1p-50 * k;
            ray.departureOffset = 0x1p-48 * k;
            assertThat(new Sphere(Vector3.ZERO, k).intersect(ray)).isTrue();
            assertThat(ray.tMax).isEqualTo((2 - 0x1p-48) * k);
            assertThat(ray.departureOffset).isEqualTo(0x1p-48 * k);
        }
    }

    @Test
    void intersect_givenSizesWhoseSquaresLeaveTheRange_findsTheSphere() {
        // From 4 radii in front of it; half of a direction is one unit of t.
        for (int exponent : new int[] {-900, -600, 600, 900}) {
            double unit = Math.scalb(1.0, exponent);
            Ray ray = new Ray();
            ray.set(0, 0, 5 * unit, 0, 0, -2 * unit);
            assertThat(new Sphere(Vector3.ZERO, unit).intersect(ray)).isTrue();
            assertThat(ray.tMax).isEqualTo(2);
            ray.set(0, 0, 5, 0, 0, -2 * unit);
            assertThat(new Sphere(Vector3.ZERO, 1).intersect(ray)).isTrue();
            assertThat(ray.tMax).isEqualTo(2 / unit);
        }
    }
}
