package org.diacaustic.map;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;
import static org.assertj.core.api.Assertions.within;
import static org.diacaustic.map.TestCells.floor;

import java.util.function.DoubleBinaryOperator;
import org.diacaustic.math.Rgb;
import org.diacaustic.math.Vector3;
import org.diacaustic.parallel.Workers;
import org.junit.jupiter.api.Test;

/** A mesh of one or two cells, whose light a formula brings from the unit square to the plane z = 0: 6 W for a unit of it. */
class RaySolverTest {
    private final Rgb found = new Rgb();

    private static CellSeed seed(double... corners) {
        CellSeed seed = new CellSeed();
        seed.path = 1;
        seed.p0 = corners[0];
        seed.q0 = corners[1];
        seed.p1 = corners[2];
        seed.q1 = corners[3];
        seed.p2 = corners[4];
        seed.q2 = corners[5];
        return seed;
    }

    /** Light of the cells, 3 W each: half of a unit square of light space. */
    private double irradiance(Formula light, double x, double y, CellSeed... cells) {
        CellStore store = CellStore.keepingSeeds(Vector3.ZERO, 1, 1, 100);
        CellSlice slice = store.slice();
        for (CellSeed cell : cells) {
            slice.addTriangle(
                    light.landing(cell.p0, cell.q0),
                    light.landing(cell.p1, cell.q1),
                    light.landing(cell.p2, cell.q2),
                    new Rgb().set(3, 3, 3),
                    cell);
        }
        store.append(slice);
        CausticMesh.movedFrom(store, new Workers(1)).lookup(light).irradiance(floor(x, y), found);
        assertThat(found.red).isEqualTo(found.blue);
        return found.green;
    }

    @Test
    void irradiance_givenBentLight_isThatOfTheRay() {
        // x = p + p²/4, y = q: dx/dp = 1 + p/2. At p = 0.4, x = 0.44 and dx/dp = 1.2: 6 / 1.2 = 5.
        Formula bent = new Formula((p, q) -> p + p * p / 4, (p, q) -> q);
        assertThat(irradiance(bent, 0.44, 0.3, seed(0, 0, 1, 0, 0, 1))).isCloseTo(5, within(1e-6));
        // The triangle itself has 3 W on (0, 0), (1.25, 0), (0, 1): 4.8.
        assertThat(irradiance(bent.broken(), 0.44, 0.3, seed(0, 0, 1, 0, 0, 1))).isCloseTo(4.8, within(1e-6));
    }

    @Test
    void irradiance_givenLightTurnedOver_isThatOfTheRay() {
        Formula turned = new Formula((p, q) -> -p - p * p / 4, (p, q) -> q);
        assertThat(irradiance(turned, -0.44, 0.3, seed(0, 0, 1, 0, 0, 1))).isCloseTo(5, within(1e-6));
    }

    @Test
    void irradiance_givenLightFoldedWithinTheCell_isThatOfTheTriangle() {
        // x = p − 0.6·p² turns back at p = 0.83. The triangle is (0, 0), (0.4, 0), (0, 1): 3 / 0.2.
        Formula folded = new Formula((p, q) -> p - 0.6 * p * p, (p, q) -> q);
        assertThat(irradiance(folded, 0.1, 0.2, seed(0, 0, 1, 0, 0, 1))).isCloseTo(15, within(1e-5));
    }

    @Test
    void irradiance_givenARayFarOutsideOfTheCell_isThatOfTheTriangle() {
        // Between the corners y = q + 4·p·(1 − p): the ray that lands at (0.5, 0.25) has p = 0.449 and q = −0.74.
        Formula lifted = new Formula((p, q) -> p + p * p / 4, (p, q) -> q + 4 * p * (1 - p));
        assertThat(irradiance(lifted, 0.5, 0.25, seed(0, 0, 1, 0, 0, 1))).isCloseTo(4.8, within(1e-5));
    }

    @Test
    void irradiance_givenOneRayInTwoTriangles_countsItOnce() {
        // Triangles of cells that have an edge in common lie over each other where the edge of one is cut and bent.
        Formula even = new Formula((p, q) -> p, (p, q) -> q);
        CellSeed cell = seed(0, 0, 1, 0, 0, 1);
        CellSeed lapping = seed(1, 0, 0.9, 0.9, 0.05, 0.9);
        assertThat(irradiance(even, 0.5, 0.48, cell, lapping)).isCloseTo(6, within(1e-6));
        lapping.path = 2;
        assertThat(irradiance(even, 0.5, 0.48, cell, lapping)).isCloseTo(12, within(1e-6));
    }

