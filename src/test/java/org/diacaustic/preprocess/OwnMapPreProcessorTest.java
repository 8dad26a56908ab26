package org.diacaustic.preprocess;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.diacaustic.light.DirectionalLight;
import org.diacaustic.light.Falloff;
import org.diacaustic.light.Light;
import org.diacaustic.light.PointLight;
import org.diacaustic.light.SphereLight;
import org.diacaustic.material.Material;
import org.diacaustic.math.Color;
import org.diacaustic.math.Vector3;
import org.diacaustic.parallel.Workers;
import org.diacaustic.scene.EstimatorName;
import org.diacaustic.scene.MapName;
import org.diacaustic.scene.Scene;
import org.diacaustic.scene.SceneIndex;
import org.diacaustic.scene.Settings;
import org.diacaustic.shape.Box;
import org.diacaustic.shape.ConvexPolygon;
import org.diacaustic.shape.Disc;
import org.diacaustic.shape.Ellipsoid;
import org.diacaustic.shape.Frustum;
import org.diacaustic.shape.MeshData;
import org.diacaustic.shape.Plane;
import org.diacaustic.shape.Shape;
import org.diacaustic.shape.Sphere;
import org.diacaustic.shape.Torus;
import org.diacaustic.shape.TriangleMesh;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * What is sent at an object is what the light sees of it: with an intensity of 1 its solid angle, with parallel light of
 * irradiance 1 its silhouette's area. Lattices miss that by a few thousandths at most; a place that is lit twice, or not
 * at all, by far more.
 */
class OwnMapPreProcessorTest {
    private static final Settings PHYSICAL = Settings.physical();
    private static final Material MIRROR =
            Material.builder().reflectivity(Color.WHITE).build();
    private static final Light SUN = new DirectionalLight(new Vector3(0, -1, 0), Color.WHITE, 0);
    private static final Light LOW_SUN = new DirectionalLight(new Vector3(1, -1, 0), Color.WHITE, 0);

    private static Light lamp(double x, double y, double z) {
        return new PointLight(new Vector3(x, y, z), Color.WHITE);
    }

    private static Scene.Builder scene(Light light) {
        return Scene.builder().camera(Forward.camera()).light(light);
    }

    /** Of one colour of three. */
    private static double sentOut(Scene scene) {
        return Forward.run(scene, PHYSICAL, "own-map", 20_000).ledger().emitted() / 3;
    }

    private static double sentOut(Light light, Shape shape) {
        return sentOut(scene(light).object("it", shape, MIRROR).build());
    }

    /** The cap that the tangents enclose, 2π (1 − √(1 − R²/d²)), from afar and from close by. */
    @ParameterizedTest
    @CsvSource({"5, 0.001", "1.1, 0.005"})
    void run_givenBall_sendsItsSolidAngle(double distance, double error) {
        double expected = 2 * Math.PI * (1 - Math.sqrt(1 - 1 / (distance * distance)));
        assertThat(sentOut(lamp(0, distance, 0), new Sphere(Vector3.ZERO, 1)))
                .isCloseTo(expected, within(error * expected));
    }

    /** Whatever is around a lamp takes all of its 4π. */
    @Test
    void run_givenLampInside_sendsAllDirections() {
        Shape ball = new Sphere(Vector3.ZERO, 1);
        assertThat(sentOut(lamp(0.1, 0.4, 0), ball)).isCloseTo(4 * Math.PI, within(0.01));
        Shape box = new Box(new Vector3(-2, -1, -1), new Vector3(2, 1, 1));
        assertThat(sentOut(lamp(1, 0.3, -0.2), box)).isCloseTo(4 * Math.PI, within(0.05));
        Shape ellipsoid = new Ellipsoid(new Vector3(1, 0, 0), new Vector3(3, 0.8, 1));
        assertThat(sentOut(lamp(0, 0.1, 0), ellipsoid)).isCloseTo(4 * Math.PI, within(0.05));
    }

    /** Seen from above its middle, a box is its top: 4 atan(ab ÷ (d √(a² + b² + d²))). A flat one's middle sees that at a graze. */
    @ParameterizedTest
    @CsvSource({"1, 1", "3, 0.1"})
    void run_givenBox_sendsTheSolidAngleOfItsTop(double half, double top) {
        double d = 5 - top;
        double expected = 4 * Math.atan(half * half / (d * Math.sqrt(2 * half * half + d * d)));
        Shape box = new Box(new Vector3(-half, -top, -half), new Vector3(half, top, half));
        assertThat(sentOut(lamp(0, 5, 0), box)).isCloseTo(expected, within(0.003 * expected));
    }

    /** The tangents from height d to a spheroid, a wide and c high, meet its axis at tan² = a² ÷ (d² − c²): 4 ÷ 24.75. */
    @Test
    void run_givenEllipsoid_sendsItsSolidAngle() {
        double expected = 2 * Math.PI * (1 - 1 / Math.sqrt(1 + 4 / 24.75));
        Shape ellipsoid = new Ellipsoid(Vector3.ZERO, new Vector3(2, 0.5, 2));
        assertThat(sentOut(lamp(0, 5, 0), ellipsoid)).isCloseTo(expected, within(0.001 * expected));
    }

