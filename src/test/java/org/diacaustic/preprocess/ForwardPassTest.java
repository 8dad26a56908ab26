package org.diacaustic.preprocess;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.diacaustic.light.DirectionalLight;
import org.diacaustic.light.Falloff;
import org.diacaustic.light.FlatLight;
import org.diacaustic.light.Light;
import org.diacaustic.light.PointLight;
import org.diacaustic.light.SphereLight;
import org.diacaustic.light.SpotLight;
import org.diacaustic.map.PhotonStore;
import org.diacaustic.map.SurfacePoint;
import org.diacaustic.material.Material;
import org.diacaustic.material.Medium;
import org.diacaustic.math.Color;
import org.diacaustic.math.Rgb;
import org.diacaustic.math.Vector3;
import org.diacaustic.parallel.Workers;
import org.diacaustic.scene.Scene;
import org.diacaustic.scene.Settings;
import org.diacaustic.shape.Box;
import org.diacaustic.shape.Plane;
import org.diacaustic.shape.Sphere;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

class ForwardPassTest {
    private static final Settings PHYSICAL = Settings.physical();
    /** Lattices stand on so many points of a lamp; of few, it matters which. */
    private static final int LAMP_POINTS = 100;

    private static final Falloff NATURE = new Falloff.InverseSquare();

    static List<String> preProcessors() {
        return List.of("random", "monte-carlo", "planar", "cube", "own-map", "adaptive");
    }

    private static double gap(EnergyLedger ledger) {
        double rest = ledger.emitted() - ledger.stored() - ledger.absorbed() - ledger.escaped() - ledger.cut();
        return Math.abs(rest) / ledger.emitted();
    }

    static List<Light> lights() {
        Vector3 at = new Vector3(0.4, 7, 0.3);
        Vector3 down = new Vector3(-0.05, -1, -0.02);
        return List.of(
                new PointLight(at, Color.WHITE),
                new SpotLight(at, down, 5, 12, Color.WHITE, NATURE, 0),
                new DirectionalLight(down, Color.WHITE, 0),
                FlatLight.disc(at, down, 0.5, Color.WHITE, NATURE, LAMP_POINTS),
                FlatLight.rectangle(
                        at, new Vector3(1, 0, 0), new Vector3(0, 0, 1), Color.WHITE, new Falloff.None(), LAMP_POINTS),
                new SphereLight(at, 0.3, Color.WHITE, NATURE, LAMP_POINTS));
    }

    /** Every light, every pre-processor: what is sent out is found again. */
    @ParameterizedTest
    @MethodSource("lights")
    void run_givenAnyLight_closesItsLedger(Light light) {
        for (String preProcessor : preProcessors()) {
            ForwardPass pass = Forward.run(Forward.ballsOverFloor(light), PHYSICAL, preProcessor, 6000);
            assertThat(gap(pass.ledger())).as(preProcessor).isLessThan(1e-12);
            assertThat(pass.ledger().stored()).as(preProcessor).isGreaterThan(0);
            assertThat(pass.counters().nonFinite()).as(preProcessor).isZero();
        }
    }

    /** The flux through the glass ball does not depend on how its rays are chosen. */
    @ParameterizedTest
    @MethodSource("lights")
    void run_givenAnyLight_storesTheSameFluxWhateverChoseTheRays(Light light) {
        Scene scene = Forward.ballsOverFloor(light);
        double random = Forward.run(scene, PHYSICAL, "random", 400_000).ledger().stored();
        for (String preProcessor : preProcessors()) {
            double stored =
                    Forward.run(scene, PHYSICAL, preProcessor, 60_000).ledger().stored();
            assertThat(stored).as(preProcessor).isCloseTo(random, within(0.03 * random));
        }
    }

    private static double power(PhotonStore photons) {
        Rgb power = new Rgb();
        double sum = 0;
        for (int i = 0; i < photons.size(); i++) {
            photons.power(i, power);
            sum += power.green;
        }
        return sum;
    }

    /** A lamp in the middle of a ball of n = 1.5 meets it at right angles: 4 % is mirrored, to and fro until it is out. */
    @Test
    void run_givenLampInGlass_letsOutWhatFresnelSays() {
        Scene scene = Scene.builder()
                .camera(Forward.camera())
                .light(new PointLight(Vector3.ZERO, Color.WHITE))
                .object("bulb", new Sphere(Vector3.ZERO, 1), Forward.clear(1.5, 1))
                .build();
        Settings first = Forward.settings(s -> s.maxDepth(1).followReflections(false));
        EnergyLedger ledger = Forward.run(scene, first, "cube", 600).ledger();
        assertThat(ledger.escaped() / ledger.emitted()).isCloseTo(0.96, within(1e-12));
        assertThat(ledger.cut() / ledger.emitted()).isCloseTo(0.04, within(1e-12));
        EnergyLedger all = Forward.run(
                        scene, PHYSICAL.toBuilder().minimumThroughput(0).build(), "cube", 600)
                .ledger();
        assertThat(all.escaped() / all.emitted()).isCloseTo(1, within(1e-12));
    }