    @Test
    void irradiance_givenCellsWithoutSeed_isThatOfTheTriangle() {
        CellSeed unknown = seed(0, 0, 1, 0, 0, 1);
        unknown.chart = -1;
        Formula bent = new Formula((p, q) -> p + p * p / 4, (p, q) -> q);
        assertThat(irradiance(bent, 0.44, 0.3, unknown)).isCloseTo(4.8, within(1e-6));
        assertThat(irradiance(bent, 1.2, 1.2, seed(0, 0, 1, 0, 0, 1))).isZero();
    }

    @Test
    void irradiance_givenLightThatSpreadsFast_isThatOfTheRay() {
        // x = p ÷ (1.001 − p): at p = 0.5, x = 1 / 1.002 and dx/dp = 1.001 / 0.501². The triangle reaches to 1000.
        Formula far = new Formula((p, q) -> p / (1.001 - p), (p, q) -> q);
        double expected = 6 * 0.501 * 0.501 / 1.001;
        assertThat(irradiance(far, 0.5 / 0.501, 0.3, seed(0, 0, 1, 0, 0, 1))).isCloseTo(expected, within(1e-11));
    }

    @Test
    void irradiance_givenAPointBetweenTheTrianglesOfLargeAndSmallCells_isThatOfTheRay() {
        // The edge q = 0 lands on y = −p·(1 − p)/10, in between the triangle above, which ends at y = 0, and the two
        // below.
        Formula bent = new Formula((p, q) -> p, (p, q) -> q - 0.1 * p * (1 - p));
        CellSeed large = seed(0, 0, 1, 0, 0, 1);
        CellSeed left = seed(0, 0, 0, -0.5, 0.5, 0);
        CellSeed right = seed(0.5, 0, 0.5, -0.5, 1, 0);
        // At x = 0.25 the edge is at −0.01875, and that of the small triangle at −0.0125.
        assertThat(irradiance(bent, 0.25, -0.005, large, left, right)).isCloseTo(6, within(1e-10));
        assertThat(irradiance(bent, 0.25, -0.015, large, left, right)).isCloseTo(6, within(1e-10));
        assertThat(irradiance(bent, 0.25, -0.03, large, left, right)).isCloseTo(6, within(1e-10));
        assertThat(irradiance(bent, 0.25, -0.005, left, right)).isZero();
    }

    @Test
    void lookup_givenAMeshWithoutSeeds_isRefused() {
        CausticMesh mesh = new TestCells().grid(2, 1).mesh();
        Formula even = new Formula((p, q) -> p, (p, q) -> q);
        assertThatIllegalStateException().isThrownBy(() -> mesh.lookup(even)).withMessageContaining("seeds");
    }

    /** Brings light from (p, q) to (x, y). */
    private static final class Formula implements LightPaths {
        private final DoubleBinaryOperator x;
        private final DoubleBinaryOperator y;
        private boolean isBroken;
        private CellSeed cell;

        Formula(DoubleBinaryOperator x, DoubleBinaryOperator y) {
            this.x = x;
            this.y = y;
        }

        /** Loses all rays. */
        Formula broken() {
            isBroken = true;
            return this;
        }

        SurfacePoint landing(double p, double q) {
            return floor(x.applyAsDouble(p, q), y.applyAsDouble(p, q));
        }

        @Override
        public void enter(CellSeed seed) {
            cell = seed;
        }

        @Override
        public boolean follow(double s, double t, SurfacePoint at, Rgb power) {
            SurfacePoint landing = landing(
                    cell.p0 + s * (cell.p1 - cell.p0) + t * (cell.p2 - cell.p0),
                    cell.q0 + s * (cell.q1 - cell.q0) + t * (cell.q2 - cell.q0));
            at.x = landing.x;
            at.y = landing.y;
            at.z = landing.z;
            double area =
                    Math.abs((cell.p1 - cell.p0) * (cell.q2 - cell.q0) - (cell.p2 - cell.p0) * (cell.q1 - cell.q0));
            power.set(6 * area, 6 * area, 6 * area);
            return !isBroken;
        }
    }
}
