package org.diacaustic.shape;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;
import static org.diacaustic.shape.Line.v;

import java.util.SplittableRandom;
import org.diacaustic.math.Ray;
import org.diacaustic.math.Vector3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Planes and discs. */
class FlatShapesTest {
    private final Plane floor = new Plane(Vector3.ZERO, Vector3.UNIT_Y);

    @Test
    void plane_givenBadArguments_isRefused() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Plane(v(0, Double.NaN, 0), Vector3.UNIT_Y))
                .withMessageContaining("point");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Plane(Vector3.ZERO, Vector3.ZERO))
                .withMessageContaining("normal");
    }

    @Test
    void disc_givenBadArguments_isRefused() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Disc(Vector3.ZERO, Vector3.UNIT_Y, 2, 1))
                .withMessageContaining("radii");
        assertThatIllegalArgumentException().isThrownBy(() -> new Disc(Vector3.ZERO, Vector3.UNIT_Y, 0));
        assertThatIllegalArgumentException().isThrownBy(() -> new Disc(Vector3.ZERO, Vector3.UNIT_Y, Double.NaN));
        assertThatIllegalArgumentException().isThrownBy(() -> new Disc(Vector3.ZERO, Vector3.ZERO, 1));
    }

    @Test
    void intersect_givenOriginAPicometreAbove_hits() {
        Hit straight = Line.meet(floor, v(0.3, 1e-12, 0.7), v(0, -1, 0));
        assertThat(straight.t).isEqualTo(1e-12);
        Hit slanted = Line.meet(floor, v(0.3, 1e-12, 0.7), v(0.984807753012208, -0.17364817766693036, 0));
        assertThat(slanted.t).isCloseTo(5.758770483143633085752812e-12, within(1e-26));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 1e7})
    void leave_givenAnyDirection_meetsTheNextPlaneOnly(double offset) {
        Vector3 normal = v(0, 0.6, 0.8);
        Vector3 point = v(offset, offset, offset);
        Plane first = new Plane(point, normal);
        Plane second = new Plane(point.minus(normal.times(1e-5)), normal);
        SplittableRandom random = new SplittableRandom(3);
        for (int i = 0; i < 1000; i++) {
            Vector3 target = point.plus(v(random.nextDouble(3), random.nextDouble(-3, 0), random.nextDouble(-3, 0)));
            Vector3 origin = v(offset, offset + 5, offset + 5);
            Hit hit = Line.meet(first, origin, target.minus(origin));
            for (int k = 0; k < 100; k++) {
                Vector3 d = v(random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1));
                Ray ray = Line.leaving(hit, d);
                assertThat(first.intersect(ray)).isFalse();
                ray.leaving = Ray.FREE;
                assertThat(second.intersect(ray)).isEqualTo(d.dot(normal) < 0);
            }
        }
    }

    @Test
    void intersect_givenThinSlabAtHeightOneThousand_measuresItsThickness() {
        // The thickness is that of the doubles. Refraction from 60° by n = 1.5: sin = √(3/4)/1.5, path = thickness/cos.
        Plane top = new Plane(v(0, 1000, 0), Vector3.UNIT_Y);
        Plane bottom = new Plane(v(0, 999.999999, 0), Vector3.UNIT_Y);
        double sine = Math.sqrt(0.75) / 1.5;
        Hit entry = Line.meet(top, v(0, 1000 + 1000 / Math.sqrt(3), 0), v(Math.sqrt(0.75), -0.5, 0));
        assertThat(entry.x).isCloseTo(1000, within(1e-9));
        Ray inside = Line.leaving(entry, v(sine, -Math.sqrt(1 - sine * sine), 0));
        inside.leaving = Ray.FREE;
        assertThat(bottom.intersect(inside)).isTrue();
        assertThat(inside.tMax).isCloseTo(0.000001224744868299405504064137, within(1e-21));
    }

    @Test
    void inverseMap_givenFloor_repeatsEveryUnit() {
        Hit hit = Line.meet(floor, v(2.25, 3, -7.5), v(0, -1, 0));
        floor.inverseMap(hit);
        assertThat(hit.u).isEqualTo(0.25);
        assertThat(hit.v).isEqualTo(0.5);
        assertThat(v(hit.tangentUX, hit.tangentUY, hit.tangentUZ)).isEqualTo(Vector3.UNIT_X);
        assertThat(v(hit.tangentVX, hit.tangentVY, hit.tangentVZ)
                        .plus(Vector3.UNIT_Z)
                        .length())
                .isZero();
    }

    @Test
    void intersect_givenRing_leavesOutTheHole() {
        Disc ring = new Disc(v(1, 2, 3), Vector3.UNIT_Z, 1, 2);
        assertThat(Line.meet(ring, v(1.5, 2, 9), v(0, 0, -1))).isNull();
        assertThat(Line.meet(ring, v(2.5, 2, 9), v(0, 0, -1)).t).isEqualTo(6);
        assertThat(Line.meet(ring, v(2.5, 2, -9), v(0, 0, 1)).normalZ).isEqualTo(1);
        assertThat(Line.meet(ring, v(3.01, 2, 9), v(0, 0, -1))).isNull();
    }
}
