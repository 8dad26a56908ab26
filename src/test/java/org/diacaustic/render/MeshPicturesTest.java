package org.diacaustic.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.diacaustic.render.Eye.matt;
import static org.diacaustic.render.Eye.v;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.diacaustic.image.LinearImage;
import org.diacaustic.light.DirectionalLight;
import org.diacaustic.light.Falloff;
import org.diacaustic.light.Light;
import org.diacaustic.light.PointLight;
import org.diacaustic.material.Material;
import org.diacaustic.material.Wave;
import org.diacaustic.math.Color;
import org.diacaustic.math.Vector3;
import org.diacaustic.scene.Camera;
import org.diacaustic.scene.ForwardSettings;
import org.diacaustic.scene.MapName;
import org.diacaustic.scene.MapSettings;
import org.diacaustic.scene.Scene;
import org.diacaustic.scene.Settings;
import org.diacaustic.shader.NonRefractiveShader;
import org.diacaustic.shape.Box;
import org.diacaustic.shape.ConvexPolygon;
import org.diacaustic.shape.Shape;
import org.diacaustic.shape.Sphere;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Whole pictures of the caustic mesh whose answer is known. */
class MeshPicturesTest {
    private static final int SIZE = 48;

    private static ConvexPolygon square(double height, double half) {
        return ConvexPolygon.twoSided(
                v(-half, height, -half), v(-half, height, half), v(half, height, half), v(half, height, -half));
    }

    private static Settings mesh(String preProcessor, long rays) {
        return Settings.physical().toBuilder()
                .forward(ForwardSettings.builder()
                        .preProcessor(preProcessor)
                        .rays(rays)
                        .build())
                .maps(MapSettings.builder().map(MapName.CAUSTIC_MESH).build())
                .build();
    }

    private static LinearImage render(Scene scene, Settings settings) {
        return new RenderJob(RenderPlan.of(scene, settings), 2, (done, total) -> {})
                .run()
                .image();
    }

    private static Camera camera(Vector3 from, Vector3 to) {
        return Camera.builder().from(from).to(to).size(SIZE, SIZE).build();
    }

    /** The control scene of the thesis: a waved sheet that does not bend, over a floor and a ball. */
    private static Scene control(Falloff falloff, Vector3 from, Vector3 to) {
        Material sheet = Material.builder()
                .transparency(Color.grey(0.9))
                .bump(new Wave(v(1, 0, 1), 7.5, 0.03, 0))
                .build();
        return Scene.builder()
                .camera(Camera.builder()
                        .from(from)
                        .to(to)
                        .fieldOfView(20)
                        .size(96, 96)
                        .build())
                .light(new PointLight(v(0, 30, 0), Color.grey(10), falloff, 0))
                .object("floor", square(0, 5), matt(0.7).build())
                .object("ball", new Sphere(v(-0.9, 0.77, 1.25), 0.77), matt(0.4).build())
                .object("sheet", square(4, 2.5), sheet)
                .build();
    }

    private static LinearImage straight(Scene scene) {
        return render(
                scene,
                Settings.physical().toBuilder()
                        .shader(NonRefractiveShader.NAME)
                        .samples(16)
                        .build());
    }

    /** Relative errors where within three pixels nothing changes by more than a part. */
    private static double[] innerErrors(LinearImage found, LinearImage straight, double part) {
        List<Double> errors = new ArrayList<>();
        int size = straight.width();
        for (int y = 3; y < size - 3; y++) {
            for (int x = 3; x < size - 3; x++) {
                if (largestChange(straight, x, y) < part) {
                    int i = 3 * (y * size + x);
                    errors.add(Math.abs(found.samples()[i] / straight.samples()[i] - 1.0));
                }
            }
        }
        return errors.stream().mapToDouble(error -> error).sorted().toArray();
    }

    /**
     * On the floor, where nothing begins or ends, the picture is that of straight shadow rays. What is left is that those are 16
     * points of a pixel, and the mesh its mean.
     */
    @ParameterizedTest
    @CsvSource({"own-map, none", "own-map, nature", "own-map, polynomial", "planar, none", "planar, nature"})
    void render_givenSheetThatDoesNotBend_isThePictureOfStraightShadowRays(String preProcessor, String law) {
        Scene scene = control(falloff(law), v(16.5, 17.7, 12), v(0, 0.5, 0));
        LinearImage found = render(
                scene, mesh(preProcessor, 1 << 16).toBuilder().samples(16).build());
        double[] errors = innerErrors(found, straight(scene), 0.01);
        assertThat(errors.length).isGreaterThan(2000);
        assertThat(errors[errors.length - 1]).isLessThan(6e-5);
        assertThat(Arrays.stream(errors).average().getAsDouble()).isLessThan(5e-6);
    }

    /** The same on the ball, pixels smaller than cells: their flat triangles are off by a part that falls as 1/N. */
    @ParameterizedTest
    @ValueSource(strings = {"none", "nature"})
    void render_givenBallUnderSheetThatDoesNotBend_isThePictureOfStraightShadowRays(String law) {
        Scene scene = control(falloff(law), v(-0.9, 3.8, 4), v(-0.9, 1, 1.25));
        LinearImage straight = straight(scene);
        for (long rays = 1 << 14; rays <= 1 << 16; rays *= 4) {
            LinearImage found =
                    render(scene, mesh("own-map", rays).toBuilder().samples(16).build());
            double[] errors = innerErrors(found, straight, 0.1);
            assertThat(errors.length).isGreaterThan(4000);
            assertThat(errors[errors.length / 2]).isLessThan(300.0 / rays);
        }
    }

