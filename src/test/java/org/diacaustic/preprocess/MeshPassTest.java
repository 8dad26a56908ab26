package org.diacaustic.preprocess;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.diacaustic.light.Falloff;
import org.diacaustic.light.Light;
import org.diacaustic.light.PointLight;
import org.diacaustic.map.StoredCells;
import org.diacaustic.math.Color;
import org.diacaustic.math.Vector3;
import org.diacaustic.scene.Scene;
import org.diacaustic.scene.Settings;
import org.diacaustic.shape.ConvexPolygon;
import org.diacaustic.shape.Plane;
import org.diacaustic.shape.Sphere;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What cells a pass makes, and with which power. */
class MeshPassTest {
    private static final Settings PHYSICAL = Settings.physical();

    /** Of each cell's power, in single precision. */
    private static final double STORING = 1e-7;

    static List<String> preProcessors() {
        return List.of("own-map", "planar", "cube", "adaptive");
    }

    static List<Light> lights() {
        return ForwardPassTest.lights();
    }

    private static double gap(EnergyLedger ledger) {
        double rest = ledger.emitted() - ledger.stored() - ledger.absorbed() - ledger.escaped() - ledger.cut();
        return Math.abs(rest) / ledger.emitted();
    }

    @ParameterizedTest
    @MethodSource("lights")
    void run_givenAnyLight_closesItsLedger(Light light) {
        for (String preProcessor : preProcessors()) {
            MeshPass pass = MeshLight.pass(Forward.ballsOverFloor(light), PHYSICAL, preProcessor, 6000, 2);
            assertThat(gap(pass.ledger())).as(preProcessor).isLessThan(1e-12);
            assertThat(pass.ledger().stored()).as(preProcessor).isPositive();
            assertThat(pass.counters().nonFinite()).as(preProcessor).isZero();
        }
    }

    /** Nothing in the scene mirrors what it is lit by, so what is stored is what arrives: all of it is in cells. */
    @ParameterizedTest
    @MethodSource("preProcessors")
    void run_givenInverseSquare_putsAllThatIsStoredIntoCells(String preProcessor) {
        Scene scene = Forward.ballsOverFloor(new PointLight(new Vector3(0.1, 7, 0.2), Color.WHITE));
        for (long rays = 500; rays <= 32_000; rays *= 8) {
            MeshPass pass = MeshLight.pass(scene, PHYSICAL, preProcessor, rays, 2);
            double stored = pass.ledger().stored();
            assertThat(StoredCells.power(pass.cells()).sum()).isCloseTo(stored, within(STORING * stored));
        }
    }

    /** The larger cells are of the same light: their power differs by no more than that of a coarser mesh would. */
    @ParameterizedTest
    @MethodSource("preProcessors")
    void largeCells_givenAnyScene_haveNearlyTheSamePower(String preProcessor) {
        Scene scene = Forward.ballsOverFloor(new PointLight(new Vector3(0.1, 7, 0.2), Color.WHITE));
        MeshPass pass = MeshLight.pass(scene, PHYSICAL, preProcessor, 32_000, 2);
        double power = StoredCells.power(pass.cells()).green;
        assertThat(StoredCells.power(pass.largeCells()).green).isCloseTo(power, within(0.002 * power));
    }

    /**
     * Two panes, one partly behind the other as the lamp sees them, a window each: light through one, through the other, and
     * through both. From the lamp the high pane, 8 below it, is seen as one 2 below and a quarter as large; the low one, 10
     * below, as one a fifth as large: rectangles on one plane.
     */
    @ParameterizedTest
    @MethodSource("preProcessors")
    void run_givenWindowsThatOverlap_sendsAllLightOnce(String preProcessor) {
        Scene scene = Scene.builder()
                .camera(Forward.camera())
                .light(Forward.lamp(new Vector3(0, 12, 0), new Falloff.InverseSquare()))
                .object("floor", new Plane(Vector3.ZERO, Vector3.UNIT_Y), Forward.MATT)
                .object("high", pane(4, -2, -2, 2, 2), Forward.clear(1, 0.9))
                .object("low", pane(2, -1, -1, 4, 3), Forward.clear(1, 0.8))
                .build();
        double high = solidAngle(2, -0.5, -0.5, 0.5, 0.5);
        double low = solidAngle(2, -0.2, -0.2, 0.8, 0.6);
        double both = solidAngle(2, -0.2, -0.2, 0.5, 0.5);
        double power = 0.9 * (high - both) + 0.8 * (low - both) + 0.9 * 0.8 * both;
        double found = MeshLight.of(scene, PHYSICAL, preProcessor, 1 << 16).total().green;
        assertThat(found).isCloseTo(power, within(0.01 * power));
        Settings whole = Forward.settings(s -> s.aimAtSpecular(false));
        double unaimed = MeshLight.of(scene, whole, "cube", 1 << 18).total().green;
        assertThat(unaimed).isCloseTo(power, within(0.01 * power));
    }

