package org.diacaustic.map;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.diacaustic.map.TestCells.density;
import static org.diacaustic.map.TestCells.floor;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class PointDensityTest {
    private final SplittableRandom random = new SplittableRandom(12);

    @ParameterizedTest
    @ValueSource(ints = {1, 7, 64})
    void irradiance_givenAnEvenGrid_isPowerOverArea(int squares) {
        CausticMesh mesh = new TestCells().grid(squares, 1).mesh();
        for (int i = 0; i < 1000; i++) {
            double found = density(mesh, floor(random.nextDouble(-0.99, 0.99), random.nextDouble(-0.99, 0.99)));
            assertThat(found).isCloseTo(1, within(1e-5));
        }
        assertThat(density(mesh, floor(1.01, 0))).isZero();
    }

    @Test
    void irradiance_givenEdgesAndVerticesOfAGrid_countsOneTriangleOnly() {
        CausticMesh mesh = new TestCells().grid(8, 1).mesh();
        for (int row = -15; row < 16; row++) {
            for (int column = -15; column < 16; column++) {
                assertThat(density(mesh, floor(column / 16.0, row / 16.0))).isCloseTo(1, within(1e-12));
            }
        }
    }

    @Test
    void irradiance_givenLightFoldedOverItself_isTheSum() {
        // Triangles of area 1/2 with 1 W and 3 W, one of them turned over; a point and a line of power beside.
        CausticMesh mesh = new TestCells()
                .triangle(1, floor(0, 0), floor(1, 0), floor(0, 1))
                .triangle(3, floor(0, 0), floor(0, 1), floor(1, 0))
                .point(100, floor(0.25, 0.25))
                .triangle(100, floor(0, 0), floor(0.25, 0.25), floor(0.5, 0.5))
                .mesh();
        assertThat(density(mesh, floor(0.25, 0.25))).isCloseTo(8, within(1e-6));
        assertThat(density(mesh, floor(0.25, 0.8))).isZero();
    }

    @Test
    void irradiance_givenASphere_isTheDensityOfItsChords() {
        // 1 W·m⁻² on the triangles; the sphere of radius 1 is at most 0.02 above them.
        TestCells cells = new TestCells();
        int n = 16;
        for (int band = 0; band < n; band++) {
            for (int step = 0; step < 2 * n; step++) {
                SurfacePoint a = onSphere(band, step, n);
                SurfacePoint b = onSphere(band + 1, step, n);
                SurfacePoint c = onSphere(band + 1, step + 1, n);
                SurfacePoint d = onSphere(band, step + 1, n);
                addEven(cells, a, b, c);
                addEven(cells, a, c, d);
            }
        }
        CausticMesh mesh = cells.mesh();
        double sum = 0;
        int points = 4000;
        for (int i = 0; i < points; i++) {
            double z = random.nextDouble(-1, 1);
            double angle = random.nextDouble(2 * Math.PI);
            double r = Math.sqrt(1 - z * z);
            double x = r * Math.cos(angle);
            double y = r * Math.sin(angle);
            double found = density(mesh, TestPhotons.point(x, y, z, x, y, z));
            // Beside an edge a point may be above neither triangle, or above both.
            assertThat(found).isBetween(0.0, 3.001);
            sum += found;
        }
        assertThat(sum / points).isCloseTo(1, within(0.02));
    }

    @Test
    void irradiance_givenAnotherFloorBelow_seesItsOwn() {
        TestCells cells = new TestCells().grid(8, 1);
        SurfacePoint[] below = {floor(-1, -1), floor(1, -1), floor(0, 1)};
        for (SurfacePoint corner : below) {
            corner.z = -1;
        }
        CausticMesh mesh = cells.triangle(100, below[0], below[1], below[2]).mesh();
        assertThat(density(mesh, floor(0.1, 0.1))).isCloseTo(1, within(1e-6));
        SurfacePoint between = floor(0.1, 0.1);
        between.z = -0.4;
        assertThat(density(mesh, between))
                .as("more than a quarter of 2.2 above the lower")
                .isZero();
        between.z = -0.55;
        assertThat(density(mesh, between)).isCloseTo(50, within(1e-4));
    }

    @Test
    void irradiance_givenWhatIsNotFinite_isNotANumber() {
        CausticMesh mesh = new TestCells().grid(2, 1).mesh();
        assertThat(density(mesh, floor(Double.NaN, 0))).isNaN();
        assertThat(density(mesh, floor(0, Double.POSITIVE_INFINITY))).isNaN();
        SurfacePoint noNormal = floor(0, 0);
        noNormal.normalX = Double.NaN;
        assertThat(density(mesh, noNormal)).isNaN();
    }

    private static void addEven(TestCells cells, SurfacePoint a, SurfacePoint b, SurfacePoint c) {
        double ux = b.x - a.x;
        double uy = b.y - a.y;
        double uz = b.z - a.z;
        double vx = c.x - a.x;
        double vy = c.y - a.y;
        double vz = c.z - a.z;
        double nx = uy * vz - uz * vy;
        double ny = uz * vx - ux * vz;
        double nz = ux * vy - uy * vx;
        cells.triangle(Math.sqrt(nx * nx + ny * ny + nz * nz) / 2, a, b, c);
    }

    private static SurfacePoint onSphere(int band, int step, int bands) {
        double polar = Math.PI * band / bands;
        double azimuth = Math.PI * step / bands;
        double x = Math.sin(polar) * Math.cos(azimuth);
        double y = Math.sin(polar) * Math.sin(azimuth);
        double z = Math.cos(polar);
        return TestPhotons.point(x, y, z, x, y, z);
    }
}