    @Test
    void run_givenFlatShapes_sendsTheirSilhouettes() {
        // 2π (1 − 5 ÷ √26).
        assertThat(sentOut(lamp(0, 5, 0), new Disc(Vector3.ZERO, Vector3.UNIT_Y, 1)))
                .isCloseTo(2 * Math.PI * (1 - 5 / Math.sqrt(26)), within(2e-4));
        Shape triangle = ConvexPolygon.twoSided(new Vector3(-2, 0, -2), new Vector3(-2, 0, 2), new Vector3(2, 0, 2));
        assertThat(sentOut(SUN, triangle)).isCloseTo(8, within(0.01));
        assertThat(sentOut(LOW_SUN, triangle)).isCloseTo(8 * Math.sqrt(0.5), within(0.01));
    }

    /** Lines from its middle graze a torus in two rings; its silhouette along the axis is a ring of area 4πRr. */
    @Test
    void run_givenTorus_losesNothingWhereLinesGraze() {
        double expected = 4 * Math.PI * 2 * 0.5;
        assertThat(sentOut(SUN, new Torus(Vector3.ZERO, Vector3.UNIT_Y, 2, 0.5)))
                .isCloseTo(expected, within(0.003 * expected));
    }

    /** An open pipe, 2 wide and 3 long, seen at 45° to its axis: its side and one opening, 6√½ + π√½. */
    @Test
    void run_givenOpenPipe_sendsItsInsideAndItsOutside() {
        Shape pipe = Frustum.cylinder(new Vector3(-1.5, 0, 0), new Vector3(1.5, 0, 0), 1, false);
        double expected = (6 + Math.PI) * Math.sqrt(0.5);
        assertThat(sentOut(LOW_SUN, pipe)).isCloseTo(expected, within(0.005 * expected));
    }

    /**
     * A tray, 2 × 2 with walls 0.1 high, is flat enough for a map from above, whose lines run along its walls. At 45° it is the
     * floor and one wall: 2 (2 + 0.1) √½.
     */
    @Test
    void run_givenTrayWithSteepWalls_sendsThemTheirPart() {
        double[] corners = {-1, 0, -1, 1, 0, -1, 1, 0, 1, -1, 0, 1, -1, 0.1, -1, 1, 0.1, -1, 1, 0.1, 1, -1, 0.1, 1};
        int[] triangles = {0, 2, 1, 0, 3, 2, 0, 1, 5, 0, 5, 4, 1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4, 7};
        Shape tray = new TriangleMesh(new MeshData(corners, triangles, null, null), false);
        double expected = 4.2 * Math.sqrt(0.5);
        assertThat(sentOut(LOW_SUN, tray)).isCloseTo(expected, within(0.003 * expected));
    }

    /** A small ball before a large one, and a stone that hides half of both: what is sent is half of the large one. */
    @Test
    void run_givenObjectsThatHideEachOther_sendsNothingTwice() {
        Scene.Builder balls = scene(SUN)
                .object("large", new Sphere(Vector3.ZERO, 1), MIRROR)
                .object("small", new Sphere(new Vector3(0, 3, 0), 0.5), Forward.clear(1.5, 1));
        assertThat(sentOut(balls.build())).isCloseTo(Math.PI, within(0.01));
        Shape half = ConvexPolygon.twoSided(
                new Vector3(0, 9, -2), new Vector3(0, 9, 2), new Vector3(4, 9, 2), new Vector3(4, 9, -2));
        assertThat(sentOut(balls.object("stone", half, Forward.MATT).build())).isCloseTo(Math.PI / 2, within(0.01));
    }

    /** Two halves of a 2 × 2 × 2 cube that touch, seen at 45°: 2 · 4 √½, the place where they touch once. */
    @Test
    void run_givenObjectsThatTouch_sendsNothingTwice() {
        Scene scene = scene(LOW_SUN)
                .object("low", new Box(new Vector3(-1, 0, -1), new Vector3(1, 1, 1)), Forward.clear(1.5, 1))
                .object("high", new Box(new Vector3(-1, 1, -1), new Vector3(1, 2, 1)), Forward.clear(1.3, 1))
                .build();
        assertThat(sentOut(scene)).isCloseTo(8 * Math.sqrt(0.5), within(0.02));
    }

