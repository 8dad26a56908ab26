package org.diacaustic.map;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.diacaustic.map.TestCells.floor;
import static org.diacaustic.map.TestCells.seenFrom;

import java.util.SplittableRandom;
import org.diacaustic.math.Vector3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class FootprintTest {
    private static final Vector3 EYE = new Vector3(0.3, -0.2, 2);

    @Test
    void addCorner_givenAFifth_throws() {
        Footprint square = square();
        assertThatThrownBy(() -> square.addCorner(0, 0, 0, 0, 0, -1)).isInstanceOf(IllegalStateException.class);
    }

    @Test
    void close_givenAConvexPolygon_knowsItsArea() {
        Footprint square = square();
        assertThat(square.close()).isTrue();
        assertThat(square.area()).isCloseTo(1, within(1e-15));
        Footprint triangle = seenFrom(EYE, floor(0, 0), floor(0, 3), floor(1, 0));
        assertThat(triangle.close()).isTrue();
        assertThat(triangle.area()).isCloseTo(1.5, within(1e-15));
        Footprint equal = seenFrom(EYE, floor(0, 0), floor(0, 3), floor(0, 3), floor(1, 0));
        assertThat(equal.close()).isTrue();
        assertThat(equal.area()).isCloseTo(1.5, within(1e-15));
        assertThat(equal.sides.count).isEqualTo(3);
        Footprint straightAngle = seenFrom(EYE, floor(0, 0), floor(0.3, 0.3), floor(0.9, 0.9), floor(1, 0));
        assertThat(straightAngle.close()).isTrue();
        assertThat(straightAngle.area()).isCloseTo(0.45, within(1e-15));
    }

    @Test
    void close_givenWhatIsNotConvex_isFalse() {
        assertThat(seenFrom(EYE, floor(0, 0), floor(1, 0), floor(0.2, 0.2), floor(0, 1))
                        .close())
                .isFalse();
        // Edges that cross each other.
        assertThat(seenFrom(EYE, floor(0, 0), floor(1, 1), floor(1, 0), floor(0, 1))
                        .close())
                .isFalse();
        assertThat(seenFrom(EYE, floor(0, 0), floor(1, 1), floor(1.5, 0), floor(0, 1))
                        .close())
                .isFalse();
    }

    @Test
    void close_givenNoArea_isFalse() {
        assertThat(seenFrom(EYE, floor(0, 0), floor(1, 1)).close()).isFalse();
        assertThat(seenFrom(EYE, floor(0, 0), floor(0.1, 0.3), floor(0.2, 0.6)).close())
                .isFalse();
        assertThat(seenFrom(EYE, floor(0, 0), floor(1, 1), floor(0, 0), floor(1, 1))
                        .close())
                .isFalse();
        assertThat(seenFrom(EYE, floor(0, 0), floor(0, 0), floor(0, 0)).close()).isFalse();
        // Seen along the plane, so that it looks like a line.
        assertThat(seenFrom(new Vector3(-4, 0.3, 0), floor(0, 0), floor(1, 0), floor(1, 1), floor(0, 1))
                        .close())
                .isFalse();
    }

    @ParameterizedTest
    @ValueSource(doubles = {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY, 1e300})
    void close_givenNumbersThatAreNone_isFalse(double wrong) {
        for (int what = 0; what < 5; what++) {
            Footprint footprint = new Footprint();
            SurfacePoint at = floor(0, 0);
            at.normalZ = what == 0 ? wrong * 1e10 : 1;
            footprint.begin(at);
            footprint.addCorner(0, what == 1 ? wrong : 0, 0, 0, 0, -1);
            footprint.addCorner(1, 0, what == 2 ? wrong : 0, 0, 0, -1);
            footprint.addCorner(1, 1, 0, what == 3 ? wrong * 1e10 : 0, 0, -1);
            footprint.reach(what == 4 ? -Math.abs(wrong) : 0);
            assertThat(footprint.close()).as("number %d", what).isFalse();
        }
    }

    @Test
    void area_givenAKnownOne_isThat() {
        Footprint square = square();
        square.area(7);
        assertThat(square.close()).isTrue();
        assertThat(square.area()).isEqualTo(7);
        square.begin(floor(0, 0));
        square.addCorner(0, 0, 0, 0, 0, -1);
        square.addCorner(2, 0, 0, 0, 0, -1);
        square.addCorner(0, 1, 0, 0, 0, -1);
        assertThat(square.close()).isTrue();
        assertThat(square.area()).isEqualTo(1);
        for (double wrong : new double[] {0, -1, Double.NaN, Double.POSITIVE_INFINITY}) {
            square.area(wrong);
            assertThat(square.close()).isFalse();
        }
    }

    @Test
    void close_givenNeighbours_findsExactlyTheSamePlaneOnce() {
        SplittableRandom random = new SplittableRandom(2);
        for (int i = 0; i < 1000; i++) {
            Vector3 eye = new Vector3(random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(1, 3));
            SurfacePoint p = floor(random.nextDouble(), random.nextDouble(2, 3));
            SurfacePoint q = floor(random.nextDouble(), random.nextDouble(-3, -2));
            Footprint left = seenFrom(eye, p, q, floor(-1, random.nextDouble(-1, 1)));
            Footprint right = seenFrom(eye, floor(2, random.nextDouble(-1, 1)), q, p);
            assertThat(left.close() && right.close()).isTrue();
            // The edge is the first of the one and the second of the other.
            for (int axis = 0; axis < 3; axis++) {
                assertThat(right.sides.normals[3 + axis]).isEqualTo(-left.sides.normals[axis]);
                assertThat(right.sides.middles[3 + axis]).isEqualTo(left.sides.middles[axis]);
            }
            assertThat(right.sides.holdsPlane[1]).isNotEqualTo(left.sides.holdsPlane[0]);
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-30, 1e-6, 1, 1e9, 1e30})
    void close_givenAnyScale_isTrue(double scale) {
        Footprint square =
                seenFrom(EYE.times(scale), floor(0, 0), floor(scale, 0), floor(scale, scale), floor(0, scale));
        assertThat(square.close()).isTrue();
        assertThat(square.area()).isCloseTo(scale * scale, within(1e-15 * scale * scale));
    }

    private static Footprint square() {
        return seenFrom(EYE, floor(0, 0), floor(1, 0), floor(1, 1), floor(0, 1));
    }
}
