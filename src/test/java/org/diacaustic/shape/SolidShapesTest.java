package org.diacaustic.shape;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;
import static org.diacaustic.shape.Line.v;

import org.diacaustic.math.Ray;
import org.diacaustic.math.Transform;
import org.diacaustic.math.Vector3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Boxes, frusta and instances. */
class SolidShapesTest {
    private final Box cube = new Box(Vector3.ZERO, v(1, 1, 1));
    private final Frustum cone = Frustum.cone(v(0, 0, 0), 1, v(0, 2, 0), true);

    @Test
    void box_givenNoVolume_isRefused() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Box(Vector3.ZERO, v(1, 0, 1)))
                .withMessageContaining("volume");
        assertThatIllegalArgumentException().isThrownBy(() -> new Box(Vector3.ZERO, v(1, Double.NaN, 1)));
    }

    @Test
    void frustum_givenBadArguments_isRefused() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Frustum.cylinder(Vector3.ZERO, Vector3.ZERO, 1, true))
                .withMessageContaining("apart");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Frustum.cylinder(Vector3.ZERO, Vector3.UNIT_X, 0, true))
                .withMessageContaining("radii");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Frustum.between(Vector3.ZERO, -1, Vector3.UNIT_X, 2, true));
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Frustum.cone(Vector3.ZERO, Double.NaN, Vector3.UNIT_X, true));
    }

    @Test
    void intersect_givenBoxThroughFaces_namesThem() {
        assertThat(Line.crossings(cube, v(-1, 0.5, 0.5), v(1, 0, 0))).containsExactly(1.0, 2.0);
        assertThat(Line.meet(cube, v(-1, 0.5, 0.5), v(1, 0, 0)).primitive).isZero();
        assertThat(Line.meet(cube, v(0.5, 0.5, 3), v(0, 0, -1)).primitive).isEqualTo(5);
        // In the plane of a face, which belongs to the box.
        assertThat(Line.crossings(cube, v(1, 0.5, -1), v(0, 0, 1))).containsExactly(1.0, 2.0);
        assertThat(Line.crossings(cube, v(1, 0.5, -1), v(-0.0, 0, 1))).containsExactly(1.0, 2.0);
    }

    @Test
    void intersect_givenBoxThroughEdgesAndCorners_crossesAnEvenNumberOfTimes() {
        for (double x = -2; x <= 3; x += 0.5) {
            for (double y = -2; y <= 3; y += 0.5) {
                for (double z = 0; z <= 1; z += 0.5) {
                    Vector3 from = v(x, y, -2);
                    int crossings =
                            Line.crossings(cube, from, v(z, 0.5, 0).minus(from)).size();
                    assertThat(crossings).isIn(0, 2);
                }
            }
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-3, 1e-16, 1e-300})
    void intersect_givenABoxThinnerThanRounding_meetsTheFaceThatIsTurnedToTheRay(double thickness) {
        Box thin = new Box(v(0, -thickness, 0), v(1, 0, 1));
        assertThat(Line.meet(thin, v(0.5, 1, 0.5), v(0, -1, 0)).primitive).isEqualTo(3);
        assertThat(Line.meet(thin, v(0.5, -1, 0.5), v(0, 1, 0)).primitive).isEqualTo(2);
        assertThat(Line.meet(thin, v(0.1, 1, 0.2), v(0.3, -1, 0.2).normalized()).primitive)
                .isEqualTo(3);
        assertThat(Line.crossings(thin, v(1.5, 1, 0.5), v(0, -1, 0))).isEmpty();
    }

    @Test
    void inverseMap_givenFacesOfBox_haveCellsOfTheirOwn() {
        // Column 0 is x, 1 is y, 2 is z; the upper row the face at the larger coordinate.
        Hit top = Line.meet(cube, v(0.25, 5, 0.5), v(0, -1, 0));
        cube.inverseMap(top);
        assertThat(top.u).isCloseTo((1 + 0.25) / 3, within(1e-16));
        assertThat(top.v).isCloseTo((1 + 0.5) / 2, within(1e-16));
        Hit left = Line.meet(cube, v(-5, 0.25, 0.5), v(1, 0, 0));
        cube.inverseMap(left);
        assertThat(left.u).isCloseTo(0.5 / 3, within(1e-16));
        assertThat(left.v).isCloseTo(0.25 / 2, within(1e-16));
    }

    @Test
    void intersect_givenConeThroughAxisTipAndGenerator_entersAndLeaves() {
        assertThat(Line.crossings(cone, v(0, 5, 0), v(0, -1, 0))).containsExactly(3.0, 5.0);
        assertThat(Line.crossings(cone, v(0, -5, 0), v(0, 1, 0))).containsExactly(5.0, 7.0);
        // At half height the radius is half.
        assertThat(Line.crossings(cone, v(-2, 1, 0), v(1, 0, 0))).containsExactly(1.5, 2.5);
        // Parallel to the generator x = 1 − y/2 and 0.25 to the left of it: in at the base x = 0.75, out at the other
        // generator x = y/2 − 1, where 0.75 − y/2 = y/2 − 1, y = 1.75.
        assertThat(Line.crossings(cone, v(1.75, -2, 0), v(-0.5, 1, 0))).containsExactly(2.0, 3.75);
    }

    @Test
    void intersect_givenLeaningConeThroughItsTip_entersAndLeaves() {
        Vector3 tip = v(0.3, 2.1, -0.7);
        Frustum leaning = Frustum.cone(v(-0.4, 0.2, 0.6), 1, tip, true);
        for (int i = 0; i < 100; i++) {
            Vector3 target = v(-0.4 + 0.003 * i, 0.2, 0.6);
            Vector3 from = tip.plus(tip.minus(target).times(1.7));
            assertThat(Line.crossings(leaning, from, target.minus(from)).size()).isIn(0, 2);
        }
    }

    @Test
    void intersect_givenCappedCylinder_isMetAtSideAndCaps() {
        Frustum drum = Frustum.cylinder(v(0, 0, 0), v(0, 2, 0), 1, true);
        assertThat(Line.crossings(drum, v(-5, 1, 0), v(1, 0, 0))).containsExactly(4.0, 6.0);
        assertThat(Line.crossings(drum, v(0.5, 5, 0), v(0, -1, 0))).containsExactly(3.0, 5.0);
        assertThat(Line.crossings(drum, v(1.5, 5, 0), v(0, -1, 0))).isEmpty();
        assertThat(Line.meet(drum, v(0.5, 5, 0), v(0, -1, 0)).normalY).isEqualTo(1);
        // Through the open one along the axis there is nothing.
        Frustum pipe = Frustum.cylinder(v(0, 0, 0), v(0, 2, 0), 1, false);
        assertThat(Line.crossings(pipe, v(0.5, 5, 0), v(0, -1, 0))).isEmpty();
        assertThat(Line.crossings(pipe, v(-5, 1, 0), v(1, 0, 0))).containsExactly(4.0, 6.0);
        assertThat(pipe.isClosed()).isFalse();
    }

    @Test
    void inverseMap_givenCappedCylinder_followsTheOutline() {
        // Radius 1 and height 2: the outline is 1 + 2 + 1 long.
        Frustum drum = Frustum.cylinder(v(0, 0, 0), v(0, 2, 0), 1, true);
        Hit side = Line.meet(drum, v(5, 1, 0), v(-1, 0, 0));
        drum.inverseMap(side);
        assertThat(side.u).isZero();
        assertThat(side.v).isEqualTo(0.5);
        Hit top = Line.meet(drum, v(0.5, 5, 0), v(0, -1, 0));
        drum.inverseMap(top);
        assertThat(top.v).isEqualTo(3.5 / 4);
    }

    @Test
    void intersect_givenInstance_preservesTAndCountsTests() {
        Transformed instance = new Transformed(
                new Sphere(Vector3.ZERO, 1), Transform.identity().scale(2).translate(10, 0, 0));
        Ray ray = new Ray();
        ray.set(v(0, 0, 0), v(4, 0, 0));
        assertThat(instance.intersect(ray)).isTrue();
        assertThat(ray.tMax).isEqualTo(2);
        assertThat(ray.tests).isEqualTo(1);
        assertThat(Line.complete(instance, ray).x).isEqualTo(8);
        assertThat(instance.bounds().contains(8, 0, 0)).isTrue();
        assertThat(instance.bounds().contains(7.99, 0, 0)).isFalse();
    }

    @Test
    void complete_givenMirroredInstance_keepsTheNormalOutward() {
        Transformed mirrored =
                new Transformed(new Sphere(v(1, 0, 0), 1), Transform.identity().scale(-1, 1, 1));
        Hit hit = Line.meet(mirrored, v(-9, 0, 0), v(1, 0, 0));
        assertThat(hit.x).isEqualTo(-2);
        assertThat(hit.normalX).isEqualTo(-1);
    }
}