    /** A ray aimed at an object counts only if it meets that first, and where it was said to. */
    @ParameterizedTest
    @CsvSource({"0, 4, 1", "0, 3.9, 0", "0, 6, 0", "1, 4, 0", "1, 8, 0"})
    void shoot_givenTarget_countsOnlyThere(int object, double distance, double expected) {
        PreProcessor one = new PreProcessor() {
            @Override
            public String name() {
                return "one";
            }

            @Override
            public void run(Beam beam, ForwardPass pass) {
                pass.shootRays(1, (i, emitter) -> {
                    emitter.point(0.5, 0.5);
                    emitter.ray().setOrigin(0, 5, 0);
                    emitter.ray().setDirection(0, -1, 0);
                    emitter.ray().measure = 1;
                    emitter.ray().aimAt(object, distance, 1e-9);
                    emitter.shoot(1);
                });
            }
        };
        Scene scene = scene(lamp(0, 5, 0))
                .object("near", new Sphere(Vector3.ZERO, 1), MIRROR)
                .object("far", new Sphere(new Vector3(0, -4, 0), 1), MIRROR)
                .build();
        SceneIndex index = SceneIndex.of(scene.objects(), false);
        ForwardPlan plan = new ForwardPlanner(scene, index, Forward.settings(s -> s.aimAtSpecular(false)))
                .plan(one, 1, MapName.PHOTON_MAP, EstimatorName.DENSITY);
        ForwardPass pass = new ForwardPass(plan, 0, new Workers(1)).run();
        assertThat(pass.ledger().emitted() / 3).isEqualTo(expected);
        assertThat(pass.counters().primaryRays()).isEqualTo(1);
    }

    /** As many rays as asked for, though a lamp sees but a part of a ball, and half of a round lamp sees nothing. */
    @Test
    void run_givenNumberOfRays_sendsAboutThat() {
        Light round = new SphereLight(new Vector3(0, 4, 0), 0.5, Color.WHITE, new Falloff.InverseSquare(), 16);
        for (Light light : new Light[] {SUN, lamp(0, 1.5, 0), round}) {
            Scene scene = scene(light)
                    .object("ball", new Sphere(Vector3.ZERO, 1), MIRROR)
                    .build();
            long rays =
                    Forward.run(scene, PHYSICAL, "own-map", 20_000).counters().primaryRays();
            assertThat(rays).isBetween(18_000L, 22_000L);
        }
    }

    private static ForwardPass controlSheet(Settings settings, String preProcessor, long rays) {
        Material sheet = Material.builder().transparency(Color.grey(0.9)).build();
        Shape diamond = ConvexPolygon.twoSided(
                new Vector3(3, 4, 0), new Vector3(0, 4, -3), new Vector3(-3, 4, 0), new Vector3(0, 4, 3));
        Scene scene = scene(lamp(0, 70, 0))
                .object("floor", new Plane(Vector3.ZERO, Vector3.UNIT_Y), Forward.MATT)
                .object("sheet", diamond, sheet)
                .build();
        return Forward.run(scene, settings, preProcessor, rays);
    }

    /** The thesis' sheet is half of the square around it, which is all that a plane before the light knows of it. */
    @Test
    void run_givenSheetAcrossTheAxes_wastesNoRay() {
        ForwardPass own = controlSheet(PHYSICAL, "own-map", 20_000);
        ForwardPass planar = controlSheet(PHYSICAL, "planar", 20_000);
        assertThat((double) own.counters().stored() / own.counters().primaryRays())
                .isEqualTo(1);
        assertThat((double) planar.counters().stored() / planar.counters().primaryRays())
                .isCloseTo(0.5, within(0.01));
        assertThat(own.ledger().stored())
                .isCloseTo(planar.ledger().stored(), within(0.01 * own.ledger().stored()));
    }

    /** In the thesis' way: 50 × 50 points, aligned with two edges on which rays may pass by, and photons all alike. */
    @Test
    void run_givenLatticeSizeWithoutWeights_sendsOneRayForEachPoint() {
        Settings settings = Settings.thesis().toBuilder()
                .forward(Settings.thesis().forward().toBuilder().latticeSize(50).build())
                .maps(Settings.thesis().maps().toBuilder().expectedCount(1).build())
                .build();
        ForwardPass pass = controlSheet(settings, "own-map", 10);
        assertThat(pass.counters().primaryRays()).isLessThanOrEqualTo(50L * 50);
        assertThat(pass.counters().stored()).isBetween(49L * 49, pass.counters().primaryRays());
    }

    @Test
    void plan_givenEndlessWater_isRefusedInASentence() {
        Scene scene = scene(lamp(0, 5, 0))
                .object("sea", new Plane(Vector3.ZERO, Vector3.UNIT_Y), Forward.clear(1.33, 1))
                .build();
        assertThatThrownBy(() -> Forward.plan(scene, PHYSICAL, "own-map", 100))
                .isInstanceOf(ForwardPlanException.class)
                .hasMessage(
                        "preprocessor 'own-map' cannot serve light 1, because 'sea' has no bounds; take cube, adaptive,"
                                + " random or monte-carlo");
    }

    /** Only what refracts or mirrors needs a map. */
    @Test
    void plan_givenEndlessFloor_isNotRefused() {
        Scene scene = scene(lamp(0, 5, 0))
                .object("floor", new Plane(Vector3.ZERO, Vector3.UNIT_Y), Forward.MATT)
                .object("ball", new Sphere(new Vector3(0, 2, 0), 1), MIRROR)
                .build();
        Settings whole = Forward.settings(s -> s.aimAtSpecular(false));
        assertThat(Forward.plan(scene, whole, "own-map", 100).beams()).hasSize(1);
    }
}
