package org.diacaustic.shape;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;
import static org.diacaustic.shape.Line.v;

import org.diacaustic.math.Vector3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class MappingTest {
    /** Eq. 4 with the pole up and the equator along x, to more digits than its arc cosines keep. */
    @ParameterizedTest
    @CsvSource({
        "0, 1, 0, 0, 1",
        "0, -1, 0, 0, 0",
        "1e-9, 1, 0, 0, 0.9999999996816901138162093",
        "1, 0, 1e-16, 0.9999999999999999840845057, 0.5",
        "1, 0, -1e-9, 1.591549430918953456282553e-10, 0.5",
        "1, 0, 0, 0, 0.5",
        "-1, 0, 1e-17, 0.5000000000000000015915494, 0.5"
    })
    void map_givenNormalOfUnitSphere_isThatOfTheThesis(double x, double y, double z, double u, double v) {
        Hit hit = on(x, y, z, x, y, z);
        SphericalMapping.UPRIGHT.map(hit);
        assertThat(hit.u).isCloseTo(u, within(4e-16));
        assertThat(hit.v).isCloseTo(v, within(4e-16));
    }

    @Test
    void mapping_givenBadArguments_isRefused() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new PlanarMapping(Vector3.ZERO, Vector3.UNIT_X, Vector3.UNIT_X))
                .withMessageContaining("parallel");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new PlanarMapping(Vector3.ZERO, Vector3.ZERO, Vector3.UNIT_X));
        assertThatIllegalArgumentException().isThrownBy(() -> new CylindricalMapping(Vector3.ZERO, Vector3.ZERO));
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new CylindricalMapping(v(Double.NaN, 0, 0), Vector3.UNIT_Y))
                .withMessageContaining("base");
    }

    @Test
    void map_givenSkewPlanarMapping_solvesForTheSides() {
        // P = origin + 0.25·(2, 1, 0) + 0.5·(1, 3, 0)
        PlanarMapping mapping = new PlanarMapping(v(1, 1, 1), v(2, 1, 0), v(1, 3, 0));
        Hit hit = on(2, 2.75, 1, 0, 0, 1);
        mapping.map(hit);
        assertThat(hit.u).isCloseTo(0.25, within(2e-16));
        assertThat(hit.v).isCloseTo(0.5, within(2e-16));
        // On a surface that rises with x at 45° the tangents rise with it.
        Hit slope = on(2, 2.75, 1, -1, 0, 1);
        mapping.map(slope);
        assertThat(slope.tangentUZ).isCloseTo(2, within(1e-15));
        assertThat(slope.tangentVZ).isCloseTo(1, within(1e-15));
    }

    @Test
    void map_givenCylindricalMapping_goesAroundAndUp() {
        CylindricalMapping mapping = new CylindricalMapping(v(0, 1, 0), v(0, 4, 0));
        Hit hit = on(0, 2, -3, 0, 0, -1);
        mapping.map(hit);
        assertThat(hit.u).isEqualTo(0.25);
        assertThat(hit.v).isEqualTo(0.25);
        assertThat(hit.tangentVY).isEqualTo(4);
        assertThat(hit.tangentUX).isCloseTo(-6 * Math.PI, within(1e-14));
        // One period further up.
        Hit above = on(0, 6, -3, 0, 0, -1);
        mapping.map(above);
        assertThat(above.v).isEqualTo(0.25);
    }

    private static Hit on(double x, double y, double z, double nx, double ny, double nz) {
        Hit hit = new Hit();
        hit.setPoint(x, y, z, 0);
        Vector3 normal = v(nx, ny, nz).normalized();
        hit.setNormal(normal.x(), normal.y(), normal.z());
        return hit;
    }
}
