package org.diacaustic.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.diacaustic.render.Eye.clear;
import static org.diacaustic.render.Eye.matt;
import static org.diacaustic.render.Eye.mirror;
import static org.diacaustic.render.Eye.v;

import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.UnaryOperator;
import org.diacaustic.image.LinearImage;
import org.diacaustic.light.Light;
import org.diacaustic.light.LightSample;
import org.diacaustic.light.PointLight;
import org.diacaustic.material.Material;
import org.diacaustic.math.Color;
import org.diacaustic.scene.Camera;
import org.diacaustic.scene.EstimatorName;
import org.diacaustic.scene.ForwardSettings;
import org.diacaustic.scene.MapName;
import org.diacaustic.scene.MapSettings;
import org.diacaustic.scene.Scene;
import org.diacaustic.scene.Settings;
import org.diacaustic.scene.Weights;
import org.diacaustic.shape.FlakeKind;
import org.diacaustic.shape.Plane;
import org.diacaustic.shape.Sphere;
import org.diacaustic.shape.Sphereflake;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class ForwardChoiceTest {
    private static final Settings PHYSICAL = Settings.physical();

    private static Scene.Builder overFloor(Material.Builder material) {
        return Scene.builder()
                .camera(Camera.builder()
                        .from(v(0, 4, -6))
                        .to(v(0, 0, 0))
                        .size(24, 24)
                        .build())
                .object("floor", new Plane(v(0, 0, 0), v(0, 1, 0)), matt(0.8).build())
                .object("ball", new Sphere(v(0, 1.5, 0), 1), material.build());
    }

    private static Scene lit(Material.Builder material) {
        return overFloor(material)
                .light(new PointLight(v(0, 7, 0), Color.WHITE))
                .build();
    }

    private static Settings forward(UnaryOperator<ForwardSettings.Builder> change) {
        return PHYSICAL.toBuilder()
                .forward(change.apply(ForwardSettings.builder().rays(3000)).build())
                .build();
    }

    private static Settings maps(UnaryOperator<MapSettings.Builder> change) {
        return forward(forward -> forward).toBuilder()
                .maps(change.apply(MapSettings.builder()).build())
                .build();
    }

    private static Decision decision(RenderPlan plan, String part) {
        return plan.decisions().stream()
                .filter(decision -> decision.part().equals(part))
                .findFirst()
                .orElseThrow();
    }

    private static void assertLeftOut(Scene scene, Settings settings, String reason) {
        RenderPlan plan = RenderPlan.of(scene, settings);
        assertThat(plan.forward()).isEmpty();
        assertThat(decision(plan, "forward pass").used()).isFalse();
        assertThat(decision(plan, "forward pass").reason()).contains(reason);
        Rendering rendering = new RenderJob(plan).run();
        assertThat(rendering.forward().counters().lightRays()).isZero();
        assertThat(rendering.forward().mapBytes()).isZero();
        assertThat(rendering.counters().nodesExamined()).isZero();
    }

    @Test
    void plan_givenNothingSpecular_leavesTheForwardPassOut() {
        assertLeftOut(lit(matt(1)), PHYSICAL, "nothing refracts or mirrors");
        assertLeftOut(lit(matt(1)), forward(s -> s.preProcessor("cube")), "nothing refracts or mirrors");
    }

    @Test
    void plan_givenClearObjectsThatDoNotBend_takesStraightShadowRays() {
        assertLeftOut(lit(clear(1)), PHYSICAL, "straight shadow rays are exact");
        assertThat(RenderPlan.of(lit(clear(1)), PHYSICAL).shader().name()).isEqualTo("non-refractive");
    }

    /** A pixel is 0.03 wide here, so a step of 0.03 ÷ 100 ÷ 640 = 4.7e-7 is the largest that cannot be seen. */
    @Test
    void plan_givenClearObjectsThatBendByLessThanIsSeen_takesStraightShadowRays() {
        assertLeftOut(lit(clear(1 + 1e-9)), PHYSICAL, "less than a hundredth of a pixel");
        assertThat(RenderPlan.of(lit(clear(1 + 1e-9)), forward(s -> s.preProcessor("own-map")))
                        .forward())
                .isPresent();
        assertThat(RenderPlan.of(lit(clear(1 + 1e-6)), PHYSICAL).forward()).isPresent();
        assertThat(RenderPlan.of(lit(clear(1 + 1e-9)), PHYSICAL).isStraight()).isFalse();
    }

    @Test
    void plan_givenNothingDiffuse_leavesTheForwardPassOut() {
        Scene scene = Scene.builder()
                .camera(Camera.builder()
                        .from(v(0, 4, -6))
                        .to(v(0, 0, 0))
                        .size(24, 24)
                        .build())
                .light(new PointLight(v(0, 7, 0), Color.WHITE))
                .object("ball", new Sphere(v(0, 1.5, 0), 1), clear(1.5).build())
                .build();
        assertLeftOut(scene, PHYSICAL, "nothing is diffuse, so light that lands cannot be seen");
    }

    /** Light that initial hits discard would be missing from every estimate but that of the thesis. */
    @Test
    void plan_givenInitialHitsAndWeightedEstimator_isRefused() {
        assertThatThrownBy(() -> RenderPlan.of(lit(clear(1.5)), maps(maps -> maps.initialHits(1))))
                .isInstanceOf(PlanException.class)
                .hasMessageContaining("initial-hits");
    }

    @Test
    void plan_givenPassesAndNoForwardPass_saysThatOneIsEnough() {
        RenderPlan plan = RenderPlan.of(lit(matt(0.5)), forward(forward -> forward.passes(5)));
        assertThat(plan.passes()).isEqualTo(1);
        assertThat(plan.decisions()).anyMatch(decision -> decision.part().equals("passes") && !decision.used());
    }

    /** 65,536 passes over 24 × 24 pixels, of 2 × 2 tiles and some thousand light rays each, are counted without overflow. */
    @Test
    void run_givenVeryManyPasses_reportsAPositiveTotal() {
        RenderPlan plan = RenderPlan.of(
                lit(clear(1.5)), forward(forward -> forward.passes(65_536).rays(10_000_000)));
        AtomicInteger total = new AtomicInteger();
        RenderJob[] job = new RenderJob[1];
        job[0] = new RenderJob(plan, 1, (done, of) -> {
            total.set(of);
            job[0].cancel();
        });
        job[0].run();
        assertThat(total.get()).isPositive();
    }

    @Test
    void plan_givenNoLight_leavesTheForwardPassOut() {
        assertLeftOut(overFloor(clear(1.5)).build(), PHYSICAL, "there is no light");
        Light glow = (x, y, z, s, t, sample) -> false;
        assertLeftOut(overFloor(clear(1.5)).light(glow).build(), PHYSICAL, "no light sends out light rays");
    }

    @Test
    void plan_givenShaderByName_addsNoMapUnasked() {
        assertLeftOut(
                lit(clear(1.5)), PHYSICAL.toBuilder().shader("non-transparent").build(), "by name");
    }

    @Test
    void plan_givenGlassOrMirror_takesCells() {
        for (Material.Builder material : new Material.Builder[] {clear(1.5), mirror(0.5)}) {
            RenderPlan plan = RenderPlan.of(lit(material), PHYSICAL);
            assertThat(plan.shader().name()).isEqualTo("non-transparent");
            assertThat(decision(plan, "preprocessor").choice()).startsWith("own-map, 262144");
            assertThat(decision(plan, "emission windows").choice()).startsWith("'ball': 262144 rays");
            assertThat(decision(plan, "map").choice()).isEqualTo("caustic-mesh");
            assertThat(plan.estimatesError()).isTrue();
        }
    }

    @Test
    void plan_givenWhatNeedsPhotons_takesPhotons() {
        Scene scene = lit(clear(1.5));
        Settings estimator = maps(s -> s.estimator(EstimatorName.DENSITY));
        assertThat(decision(RenderPlan.of(scene, estimator), "map"))
                .hasToString("uses  map: photon-map, density (an estimator of photons is asked for)");
        Settings random = forward(s -> s.preProcessor("random"));
        assertThat(decision(RenderPlan.of(scene, random), "map").choice()).isEqualTo("photon-map, nearest");
        assertThat(decision(RenderPlan.of(scene, random), "map").reason())
                .contains("'random' sends no neighbouring rays");
    }

    /** A fractal of glass sends every ray of a cell another way, however small the cell is. */
    @Test
    void plan_givenLightTornApart_handsOverToPhotons() {
        Scene scene = Scene.builder()
                .camera(Camera.builder().from(v(0, 4, -6)).to(v(0, 0, 0)).build())
                .object("floor", new Plane(v(0, 0, 0), v(0, 1, 0)), matt(0.8).build())
                .object(
                        "flake",
                        new Sphereflake(FlakeKind.CLASSIC, 4, v(0, 2, 0), 0.5),
                        clear(1.5).build())
                .light(new PointLight(v(1, 6, 0), Color.WHITE))
                .build();
        Decision map = decision(RenderPlan.of(scene, PHYSICAL), "map");
        assertThat(map.choice()).isEqualTo("photon-map, nearest");
        assertThat(map.reason()).contains("% of the light is torn apart too finely for cells");
        assertThat(decision(RenderPlan.of(scene, PHYSICAL), "preprocessor").choice())
                .startsWith("planar, 524288");
    }

    @Test
    void plan_givenCellsAndWhatHasNone_isRefused() {
        for (String name : new String[] {"random", "monte-carlo"}) {
            assertRefused(
                    forward(s -> s.preProcessor(name)), MapName.CAUSTIC_MESH, "'" + name + "'", "no neighbouring rays");
        }
        assertRefused(
                maps(s -> s.map(MapName.CAUSTIC_MESH).estimator(EstimatorName.NEAREST)), "'nearest'", "'caustic-mesh'");
    }

    @Test
    void plan_givenPhotonsAndLightAmongObjects_takesTheCube() {
        Scene lamp = overFloor(clear(1.5))
                .light(new PointLight(v(0, 1.5, 0), Color.WHITE))
                .build();
        assertThat(decision(RenderPlan.of(lamp, maps(s -> s.map(MapName.PHOTON_MAP))), "preprocessor")
                        .choice())
                .startsWith("cube");
    }

    @ParameterizedTest
    @EnumSource(names = {"AMBIENT_MAPS", "PHOTON_MAP", "CAUSTIC_MESH"})
    void plan_givenMapAndLightThatGoesStraight_isRefused(MapName map) {
        Settings settings =
                maps(s -> s.map(map)).toBuilder().shader("non-refractive").build();
        assertThatThrownBy(() -> RenderPlan.of(lit(clear(1.5)), settings))
                .isInstanceOf(PlanException.class)
                .hasMessageContaining("shader 'non-refractive'")
                .hasMessageContaining("map '" + map.label() + "'");
    }

    @Test
    void plan_givenContradictions_namesBothSides() {
        assertRefused(forward(s -> s.preProcessor("cubes")), "unknown preprocessor 'cubes'", "monte-carlo");
        assertRefused(forward(s -> s.preProcessor("none")), MapName.PHOTON_MAP, "map 'photon-map'", "'none'");
        assertRefused(forward(s -> s.preProcessor("cube")), MapName.NONE, "preprocessor 'cube'", "'none'");
        assertRefused(
                maps(s -> s.map(MapName.AMBIENT_MAPS).estimator(EstimatorName.NEAREST)), "'nearest'", "ambient-maps");
        assertRefused(forward(s -> s.weights(Weights.NONE)), "light-weights 'none'", "expected-count");
        Settings counted = maps(s -> s.estimator(EstimatorName.EXPECTED_COUNT)).toBuilder()
                .forward(ForwardSettings.builder().weights(Weights.SOLID_ANGLE).build())
                .build();
        assertRefused(counted, "expected-count", "solid-angle");
    }

    private static void assertRefused(Settings settings, MapName map, String... words) {
        assertRefused(
                settings.toBuilder()
                        .maps(MapSettings.builder().map(map).build())
                        .build(),
                words);
    }

    private static void assertRefused(Settings settings, String... words) {
        assertThatThrownBy(() -> RenderPlan.of(lit(clear(1.5)), settings))
                .isInstanceOf(PlanException.class)
                .hasMessageContainingAll(words);
    }

    @Test
    void plan_givenMirrorsThatAreNotFollowed_saysWhatIsLeftOut() {
        Scene scene = Scene.builder()
                .camera(lit(clear(1.5)).camera())
                .light(new PointLight(v(0, 7, 0), Color.WHITE))
                .object("floor", new Plane(v(0, 0, 0), v(0, 1, 0)), matt(0.8).build())
                .object("ball", new Sphere(v(0, 1.5, 0), 1), clear(1.5).build())
                .object("knob", new Sphere(v(3, 1.5, 0), 1), mirror(0.5).build())
                .build();
        Settings settings = forward(s -> s.followReflections(false).passes(3));
        RenderPlan plan = RenderPlan.of(scene, settings);
        assertThat(decision(plan, "mirrored light"))
                .isEqualTo(new Decision(
                        "mirrored light", false, "what knob mirrors onto surfaces", "light-reflections is off"));
        assertThat(decision(plan, "passes").choice()).isEqualTo("3 pictures, averaged");
        assertThat(decision(plan, "emission windows").choice()).doesNotContain("knob");
        assertThat(RenderPlan.of(scene, PHYSICAL).decisions())
                .noneMatch(d -> d.part().equals("mirrored light"));
    }

    /** The thesis: an endless plane cannot have a map of its own [Thesis 4.4]. */
    @Test
    void plan_givenAmbientMapsAndEndlessFloor_isRefusedInASentence() {
        assertRefused(maps(s -> s.map(MapName.AMBIENT_MAPS)), "'floor'", "photon-map");
    }

    @Test
    void run_givenPasses_averagesThemAlikeForAnyNumberOfThreads() {
        Settings one = maps(s -> s.estimator(EstimatorName.PROGRESSIVE));
        Settings three = one.toBuilder()
                .forward(one.forward().toBuilder().passes(3).build())
                .build();
        LinearImage first = picture(one, 2);
        LinearImage mean = picture(three, 1);
        assertThat(picture(three, 5).samples()).isEqualTo(mean.samples());
        assertThat(mean.samples()).isNotEqualTo(first.samples());
        assertThat(noise(mean)).isLessThan(noise(first));
    }

    private static LinearImage picture(Settings settings, int threads) {
        return new RenderJob(RenderPlan.of(lit(clear(1.5)), settings), threads, (done, total) -> {})
                .run()
                .image();
    }

    /** How much neighbouring pixels differ. */
    private static double noise(LinearImage image) {
        double sum = 0;
        for (int i = 3; i < image.samples().length; i++) {
            sum += Math.abs(image.samples()[i] - image.samples()[i - 3]);
        }
        return sum;
    }

    @Test
    void run_givenForwardPass_reportsEveryPartOnce() {
        int[] last = new int[2];
        Settings settings = forward(s -> s.passes(2));
        new RenderJob(RenderPlan.of(lit(clear(1.5)), settings), 2, (done, total) -> {
                    assertThat(done).isEqualTo(last[0] + 1);
                    last[0] = done;
                    last[1] = total;
                })
                .run();
        // 24 × 24 pixels are 4 tiles; 3000 light rays are as much work as 21 tiles of 144 pixels; and all of it twice.
        assertThat(last).containsExactly(50, 50);
    }

    /** A light of one's own that knows only direct light. */
    @Test
    void plan_givenLightThatSendsNoRays_saysWhich() {
        Light glow = new Light() {
            @Override
            public boolean sample(double x, double y, double z, double s, double t, LightSample sample) {
                return false;
            }
        };
        Scene scene = overFloor(clear(1.5))
                .light(glow)
                .light(new PointLight(v(0, 7, 0), Color.WHITE))
                .build();
        assertThat(decision(RenderPlan.of(scene, PHYSICAL), "light rays").choice())
                .isEqualTo("rays of light 1");
    }
}
