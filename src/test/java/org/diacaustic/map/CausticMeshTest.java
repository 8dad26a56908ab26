package org.diacaustic.map;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.diacaustic.math.Rgb;
import org.diacaustic.math.Vector3;
import org.diacaustic.parallel.Workers;
import org.junit.jupiter.api.Test;

class CausticMeshTest {
    private final SplittableRandom random = new SplittableRandom(3);
    private final Rgb power = new Rgb();
    private final Footprint footprint = new Footprint();

    @Test
    void irradiance_givenAnEvenGrid_isPowerOverArea() {
        CellStore store = new CellStore(Vector3.ZERO, 1, 100_000);
        CellSlice slice = store.slice();
        int n = 40;
        for (int row = 0; row < n; row++) {
            for (int column = 0; column < n; column++) {
                power.set(2.0 / n / n, 1.0 / n / n, 0);
                SurfacePoint a = at(column, row, n);
                SurfacePoint b = at(column + 1, row, n);
                SurfacePoint c = at(column + 1, row + 1, n);
                SurfacePoint d = at(column, row + 1, n);
                slice.addTriangle(a, b, c, power);
                slice.addTriangle(a, c, d, power);
            }
        }
        store.append(slice);
        CausticMesh mesh = CausticMesh.movedFrom(store, new Workers(2));
        FootprintLookup lookup = mesh.lookup();
        // 4 W of red on 4 m².
        for (int i = 0; i < 1000; i++) {
            double x = random.nextDouble(-0.9, 0.9);
            double y = random.nextDouble(-0.9, 0.9);
            double size = random.nextDouble(0.001, 0.1);
            SurfacePoint at = TestPhotons.floorPoint(x, y, true);
            footprint.begin(at);
            corner(x - size, y - size);
            corner(x + size, y - size);
            corner(x + size * 0.3, y + size);
            corner(x - size, y + size * 0.5);
            assertThat(footprint.close()).isTrue();
            lookup.irradiance(footprint, at, power);
            assertThat(power.red).isCloseTo(1, within(1e-5));
            assertThat(power.green).isCloseTo(0.5, within(1e-5));
            lookup.irradiance(at, power);
            assertThat(power.red).isCloseTo(1, within(1e-5));
        }
    }

    private void corner(double x, double y) {
        footprint.addCorner(x, y, 0, 0.6, 0, -0.8);
    }

    private static SurfacePoint at(int column, int row, int n) {
        return TestPhotons.floorPoint(2.0 * column / n - 1, 2.0 * row / n - 1, true);
    }
}
