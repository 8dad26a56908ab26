package org.diacaustic.shape;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;
import static org.diacaustic.shape.Line.v;

import java.util.List;
import org.diacaustic.math.Bounds;
import org.junit.jupiter.api.Test;

class QuadricTest {
    /** x² + z² = y. */
    private final Quadric paraboloid = Quadric.of(1, 0, 0, 0, 0, 0, -0.5, 1, 0, 0);

    @Test
    void of_givenBadCoefficients_isRefused() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Quadric.of(1, 2, 3))
                .withMessageContaining("10");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Quadric.of(0, 0, 0, 0, 0, 0, 0, 0, 0, 1))
                .withMessageContaining("besides j");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Quadric.of(1, 0, 0, Double.NaN, 1, 0, 0, 1, 0, -1))
                .withMessageContaining("coefficient d");
        // x² + y² + z² + 1 = 0
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Quadric.of(1, 0, 0, 0, 1, 0, 0, 1, 0, 1))
                .withMessageContaining("no solution");
        assertThatIllegalArgumentException().isThrownBy(() -> paraboloid.within(Bounds.EMPTY));
    }

    @Test
    void intersect_givenParaboloidAlongItsAxis_solvesTheLinearEquation() {
        assertThat(Line.crossings(paraboloid, v(0.5, 10, 0), v(0, -1, 0))).containsExactly(9.75);
    }

    @Test
    void intersect_givenParaboloidNearlyAlongItsAxis_keepsTheNearRoot() {
        List<Double> found = Line.crossings(paraboloid, v(0.5, 10, 0), v(1e-9, -1, 0));
        assertThat(found.get(0)).isCloseTo(9.7499999902499999146875, within(4e-15));
        // The other one lies a million light seconds behind, where a ray backwards finds it.
        Hit back = Line.meet(paraboloid, v(0.5, 10, 0), v(-1e-9, 1, 0));
        assertThat(back.t).isCloseTo(1000000000999999885.186817, within(8900.0));
    }

    @Test
    void intersect_givenConeAlongAGenerator_findsTheFiniteRoot() {
        Quadric cone = Quadric.of(1, 0, 0, 0, -1, 0, 0, 1, 0, 0);
        Hit hit = Line.meet(cone, v(0, 1, 0), v(-0.7071067811865476, -0.7071067811865476, 0));
        assertThat(hit.t).isCloseTo(0.7071067811865474760643778, within(1e-15));
    }

    @Test
    void intersect_givenCrossTerm_countsItTwice() {
        // x² + 2·½·xy + y² + z² = 1
        Quadric turned = Quadric.of(1, 0.5, 0, 0, 1, 0, 0, 1, 0, -1);
        List<Double> found = Line.crossings(turned, v(5, 0.25, 0.1), v(-1, 0, 0));
        assertThat(found.get(0)).isCloseTo(4.153853770022248400794759, within(4.4e-14));
        assertThat(found.get(1)).isCloseTo(6.096146229977751599205241, within(6.1e-14));
    }

    @Test
    void isClosed_givenEllipsoid_holdsUnlessTheBoxCutsIt() {
        Quadric sphere = Quadric.of(1, 0, 0, -2, 1, 0, 0, 1, 0, 0); // radius 2 about (2, 0, 0)
        assertThat(sphere.isClosed()).isTrue();
        assertThat(sphere.bounds().minX()).isCloseTo(0, within(1e-12)).isNotPositive();
        assertThat(sphere.bounds().maxX()).isCloseTo(4, within(1e-12)).isGreaterThanOrEqualTo(4);
        assertThat(sphere.within(new Bounds(-1, -3, -3, 5, 3, 3)).isClosed()).isTrue();
        assertThat(sphere.within(new Bounds(-1, -3, -3, 3, 3, 3)).isClosed()).isFalse();
        assertThat(paraboloid.isClosed()).isFalse();
        assertThat(paraboloid.bounds()).isEqualTo(Bounds.UNBOUNDED);
    }

    @Test
    void intersect_givenBox_leavesOutWhatIsBeyond() {
        Quadric bowl = paraboloid.within(new Bounds(-9, 0, -9, 9, 1, 9));
        assertThat(Line.crossings(bowl, v(-20, 0.25, 0), v(1, 0, 0))).containsExactly(19.5, 20.5);
        assertThat(Line.crossings(bowl, v(-20, 4, 0), v(1, 0, 0))).isEmpty();
    }

    @Test
    void complete_givenInsideOutSphere_hasItsNormalOutward() {
        Quadric inverted = Quadric.of(-1, 0, 0, 0, -1, 0, 0, -1, 0, 1);
        assertThat(Line.meet(inverted, v(5, 0, 0), v(-1, 0, 0)).normalX).isEqualTo(1);
    }
}