    /** Absorption 0.8 over a radius of 1 leaves e^−0.8 of it, of which 0.96 gets out: 0.43135580555. */
    @Test
    void run_givenLampInTintedGlass_booksWhatIsAbsorbed() {
        Material tinted = Material.builder()
                .transparency(Color.WHITE)
                .inside(new Medium(1.5, Color.grey(0.8), 0))
                .build();
        Scene scene = Scene.builder()
                .camera(Forward.camera())
                .light(new PointLight(Vector3.ZERO, Color.WHITE))
                .object("bulb", new Sphere(Vector3.ZERO, 1), tinted)
                .build();
        EnergyLedger ledger = Forward.run(
                        scene, Forward.settings(s -> s.maxDepth(1).followReflections(false)), "cube", 600)
                .ledger();
        assertThat(ledger.escaped() / ledger.emitted()).isCloseTo(0.43135580555, within(1e-11));
        assertThat(gap(ledger)).isLessThan(1e-12);
    }

    /**
     * Lamp and stone in a clear box that dominates a ball around the stone: the ball's boundary is invisible, but shadow rays
     * end there, so the pass must bring all that the stone gets: 2π(1 − √(1 − (0.5 ÷ 3)²)) = 0.08788.
     */
    @ParameterizedTest
    @ValueSource(strings = {"random", "monte-carlo", "cube", "own-map", "adaptive"})
    void run_givenInvisibleBoundaryBeforeStone_bringsItsLight(String preProcessor) {
        Material dominating = Material.builder()
                .transparency(Color.WHITE)
                .inside(new Medium(1, Color.BLACK, 1))
                .build();
        Scene scene = Scene.builder()
                .camera(Forward.camera())
                .light(new PointLight(new Vector3(0, 3, 0), Color.WHITE))
                .object("box", new Box(new Vector3(-5, -5, -5), new Vector3(5, 5, 5)), dominating)
                .object("hidden", new Sphere(Vector3.ZERO, 1), Forward.clear(1.5, 1))
                .object("stone", new Sphere(Vector3.ZERO, 0.5), Forward.MATT)
                .build();
        ForwardPass pass = Forward.run(scene, PHYSICAL, preProcessor, 200_000);
        assertThat(power(pass.photons())).isCloseTo(0.08788, within(0.005));
        assertThat(gap(pass.ledger())).isLessThan(1e-12);
    }

    /** Two boxes of glass in each other's windows: aimed or not, the floor gets the same. */
    @Test
    void run_givenWindowsThatOverlap_emitsNothingTwice() {
        Scene scene = Scene.builder()
                .camera(Forward.camera())
                .light(new PointLight(new Vector3(0, 9, 0), Color.WHITE))
                .object("floor", new Plane(Vector3.ZERO, Vector3.UNIT_Y), Forward.MATT)
                .object("high", new Box(new Vector3(-1, 3, -1), new Vector3(1, 3.3, 1)), Forward.clear(1.5, 0.7))
                .object("low", new Box(new Vector3(-0.2, 1, -2), new Vector3(4, 1.2, 2)), Forward.clear(1.3, 0.8))
                .build();
        ForwardPass aimed = Forward.run(scene, PHYSICAL, "cube", 200_000);
        ForwardPass whole = Forward.run(scene, Forward.settings(s -> s.aimAtSpecular(false)), "cube", 4_000_000);
        double expected = power(whole.photons());
        assertThat(power(aimed.photons())).isCloseTo(expected, within(0.01 * expected));
        ForwardPass owned = Forward.run(scene, PHYSICAL, "own-map", 200_000);
        assertThat(power(owned.photons())).isCloseTo(expected, within(0.01 * expected));
    }

    @ParameterizedTest
    @MethodSource("preProcessors")
    void run_givenAnyNumberOfThreads_storesTheSamePhotonsInTheSameOrder(String preProcessor) {
        ForwardPlan plan = Forward.plan(
                Forward.ballsOverFloor(new PointLight(new Vector3(0, 7, 0), Color.WHITE)),
                PHYSICAL,
                preProcessor,
                30_000);
        PhotonStore one = new ForwardPass(plan, 0, new Workers(1)).run().photons();
        PhotonStore five = new ForwardPass(plan, 0, new Workers(5)).run().photons();
        assertThat(five.size()).isEqualTo(one.size()).isPositive();
        assertThat(bits(five)).isEqualTo(bits(one));
        assertThat(bits(new ForwardPass(plan, 1, new Workers(2)).run().photons()))
                .isNotEqualTo(bits(one));
    }

