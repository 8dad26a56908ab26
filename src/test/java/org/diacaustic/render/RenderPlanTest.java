package org.diacaustic.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowableOfType;
import static org.assertj.core.api.Assertions.within;
import static org.diacaustic.render.Eye.clear;
import static org.diacaustic.render.Eye.matt;
import static org.diacaustic.render.Eye.mirror;
import static org.diacaustic.render.Eye.v;

import java.util.List;
import org.diacaustic.light.DirectionalLight;
import org.diacaustic.light.Falloff;
import org.diacaustic.light.FlatLight;
import org.diacaustic.material.Material;
import org.diacaustic.material.Medium;
import org.diacaustic.material.Pattern;
import org.diacaustic.material.PatternTexture;
import org.diacaustic.material.Wave;
import org.diacaustic.math.Color;
import org.diacaustic.math.Rgb;
import org.diacaustic.math.Vector3;
import org.diacaustic.scene.Camera;
import org.diacaustic.scene.Scene;
import org.diacaustic.scene.Settings;
import org.diacaustic.shader.Shader;
import org.diacaustic.shader.ShadowRay;
import org.diacaustic.shape.Plane;
import org.diacaustic.shape.Sphere;
import org.junit.jupiter.api.Test;

class RenderPlanTest {
    private static final Settings PHYSICAL = Settings.physical();

    @Test
    void of_givenUnknownShader_namesItAndTheKnownOnes() {
        Settings settings = PHYSICAL.toBuilder().shader("refractive").build();
        assertThatThrownBy(() -> RenderPlan.of(scene(matt(1)).build(), settings))
                .isInstanceOf(PlanException.class)
                .hasMessageContaining("'refractive'")
                .hasMessageContaining("non-transparent")
                .hasMessageContaining("non-refractive");
    }

    @Test
    void of_givenOpaqueScene_leavesOutWhatItDoesNotNeed() {
        RenderPlan plan = RenderPlan.of(scene(matt(1)).build(), PHYSICAL);
        assertThat(plan.shader().name()).isEqualTo("non-transparent");
        assertThat(plan.decisions()).filteredOn(Decision::used).hasSize(1);
        assertDecision(plan, "shader", true, "nothing is transparent");
        for (String part : List.of(
                "top-level tree",
                "filter walk",
                "lens",
                "map coordinates",
                "bump maps",
                "absorption",
                "highlights",
                "supersampling")) {
            assertDecision(plan, part, false, "");
        }
    }

    @Test
    void of_givenTransparency_takesTheFilterAndSaysHowRightItIs() {
        RenderPlan straight = RenderPlan.of(scene(clear(1)).build(), PHYSICAL);
        assertThat(straight.shader().name()).isEqualTo("non-refractive");
        assertDecision(straight, "shader", true, "exact");
        assertDecision(straight, "filter walk", true, "transparent");
        RenderPlan bending = RenderPlan.of(scene(clear(1.5)).build(), PHYSICAL);
        assertThat(bending.shader().name()).isEqualTo("non-refractive");
        assertDecision(bending, "shader", true, "approximate: light through thing 0");
    }

    @Test
    void of_givenTraits_usesWhatTheyNeed() {
        Material.Builder all = clear(new Medium(1.5, Color.grey(1), 0))
                .diffuse(new PatternTexture(new Pattern.MapChecker(2, 2), Color.BLACK, Color.WHITE))
                .bump(new Wave(Vector3.UNIT_X, 1, 1, 0));
        Scene scene = scene(all)
                .light(new DirectionalLight(v(0, -1, 0), Color.WHITE, 10))
                .camera(Camera.builder().lens(1, 2).build())
                .build();
        RenderPlan plan = RenderPlan.of(
                scene, Eye.withoutMap(PHYSICAL.toBuilder()).samples(9).build());
        for (String part : List.of(
                "shader",
                "filter walk",
                "lens",
                "map coordinates",
                "bump maps",
                "absorption",
                "highlights",
                "supersampling")) {
            assertDecision(plan, part, true, "");
        }
        assertThat(plan.decisions().toString()).contains("9 rays a pixel");
    }

    @Test
    void of_givenManyObjects_takesATreeUnlessListOrderIsWanted() {
        Scene.Builder many = scene(matt(1));
        for (int i = 1; i < 20; i++) {
            many.object("thing " + i, new Sphere(v(3 * i, 0, 0), 1), matt(1).build());
        }
        assertDecision(RenderPlan.of(many.build(), PHYSICAL), "top-level tree", true, "20 objects");
        assertDecision(RenderPlan.of(many.build(), Settings.thesis()), "top-level tree", false, "thesis");
    }

    @Test
    void of_givenHighlightExponentButNothingThatReflects_leavesHighlightsOut() {
        DirectionalLight sun = new DirectionalLight(v(0, -1, 0), Color.WHITE, 10);
        assertDecision(RenderPlan.of(scene(matt(1)).light(sun).build(), PHYSICAL), "highlights", false, "");
        assertDecision(RenderPlan.of(scene(mirror(1)).light(sun).build(), PHYSICAL), "highlights", true, "");
    }