    private static Falloff falloff(String law) {
        return switch (law) {
            case "none" -> new Falloff.None();
            case "nature" -> new Falloff.InverseSquare();
            default -> new Falloff.Polynomial(1, 0.05, 0.002);
        };
    }

    private static double largestChange(LinearImage image, int x, int y) {
        double here = image.samples()[3 * (y * image.width() + x)];
        double change = 0;
        for (int row = y - 3; row <= y + 3; row++) {
            for (int column = x - 3; column <= x + 3; column++) {
                change = Math.max(change, Math.abs(image.samples()[3 * (row * image.width() + column)] / here - 1));
            }
        }
        return here > 0 ? change : Double.POSITIVE_INFINITY;
    }

    /** A scene of lengths times a factor, seen the same. */
    private static Scene scaled(double scale, Falloff falloff) {
        return Scene.builder()
                .camera(camera(v(0, 7, -7).times(scale), Vector3.ZERO))
                .light(new PointLight(v(0.1, 7, 0.2).times(scale), Color.WHITE, falloff, 0))
                .object("floor", square(0, 5 * scale), matt(0.7).build())
                .object(
                        "stone",
                        new Sphere(v(2, 1, 0.5).times(scale), 0.7 * scale),
                        matt(0.5).build())
                .object(
                        "glass",
                        new Sphere(v(0, 1.5, 0).times(scale), scale),
                        Eye.clear(1.5).build())
                .object(
                        "mirror",
                        new Box(v(-3, 0, 1).times(scale), v(-2, 2, 3).times(scale)),
                        Eye.mirror(0.9).build())
                .build();
    }

    /** Lengths times 2^k: the same picture to the bit without falloff, 4^−k of it with nature's. */
    @ParameterizedTest
    @ValueSource(ints = {-20, 20, 30})
    void render_givenScaledScene_isTheSamePictureToTheBit(int exponent) {
        double scale = Math.scalb(1.0, exponent);
        for (String preProcessor : List.of("own-map", "planar", "cube", "adaptive")) {
            Settings settings = mesh(preProcessor, 4000);
            float[] small = render(scaled(1, new Falloff.None()), settings).samples();
            assertThat(render(scaled(scale, new Falloff.None()), settings).samples())
                    .as(preProcessor)
                    .isEqualTo(small);
            float[] near =
                    render(scaled(1, new Falloff.InverseSquare()), settings).samples();
            float[] far =
                    render(scaled(scale, new Falloff.InverseSquare()), settings).samples();
            for (int i = 0; i < near.length; i++) {
                assertThat(far[i]).as(preProcessor).isEqualTo(Math.scalb(near[i], -2 * exponent));
            }
        }
    }

    private static Scene dark(Camera camera, Light light, Shape... things) {
        Scene.Builder scene = Scene.builder().camera(camera).light(light);
        for (int i = 0; i < things.length; i++) {
            scene.object("thing " + i, things[i], matt(0.8).build());
        }
        return scene.object("glass", new Sphere(v(0, 2, 0), 1), Eye.clear(1.5).build())
                .build();
    }

    private static void assertBlack(Scene scene) {
        for (String preProcessor : List.of("own-map", "cube")) {
            Rendering rendering =
                    new RenderJob(RenderPlan.of(scene, mesh(preProcessor, 20_000)), 2, (done, total) -> {}).run();
            assertThat(rendering.forward().ledger().stored()).isPositive();
            assertThat(rendering.image().samples()).as(preProcessor).containsOnly(0);
        }
    }

    /** The back of a wall of paper on which a ball throws light, edges in the picture and all. */
    @Test
    void render_givenThinWallFromBehind_isBlack() {
        ConvexPolygon wall = ConvexPolygon.twoSided(v(1.5, 0, -4), v(1.5, 9, -4), v(1.5, 9, 4), v(1.5, 0, 4));
        assertBlack(dark(camera(v(9, 3, 1), v(1.5, 4, 0)), new PointLight(v(-3, 4, 0), Color.WHITE), wall));
    }

    /** A slab 1e-6 thick under the ball, seen from below, and the floor below it. */
    @Test
    void render_givenThinSlabFromBelow_isBlack() {
        Box slab = new Box(v(-20, -1e-6, -20), v(20, 0, 20));
        assertBlack(
                dark(camera(v(3, -4, 1), v(0, 0, 0)), new PointLight(v(0, 7, 0), Color.WHITE), slab, square(-5, 9)));
    }

    /** From below the equator of an opaque ball that the sun lights from straight above, through a pane that bends nothing. */
    @Test
    void render_givenDarkSideOfABall_isBlack() {
        Scene scene = Scene.builder()
                .camera(camera(v(0.3, -9, 0.2), v(0, 0, 0)))
                .light(new DirectionalLight(v(0, -1, 0), Color.WHITE, 0))
                .object("ball", new Sphere(v(0, 0, 0), 1), matt(0.8).build())
                .object("pane", square(4, 3), Eye.clear(1).build())
                .build();
        Rendering rendering = new RenderJob(RenderPlan.of(scene, mesh("planar", 20_000)), 2, (done, total) -> {}).run();
        assertThat(rendering.forward().ledger().stored()).isPositive();
        assertThat(rendering.image().samples()).containsOnly(0);
    }
}
