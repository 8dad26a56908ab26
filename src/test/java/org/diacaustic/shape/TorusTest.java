package org.diacaustic.shape;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;
import static org.diacaustic.shape.Line.v;

import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.apache.commons.math3.analysis.solvers.LaguerreSolver;
import org.apache.commons.math3.complex.Complex;
import org.diacaustic.math.Vector3;
import org.junit.jupiter.api.Test;

class TorusTest {
    private final Torus torus = new Torus(Vector3.ZERO, Vector3.UNIT_Y, 1, 0.25);

    @Test
    void torus_givenBadArguments_isRefused() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Torus(Vector3.ZERO, Vector3.UNIT_Y, 1, 1))
                .withMessageContaining("radii");
        assertThatIllegalArgumentException().isThrownBy(() -> new Torus(Vector3.ZERO, Vector3.UNIT_Y, 1, 0));
        assertThatIllegalArgumentException().isThrownBy(() -> new Torus(Vector3.ZERO, Vector3.ZERO, 1, 0.5));
        assertThatIllegalArgumentException().isThrownBy(() -> new Torus(v(Double.NaN, 0, 0), Vector3.UNIT_Y, 1, 0.5));
    }

    @Test
    void intersect_givenFourRoots_findsThemOneAfterTheOther() {
        List<Double> found = Line.crossings(torus, v(-5, 0.1, 0.05), v(1, 0, 0));
        assertThat(found).hasSize(4);
        assertThat(found.get(0)).isCloseTo(3.771888616820288570115257, within(2e-15));
        assertThat(found.get(1)).isCloseTo(4.23075203574892965284742, within(4e-15));
        assertThat(found.get(2)).isCloseTo(5.76924796425107034715258, within(6e-15));
        assertThat(found.get(3)).isCloseTo(6.228111383179711429884743, within(8e-15));
    }

    @Test
    void intersect_givenRayJustInsideTheTopCircle_separatesThePairs() {
        // y is 1e-10 relative below the top: the roots are 5 ∓ R ± √(r² − y²), in pairs 7.07e-6 apart.
        List<Double> found = Line.crossings(torus, v(-5, 0.249999999975, 0), v(1, 0, 0));
        assertThat(found).hasSize(4);
        assertThat(found.get(0)).isCloseTo(3.999996464465947889960234, within(3.1e-11));
        assertThat(found.get(1)).isCloseTo(4.000003535534052110039766, within(3.1e-11));
        assertThat(found.get(2)).isCloseTo(5.999996464465947889960234, within(3.1e-11));
        assertThat(found.get(3)).isCloseTo(6.000003535534052110039766, within(3.1e-11));
    }

    @Test
    void intersect_givenRayTangentToTheTopCircle_findsPairsOrNone() {
        // Double roots at 4 and 6; a quadruple one at 5: touching is met twice or not at all.
        assertThat(Line.crossings(torus, v(-5, 0.25, 0), v(1, 0, 0)).size() % 2).isZero();
        assertThat(Line.crossings(torus, v(1, 0.25, -5), v(0, 0, 1)).size() % 2).isZero();
        assertThat(Line.crossings(torus, v(-5, 0.2500001, 0), v(1, 0, 0))).isEmpty();
    }

    @Test
    void intersect_givenRayJustBelowTheQuadrupleRoot_findsBothSides() {
        // 5 ± √(2R)·(2r·1e-12)^¼ = 5 ± 1.189e-3
        List<Double> found = Line.crossings(torus, v(1, 0.249999999999, -5), v(0, 0, 1));
        assertThat(found).hasSize(2);
        assertThat(found.get(0)).isCloseTo(4.998810790999821179062574, within(1.3e-7));
        assertThat(found.get(1)).isCloseTo(5.001189209000178820937426, within(1.3e-7));
    }

    @Test
    void intersect_givenRayFromAMillionRadiiAway_keepsItsDigits() {
        List<Double> found = Line.crossings(
                torus, v(1e6, 3e5, 2e5), v(-0.9407208001188203, -0.2822164469944084, -0.1881442352814958));
        assertThat(found).hasSize(2);
        assertThat(found.get(0)).isCloseTo(1063013.385842901235142038, within(3.8e-9));
        assertThat(found.get(1)).isCloseTo(1063013.864533719202635367, within(3.8e-9));
    }

    @Test
    void intersect_givenRandomRays_agreesWithLaguerre() {
        LaguerreSolver laguerre = new LaguerreSolver();
        SplittableRandom random = new SplittableRandom(5);
        int compared = 0;
        for (int i = 0; i < 1000; i++) {
            Vector3 o = v(random.nextDouble(-2, 2), random.nextDouble(2, 3), random.nextDouble(-2, 2));
            Vector3 d = v(random.nextDouble(-1, 1), 0, random.nextDouble(-1, 1)).minus(o);
            // (|o + t·d|² + R² − r²)² − 4·R²·|(o + t·d)⊥|², multiplied out.
            double g = o.dot(o) + 1 - 0.0625;
            double od = o.dot(d);
            double dd = d.dot(d);
            double[] c = {
                g * g - 4 * (o.x() * o.x() + o.z() * o.z()),
                4 * od * g - 8 * (o.x() * d.x() + o.z() * d.z()),
                4 * od * od + 2 * g * dd - 4 * (d.x() * d.x() + d.z() * d.z()),
                4 * od * dd,
                dd * dd
            };
            double[] expected = Arrays.stream(laguerre.solveAllComplex(c, 0))
                    .filter(z -> Math.abs(z.getImaginary()) < 1e-6)
                    .mapToDouble(Complex::getReal)
                    .sorted()
                    .toArray();
            List<Double> found = Line.crossings(torus, o, d);
            assertThat(found).hasSize(expected.length);
            for (int k = 0; k < expected.length; k++) {
                assertThat(found.get(k)).isCloseTo(expected[k], within(1e-9));
                compared++;
            }
        }
        assertThat(compared).isGreaterThan(1000);
    }
}
