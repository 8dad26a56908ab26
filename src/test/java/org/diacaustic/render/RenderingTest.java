package org.diacaustic.render;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.diacaustic.light.Falloff;
import org.diacaustic.math.Color;
import org.diacaustic.math.Vector3;
import org.diacaustic.scene.Camera;
import org.diacaustic.scene.ForwardSettings;
import org.diacaustic.scene.Scene;
import org.diacaustic.scene.Settings;
import org.junit.jupiter.api.Test;

class RenderingTest {
    /** A forward pass of enough rays to light every shape. */
    private static final Settings FEW_RAYS = Settings.physical().toBuilder()
            .forward(ForwardSettings.builder().rays(20_000).build())
            .build();

    private static final Settings FOUR_SAMPLES = FEW_RAYS.toBuilder().samples(4).build();

    @Test
    void render_givenAnyNumberOfThreads_givesTheSameBitsAndCounts() {
        RenderPlan plan = RenderPlan.of(new Showcase(1).sceneWithAreas().build(), FOUR_SAMPLES);
        Rendering one = render(plan, 1);
        assertThat(one.isComplete()).isTrue();
        assertThat(one.counters().eyeRays()).isEqualTo(40 * 30 * 4);
        assertThat(one.counters().refractionRays()).isPositive();
        assertThat(one.nonFiniteReport()).isEmpty();
        for (int threads : new int[] {2, 5, 1000}) {
            Rendering other = render(plan, threads);
            assertThat(other.image().samples()).isEqualTo(one.image().samples());
            assertThat(counts(other)).isEqualTo(counts(one));
        }
    }

    @Test
    void render_givenAnotherSeed_givesAnotherPictureEachTimeTheSame() {
        Scene scene = new Showcase(1).sceneWithAreas().build();
        List<float[]> pictures = new ArrayList<>();
        for (long seed : new long[] {1, 0, -1}) {
            Settings settings = FOUR_SAMPLES.toBuilder().seed(seed).build();
            float[] picture = Renderer.render(scene, settings).image().samples();
            assertThat(Renderer.render(scene, settings).image().samples()).isEqualTo(picture);
            pictures.forEach(other -> assertThat(picture).isNotEqualTo(other));
            pictures.add(picture);
        }
    }

    @Test
    void render_givenEveryLengthTimesAPowerOfTwo_givesTheSameBits() {
        float[] unscaled = picture(1, new Falloff.None());
        assertThat(unscaled).contains(0.3f).isNotEqualTo(new float[unscaled.length]);
        for (double k : new double[] {0x1p20, 0x1p-20}) {
            assertThat(picture(k, new Falloff.None())).isEqualTo(unscaled);
        }
    }

    @Test
    void render_givenPolynomialFalloffScaledAlong_givesTheSameBits() {
        float[] unscaled = picture(1, new Falloff.Polynomial(1, 0.2, 0.03));
        for (double k : new double[] {0x1p20, 0x1p-20}) {
            assertThat(picture(k, new Falloff.Polynomial(1, 0.2 / k, 0.03 / (k * k))))
                    .isEqualTo(unscaled);
        }
    }

    @Test
    void render_givenInverseSquare_dimsByExactlyTheSquareOfTheScale() {
        // Only what the lights send is dimmed, so the background must be dark.
        float[] unscaled = dark(1);
        for (int k : new int[] {20, -20}) {
            float[] scaled = dark(Math.scalb(1.0, k));
            for (int i = 0; i < scaled.length; i++) {
                assertThat(scaled[i]).isEqualTo(Math.scalb(unscaled[i], -2 * k));
            }
        }
    }

    private static float[] picture(double scale, Falloff falloff) {
        return Renderer.render(new Showcase(scale).scene(falloff).build(), FEW_RAYS)
                .image()
                .samples();
    }

    private static float[] dark(double scale) {
        Scene scene = new Showcase(scale)
                .scene(new Falloff.InverseSquare())
                .background(Color.BLACK)
                .build();
        return Renderer.render(scene, FEW_RAYS).image().samples();
    }

    @Test
    void render_givenLensOfRadiusZero_givesThePinholesBits() {
        Scene.Builder scene = new Showcase(1).scene(new Falloff.None());
        Scene pinhole = scene.build();
        Scene closed = scene.camera(Camera.builder()
                        .from(pinhole.camera().from())
                        .to(new Vector3(0, 0.8, 0))
                        .fieldOfView(42)
                        .size(40, 30)
                        .lens(0, 3)
                        .build())
                .build();
        Rendering one = Renderer.render(pinhole, FOUR_SAMPLES);
        Rendering other = Renderer.render(closed, FOUR_SAMPLES);
        assertThat(other.image().samples()).isEqualTo(one.image().samples());
        assertThat(counts(other)).isEqualTo(counts(one));
    }

    @Test
    void render_givenLastBlockerShortcut_changesCountersButNoBit() {
        Scene scene = new Showcase(1).scene(new Falloff.None()).build();
        for (String shader : new String[] {"non-transparent", "non-refractive"}) {
            // Without a limit on what rays carry, list order differs in nothing but how objects are asked.
            Settings.Builder settings =
                    FEW_RAYS.toBuilder().shader(shader).minimumThroughput(0).maxDepth(5);
            Rendering shortcut = Renderer.render(scene, settings.build());
            Rendering listed = Renderer.render(scene, settings.listOrder(true).build());
            assertThat(shortcut.image().samples()).isEqualTo(listed.image().samples());
            assertThat(shortcut.counters().intersectionTests())
                    .isLessThan(listed.counters().intersectionTests());
        }
    }

    @Test
    void render_givenOpaqueScene_costsTheSameWithEitherShader() {
        Scene scene = opaque();
        for (Settings settings : new Settings[] {FEW_RAYS, Settings.thesis()}) {
            Rendering blocking = Renderer.render(
                    scene, settings.toBuilder().shader("non-transparent").build());
            Rendering filtering = Renderer.render(
                    scene, settings.toBuilder().shader("non-refractive").build());
            assertThat(filtering.image().samples()).isEqualTo(blocking.image().samples());
            assertThat(counts(filtering)).isEqualTo(counts(blocking));
            assertThat(blocking.counters().shadowRays()).isPositive();
        }
    }

    private static Scene opaque() {
        Scene all = new Showcase(1).scene(new Falloff.None()).build();
        Scene.Builder opaque = Scene.builder().camera(all.camera());
        all.lights().forEach(opaque::light);
        all.objects().stream().filter(object -> object.isOpaque()).forEach(opaque::object);
        return opaque.build();
    }

    private static Rendering render(RenderPlan plan, int threads) {
        return new RenderJob(plan, threads, (done, total) -> {}).run();
    }

    private static List<Long> counts(Rendering rendering) {
        Counters counters = rendering.counters();
        return List.of(
                counters.eyeRays(),
                counters.shadowRays(),
                counters.reflectionRays(),
                counters.refractionRays(),
                counters.intersectionTests());
    }
}
