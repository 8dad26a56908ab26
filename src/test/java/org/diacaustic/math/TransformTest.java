package org.diacaustic.math;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class TransformTest {
    @Test
    void scale_givenZeroOrNotFinite_isRefused() {
        Transform identity = Transform.identity();
        assertThatIllegalArgumentException()
                .isThrownBy(() -> identity.scale(1, 0, 1))
                .withMessageContaining("scale factors");
        assertThatIllegalArgumentException().isThrownBy(() -> identity.scale(Double.NaN));
        assertThatIllegalArgumentException().isThrownBy(() -> identity.translate(0, Double.POSITIVE_INFINITY, 0));
        assertThatIllegalArgumentException().isThrownBy(() -> identity.rotate(Vector3.ZERO, 10));
        assertThatIllegalArgumentException().isThrownBy(() -> identity.rotate(Vector3.UNIT_X, Double.NaN));
    }

    @Test
    void ofColumns_givenColumnsInOnePlane_isRefused() {
        Vector3 x = new Vector3(1, 2, 3);
        Vector3 y = new Vector3(4, 5, 6);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Transform.ofColumns(x, y, x.plus(y), Vector3.ZERO))
                .withMessageContaining("invertible");
    }

    @Test
    void point_givenScaleTurnMove_doesThemInThatOrder() {
        // (1, 0, 0) → (2, 0, 0) → a quarter turn about y takes x to −z → (0, 1, −2); all exact.
        Transform transform =
                Transform.identity().scale(2).rotate(Vector3.UNIT_Y, 90).translate(0, 1, 0);
        assertThat(transform.point(Vector3.UNIT_X)).isEqualTo(new Vector3(0, 1, -2));
        assertThat(transform.inversePoint(new Vector3(0, 1, -2))).isEqualTo(Vector3.UNIT_X);
    }

    @Test
    void rotate_givenWholeQuarters_isExact() {
        for (int quarters = -8; quarters <= 8; quarters++) {
            Vector3 turned =
                    Transform.identity().rotate(Vector3.UNIT_Z, 90.0 * quarters).vector(Vector3.UNIT_X);
            double[] x = {1, 0, -1, 0};
            double[] y = {0, 1, 0, -1};
            int k = Math.floorMod(quarters, 4);
            assertThat(turned.minus(new Vector3(x[k], y[k], 0)).length()).isZero();
        }
    }

    @Test
    void rotate_givenThirtyDegrees_hasSineOneHalf() {
        Vector3 turned = Transform.identity().rotate(Vector3.UNIT_Z, 30).vector(Vector3.UNIT_X);
        assertThat(turned.x()).isCloseTo(Math.sqrt(0.75), within(2e-16));
        assertThat(turned.y()).isCloseTo(0.5, within(2e-16));
    }

    @Test
    void inversePoint_givenManySteps_undoesPoint() {
        SplittableRandom random = new SplittableRandom(1);
        for (int i = 0; i < 200; i++) {
            Transform transform = Transform.identity();
            for (int step = 0; step < 4; step++) {
                transform = transform
                        .scale(random.nextDouble(0.5, 2), -random.nextDouble(0.5, 2), random.nextDouble(0.5, 2))
                        .rotate(new Vector3(1, random.nextDouble(), random.nextDouble()), random.nextDouble(-720, 720))
                        .translate(random.nextDouble(-9, 9), random.nextDouble(-9, 9), random.nextDouble(-9, 9));
            }
            Vector3 p = new Vector3(random.nextDouble(), random.nextDouble(), random.nextDouble());
            Vector3 back = transform.inversePoint(transform.point(p));
            assertThat(back.minus(p).length()).isLessThan(1e-12);
        }
    }

    @Test
    void ofColumns_givenComposedTransform_hasItsInverse() {
        Transform composed = Transform.identity()
                .scale(1, 2, 3)
                .rotate(new Vector3(1, 2, 3), 50)
                .translate(4, 5, 6);
        Matrix m = composed.linear();
        Transform again = Transform.ofColumns(
                m.times(Vector3.UNIT_X), m.times(Vector3.UNIT_Y), m.times(Vector3.UNIT_Z), composed.translation());
        Vector3 p = new Vector3(7, -8, 9);
        assertThat(again.inversePoint(p).minus(composed.inversePoint(p)).length())
                .isLessThan(1e-14 * p.length());
    }

    @Test
    void then_givenTwo_doesOneAfterTheOther() {
        Transform one = Transform.identity().scale(1, 2, 3).translate(1, 0, 0);
        Transform two = Transform.identity().rotate(Vector3.UNIT_X, 90).translate(0, 0, 5);
        Vector3 p = new Vector3(0.5, 0.25, 2);
        assertThat(one.then(two).point(p)).isEqualTo(two.point(one.point(p)));
        assertThat(one.then(two).inversePoint(p)).isEqualTo(one.inversePoint(two.inversePoint(p)));
    }

    @Test
    void normal_givenStretchedPlane_staysPerpendicular() {
        Transform transform = Transform.identity().scale(4, 1, -1).rotate(Vector3.UNIT_Y, 25);
        Vector3 normal = new Vector3(1, 1, 0).normalized();
        Vector3 along = new Vector3(1, -1, 0);
        Vector3 moved = transform.normal(normal);
        assertThat(moved.dot(transform.vector(along))).isCloseTo(0, within(1e-15));
        assertThat(moved.dot(transform.vector(normal))).isPositive();
        assertThat(moved.length()).isCloseTo(1, within(2e-16));
    }
}