    private static long bits(PhotonStore photons) {
        SurfacePoint at = new SurfacePoint();
        Rgb power = new Rgb();
        long hash = 0;
        for (int i = 0; i < photons.size(); i++) {
            photons.position(i, at);
            photons.power(i, power);
            for (double value : new double[] {at.x, at.y, at.z, at.normalX, power.red, power.blue, at.object}) {
                hash = 31 * hash + Double.doubleToLongBits(value);
            }
        }
        return hash;
    }

    /** Lengths times 2^k: the same photons at places times 2^k, with the same power from a light of nature's falloff. */
    @ParameterizedTest
    @ValueSource(ints = {-20, 20, 30})
    void run_givenScaledScene_storesTheScaledPhotons(int exponent) {
        double scale = Math.scalb(1.0, exponent);
        for (String preProcessor : preProcessors()) {
            PhotonStore small =
                    Forward.run(glass(1), PHYSICAL, preProcessor, 5000).photons();
            PhotonStore large =
                    Forward.run(glass(scale), PHYSICAL, preProcessor, 5000).photons();
            assertThat(large.size()).isEqualTo(small.size());
            SurfacePoint a = new SurfacePoint();
            SurfacePoint b = new SurfacePoint();
            Rgb p = new Rgb();
            Rgb q = new Rgb();
            for (int i = 0; i < small.size(); i++) {
                small.position(i, a);
                large.position(i, b);
                small.power(i, p);
                large.power(i, q);
                assertThat(b.x).isEqualTo(a.x * scale);
                assertThat(q.green).isEqualTo(p.green);
            }
        }
    }

    private static Scene glass(double scale) {
        return Scene.builder()
                .camera(Forward.camera())
                .light(new PointLight(new Vector3(0.1, 7, 0.2).times(scale), Color.WHITE))
                .object("floor", Forward.square(0, 5 * scale), Forward.MATT)
                .object("glass", new Sphere(new Vector3(0, 1.5, 0).times(scale), scale), Forward.clear(1.5, 1))
                .build();
    }

    @Test
    void plan_givenPlanarAndLightInside_isRefusedInASentence() {
        Scene scene = Forward.ballsOverFloor(new PointLight(new Vector3(0, 1.5, 0), Color.WHITE));
        assertThatThrownBy(() -> Forward.plan(scene, PHYSICAL, "planar", 100))
                .isInstanceOf(ForwardPlanException.class)
                .hasMessage(
                        "preprocessor 'planar' cannot serve light 1, because the light lies in the bounds of 'glass',"
                                + " or close to them; take cube, adaptive, random or monte-carlo");
    }

    /** The sun is under the horizon: the endless ground keeps its light from the ball high above. */
    @ParameterizedTest
    @ValueSource(strings = {"random", "planar", "own-map"})
    void run_givenParallelLightBehindEndlessGround_bringsNothing(String preProcessor) {
        ForwardPass night = Forward.run(highBall(new Vector3(0.2, 1, 0)), PHYSICAL, preProcessor, 2000);
        assertThat(night.ledger().emitted()).isZero();
        assertThat(night.photons().size()).isZero();
        ForwardPass day = Forward.run(highBall(new Vector3(0.2, -1, 0)), PHYSICAL, preProcessor, 2000);
        assertThat(day.photons().size()).isPositive();
    }

    private static Scene highBall(Vector3 direction) {
        return Scene.builder()
                .camera(Forward.camera())
                .light(new DirectionalLight(direction, Color.WHITE, 0))
                .object("ground", new Plane(Vector3.ZERO, Vector3.UNIT_Y), Forward.MATT)
                .object("glass", new Sphere(new Vector3(0, 20, 0), 1), Forward.clear(1.5, 1))
                .build();
    }

    /** Rays that the lamp sends nothing along, and red light through green glass: photons without power. */
    @Test
    void run_givenNoPower_storesNoPhoton() {
        Light spot = new SpotLight(new Vector3(0, 7, 0), new Vector3(0, -1, 0), 1, 1, new Color(1, 0, 0), NATURE, 0);
        PhotonStore photons = Forward.run(Forward.ballsOverFloor(spot), PHYSICAL, "cube", 20_000)
                .photons();
        Rgb power = new Rgb();
        for (int i = 0; i < photons.size(); i++) {
            photons.power(i, power);
            assertThat(power.red).isPositive();
        }
        assertThat(photons.size()).isPositive();
        Material green = Material.builder().transparency(new Color(0, 1, 0)).build();
        Scene scene = Scene.builder()
                .camera(Forward.camera())
                .light(new PointLight(new Vector3(0, 7, 0), new Color(1, 0, 0)))
                .object("floor", new Plane(Vector3.ZERO, Vector3.UNIT_Y), Forward.MATT)
                .object("pane", Forward.square(2, 1), green)
                .build();
        assertThat(Forward.run(scene, PHYSICAL, "cube", 1000).photons().size()).isZero();
    }

