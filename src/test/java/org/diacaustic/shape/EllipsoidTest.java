package org.diacaustic.shape;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;
import static org.diacaustic.shape.Line.v;

import java.util.List;
import org.diacaustic.math.Vector3;
import org.junit.jupiter.api.Test;

class EllipsoidTest {
    @Test
    void ellipsoid_givenBadArguments_isRefused() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Ellipsoid(Vector3.ZERO, v(1, 0, 1)))
                .withMessageContaining("radii");
        assertThatIllegalArgumentException().isThrownBy(() -> new Ellipsoid(Vector3.ZERO, v(1, Double.NaN, 1)));
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Ellipsoid(v(0, Double.NEGATIVE_INFINITY, 0), v(1, 1, 1)))
                .withMessageContaining("centre");
    }

    @Test
    void intersect_givenWaferThinEllipsoid_keepsAllDigits() {
        Ellipsoid wafer = new Ellipsoid(Vector3.ZERO, v(1, 1e-6, 1));
        Vector3 origin = v(0.3, 2, 0.2);
        Vector3 direction = v(0.09938079899999065, -0.9938079899999065, 0.049690399499995326);
        List<Double> found = Line.crossings(wafer, origin, direction);
        assertThat(found.get(0)).isCloseTo(2.012460362284149792541718, within(7.1e-15));
        assertThat(found.get(1)).isCloseTo(2.012461997215341005182217, within(7.1e-15));
        // The normal is p ÷ radius², at length 1.
        Hit hit = Line.meet(wafer, origin, direction);
        assertThat(hit.normalX).isCloseTo(6.154573056540866776531197e-7, within(4.5e-21));
        assertThat(hit.normalY).isCloseTo(0.9999999999997424243636508, within(1.8e-15));
        assertThat(hit.normalZ).isCloseTo(3.692743933924520278267782e-7, within(2.7e-21));
    }

    @Test
    void intersect_givenNeedleAlongItsAxis_keepsAllDigits() {
        Ellipsoid needle = new Ellipsoid(Vector3.ZERO, v(1000, 0.001, 1));
        List<Double> found = Line.crossings(needle, v(5000, 0.0001, 0.1), v(-1, 0, 0));
        assertThat(found.get(0)).isCloseTo(4010.050506338833466673368, within(1.6e-11));
        assertThat(found.get(1)).isCloseTo(5989.949493661166533326632, within(2.1e-11));
        Hit hit = Line.meet(needle, v(5000, 0.0001, 0.1), v(-1, 0, 0));
        assertThat(hit.normalX).isCloseTo(0.000009899489986382834748442778, within(5.3e-20));
        assertThat(hit.normalY).isCloseTo(0.9999994999513750731909607, within(1.8e-15));
        assertThat(hit.normalZ).isCloseTo(0.0009999994999513751224137147, within(7.1e-18));
    }

    @Test
    void inverseMap_givenTopAndFront_isThatOfTheSphere() {
        Ellipsoid egg = new Ellipsoid(v(1, 2, 3), v(1, 3, 2));
        Hit top = Line.meet(egg, v(1, 9, 3), v(0, -1, 0));
        egg.inverseMap(top);
        assertThat(top.v).isEqualTo(1);
        Hit side = Line.meet(egg, v(9, 2, 3), v(-1, 0, 0));
        egg.inverseMap(side);
        assertThat(side.u).isZero();
        assertThat(side.v).isCloseTo(0.5, within(1e-15));
        // A full turn at the equator is 2π·2 long where it starts, along −z.
        assertThat(side.tangentUZ).isCloseTo(-4 * Math.PI, within(1e-14));
    }
}