    private static ConvexPolygon pane(double height, double lowX, double lowZ, double highX, double highZ) {
        return ConvexPolygon.twoSided(
                new Vector3(lowX, height, lowZ),
                new Vector3(lowX, height, highZ),
                new Vector3(highX, height, highZ),
                new Vector3(highX, height, lowZ));
    }

    /** Of a rectangle at a distance from the plane of the eye's point. */
    private static double solidAngle(double distance, double lowX, double lowZ, double highX, double highZ) {
        return corner(distance, highX, highZ)
                - corner(distance, lowX, highZ)
                - corner(distance, highX, lowZ)
                + corner(distance, lowX, lowZ);
    }

    private static double corner(double distance, double x, double z) {
        return Math.atan(x * z / (distance * Math.sqrt(x * x + z * z + distance * distance)));
    }

    @ParameterizedTest
    @MethodSource("preProcessors")
    void run_givenAnyNumberOfThreads_makesTheSameCellsInTheSameOrder(String preProcessor) {
        Scene scene = Forward.ballsOverFloor(new PointLight(new Vector3(0, 7, 0), Color.WHITE));
        MeshPass one = MeshLight.pass(scene, PHYSICAL, preProcessor, 30_000, 1);
        assertThat(one.cells().size()).isPositive();
        for (int threads : new int[] {2, 5}) {
            MeshPass many = MeshLight.pass(scene, PHYSICAL, preProcessor, 30_000, threads);
            assertThat(StoredCells.bits(many.cells())).isEqualTo(StoredCells.bits(one.cells()));
            assertThat(StoredCells.bits(many.largeCells())).isEqualTo(StoredCells.bits(one.largeCells()));
            assertThat(many.ledger().stored()).isEqualTo(one.ledger().stored());
        }
    }

    /** Lengths times 2^k: the same mesh. Its light is the same without falloff, and 4^−k of it with nature's. */
    @ParameterizedTest
    @ValueSource(ints = {-20, 20, 30})
    void irradiance_givenScaledScene_isTheSameToTheBit(int exponent) {
        for (String preProcessor : preProcessors()) {
            for (Falloff falloff : List.of(new Falloff.None(), new Falloff.InverseSquare())) {
                double factor = falloff instanceof Falloff.None ? 1 : Math.scalb(1.0, -2 * exponent);
                double scale = Math.scalb(1.0, exponent);
                MeshLight small = MeshLight.of(glass(1, falloff), PHYSICAL, preProcessor, 5000);
                MeshLight large = MeshLight.of(glass(scale, falloff), PHYSICAL, preProcessor, 5000);
                double sum = 0;
                for (int i = 0; i < 100; i++) {
                    double x = 0.2 * (i / 10) - 1;
                    double z = 0.2 * (i % 10) - 1;
                    double at = small.irradiance(MeshLight.above(0, 0, x, z, x + 0.2, z + 0.2));
                    double scaled = large.irradiance(
                            MeshLight.above(0, 0, x * scale, z * scale, (x + 0.2) * scale, (z + 0.2) * scale));
                    assertThat(scaled).as(preProcessor).isEqualTo(at * factor);
                    sum += at;
                }
                assertThat(sum).isPositive();
            }
        }
    }

    private static Scene glass(double scale, Falloff falloff) {
        return Scene.builder()
                .camera(Forward.camera())
                .light(Forward.lamp(new Vector3(0.1, 7, 0.2).times(scale), falloff))
                .object("floor", Forward.square(0, 5 * scale), Forward.MATT)
                .object("glass", new Sphere(new Vector3(0, 1.5, 0).times(scale), scale), Forward.clear(1.5, 1))
                .build();
    }
}