    @Test
    void of_givenShaderOfTheCallers_usesIt() {
        // Half of the light arrives, however many things are in between.
        Shader half = new Shader() {
            @Override
            public String name() {
                return "half";
            }

            @Override
            public boolean transmit(ShadowRay shadow, Rgb transmittance) {
                boolean blocked = shadow.visit(
                        (object, ray) -> shadow.scene().object(object).shape().occludes(ray));
                double share = blocked ? 0.5 : 1;
                transmittance.set(share, share, share);
                return true;
            }
        };
        Scene scene = scene(matt(1))
                .camera(Camera.builder()
                        .from(v(0, 0, 9))
                        .to(Vector3.ZERO)
                        .fieldOfView(1)
                        .size(1, 1)
                        .build())
                .object("screen", new Sphere(v(9, 0, 9), 1), matt(0).build())
                .light(new DirectionalLight(v(-1, 0, -1), Color.grey(Math.PI), 0))
                .build();
        Settings settings = PHYSICAL.toBuilder().shader("half").build();
        RenderPlan plan = RenderPlan.of(scene, settings, List.of(half), List.of());
        // The sphere's front, lit at 45°, behind the screen.
        assertThat(new RenderJob(plan).run().image().get(0, 0).red()).isCloseTo(0.5 * Math.sqrt(0.5), within(1e-6));
        assertDecision(plan, "shader", true, "asked for");
    }

    @Test
    void renderJob_givenPictureTooLarge_isRefusedBeforeAnythingIsAllocated() {
        for (int side : new int[] {100_000, Integer.MAX_VALUE}) {
            Scene scene = scene(matt(1))
                    .camera(Camera.builder().size(side, side).build())
                    .build();
            RenderPlan plan = RenderPlan.of(scene, PHYSICAL);
            ResourceLimitException thrown =
                    catchThrowableOfType(ResourceLimitException.class, () -> new RenderJob(plan));
            assertThat(thrown)
                    .hasMessageContaining(side + " x " + side + " needs ")
                    .hasMessageContaining(" bytes, but only ");
        }
    }

    private static void assertDecision(RenderPlan plan, String part, boolean used, String reason) {
        assertThat(plan.decisions())
                .filteredOn(decision -> decision.part().equals(part))
                .singleElement()
                .satisfies(decision -> {
                    assertThat(decision.used()).as(part).isEqualTo(used);
                    assertThat(decision.reason()).contains(reason).isNotBlank();
                });
    }

    private static Scene.Builder scene(Material.Builder material) {
        return Scene.builder()
                .camera(Camera.builder().build())
                .object("thing 0", new Sphere(Vector3.ZERO, 1), material.build());
    }

    @Test
    void of_givenBubbleInWater_knowsThatItBendsLight() {
        Medium water = Medium.of(1.33);
        Material sheet = Material.builder()
                .transparency(Color.WHITE)
                .inside(water)
                .outside(water)
                .build();
        Material air = Material.builder().transparency(Color.WHITE).build();
        Scene.Builder scene =
                Scene.builder().camera(Camera.builder().build()).object("bubble", new Sphere(Vector3.ZERO, 1), air);
        assertDecision(RenderPlan.of(scene.build(), PHYSICAL), "shader", true, "exact");

        scene.object("surface", new Plane(new Vector3(0, 2, 0), Vector3.UNIT_Y), sheet);
        assertDecision(RenderPlan.of(scene.build(), PHYSICAL), "shader", true, "approximate: light through bubble");
    }

    @Test
    void of_givenShaderNamedAsAnother_refuses() {
        for (String name : List.of("auto", "non-refractive")) {
            Shader twin = new Shader() {
                @Override
                public String name() {
                    return name;
                }

                @Override
                public boolean transmit(ShadowRay shadow, Rgb transmittance) {
                    return false;
                }
            };
            Scene scene = scene(matt(1)).build();
            assertThatThrownBy(() -> RenderPlan.of(scene, PHYSICAL, List.of(twin), List.of()))
                    .isInstanceOf(PlanException.class)
                    .hasMessageContaining(name);
        }
    }

    @Test
    void render_givenAreaLightOfOneSample_spreadsItOverTheArea() {
        // A ball before the middle of a large light: its half-shadow needs the whole light, however few samples a hit
        // has.
        float one = floorUnderBall(1, 4096);
        float many = floorUnderBall(64, 256);
        assertThat(one).isCloseTo(many, org.assertj.core.data.Offset.offset(0.03f * many));
    }

    private static float floorUnderBall(int lightSamples, int eyeSamples) {
        Scene scene = Scene.builder()
                .camera(Camera.builder()
                        .from(new Vector3(3, 1, 0))
                        .to(new Vector3(0.3, 0, 0))
                        .fieldOfView(0.01)
                        .size(1, 1)
                        .build())
                .light(FlatLight.disc(
                        new Vector3(0, 4, 0),
                        new Vector3(0, -1, 0),
                        1.5,
                        Color.WHITE,
                        new Falloff.InverseSquare(),
                        lightSamples))
                .object("floor", new Plane(Vector3.ZERO, Vector3.UNIT_Y), matt(1).build())
                .object("ball", new Sphere(new Vector3(0, 2, 0), 0.5), matt(1).build())
                .build();
        Settings settings = PHYSICAL.toBuilder().samples(eyeSamples).build();
        return (float) Renderer.render(scene, settings).image().get(0, 0).green();
    }
}