    /** The middle of the lamp is above the ball's box, its lower edge in it: what it sends is there from every point. */
    @Test
    void run_givenPlanarAndLampThatReachesIntoTheWindow_sendsAllItsLight() {
        Scene scene = Forward.ballsOverFloor(
                FlatLight.disc(new Vector3(1.25, 3, 0.9), new Vector3(-1, 0.2, 0), 1.5, Color.WHITE, NATURE, 256));
        double expected = power(Forward.run(scene, PHYSICAL, "cube", 100_000).photons());
        double planar = power(Forward.run(scene, PHYSICAL, "planar", 100_000).photons());
        assertThat(planar).isCloseTo(expected, within(0.03 * expected));
    }

    /** A plane before what has bounds would leave out the light that goes to the sea beside it. */
    @Test
    void plan_givenPlanarAtTheWholeSceneAndEndlessWater_isRefusedInASentence() {
        Scene scene = Scene.builder()
                .camera(Forward.camera())
                .light(new PointLight(new Vector3(0, 7, 0), Color.WHITE))
                .object("sea", new Plane(new Vector3(0, 1, 0), Vector3.UNIT_Y), Forward.clear(1.33, 1))
                .object("floor", Forward.square(0, 1), Forward.MATT)
                .build();
        assertThatThrownBy(() -> Forward.plan(scene, Forward.settings(s -> s.aimAtSpecular(false)), "planar", 100))
                .isInstanceOf(ForwardPlanException.class)
                .hasMessageContaining("'sea' has no bounds");
    }

    @Test
    void plan_givenParallelLightAndEndlessWater_isRefusedInASentence() {
        Scene scene = Scene.builder()
                .camera(Forward.camera())
                .light(new DirectionalLight(new Vector3(0, -1, 0), Color.WHITE, 0))
                .object("sea", new Plane(Vector3.ZERO, Vector3.UNIT_Y), Forward.clear(1.33, 1))
                .build();
        assertThatThrownBy(() -> Forward.plan(scene, PHYSICAL, "cube", 100))
                .isInstanceOf(ForwardPlanException.class)
                .hasMessageContaining("'sea' has no bounds");
        assertThatThrownBy(() -> Forward.plan(scene, Forward.settings(s -> s.aimAtSpecular(false)), "cube", 100))
                .isInstanceOf(ForwardPlanException.class)
                .hasMessageContaining("'sea' has no bounds");
    }

    @Test
    void plan_givenInitialHitsAndEndlessWater_isRefusedInASentence() {
        Scene scene = Scene.builder()
                .camera(Forward.camera())
                .light(new PointLight(new Vector3(0, 7, 0), Color.WHITE))
                .object("sea", new Plane(Vector3.ZERO, Vector3.UNIT_Y), Forward.clear(1.33, 1))
                .build();
        Settings settings = PHYSICAL.toBuilder()
                .maps(PHYSICAL.maps().toBuilder().initialHits(1).build())
                .build();
        assertThatThrownBy(() -> Forward.plan(scene, settings, "cube", 100))
                .isInstanceOf(ForwardPlanException.class)
                .hasMessageContaining("'sea' has no end");
    }

    /** A mirror throws the lamp's light onto a wall; with mirrored light left out nothing arrives. */
    @Test
    void run_givenMirror_storesMirroredLightIfItIsWanted() {
        Material mirror = Material.builder().reflectivity(Color.WHITE).build();
        Scene scene = Scene.builder()
                .camera(Forward.camera())
                .light(new PointLight(new Vector3(0, 5, 0), Color.WHITE))
                .object("mirror", Forward.square(0, 1), mirror)
                .object("ceiling", new Plane(new Vector3(0, 8, 0), new Vector3(0, -1, 0)), Forward.MATT)
                .build();
        ForwardPass pass = Forward.run(scene, PHYSICAL, "planar", 10_000);
        // The solid angle of a square of half side 1 at distance 5: 4 asin(1 / 26).
        assertThat(power(pass.photons())).isCloseTo(4 * Math.asin(1 / 26.0), within(1e-6));
        assertThat(pass.ledger().stored() / pass.ledger().emitted()).isCloseTo(1, within(1e-12));
        Settings refracted = Forward.settings(s -> s.followReflections(false));
        assertThat(Forward.run(scene, refracted, "planar", 10_000).photons().size())
                .isZero();
    }
}
