package org.diacaustic.study;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.function.DoubleUnaryOperator;
import org.diacaustic.image.LinearImage;
import org.diacaustic.light.Falloff;
import org.diacaustic.light.PointLight;
import org.diacaustic.material.Material;
import org.diacaustic.material.Medium;
import org.diacaustic.math.Color;
import org.diacaustic.math.Vector3;
import org.diacaustic.parallel.Workers;
import org.diacaustic.render.RenderPlan;
import org.diacaustic.scene.Camera;
import org.diacaustic.scene.ForwardSettings;
import org.diacaustic.scene.MapName;
import org.diacaustic.scene.MapSettings;
import org.diacaustic.scene.Scene;
import org.diacaustic.scene.Settings;
import org.diacaustic.shape.Box;
import org.diacaustic.shape.ConvexPolygon;
import org.diacaustic.shape.Shape;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class LightTracedPictureTest {
    private static final int BATCHES = 16;
    private static final int STRIPS = 3;
    private static final int SIDE = 3;

    /** How wide the floor is that the pictures show. */
    private static final double SHOWN = 0.6;

    private static final double DIFFUSE = 0.8;
    private static final Material MATT =
            Material.builder().diffuse(Color.grey(DIFFUSE)).build();

    /** Flux 1 W. */
    private static final Color INTENSITY = Color.grey(1 / (4 * Math.PI));

    private static final FlatLayers WATER = new FlatLayers(new double[] {1, 2}, new double[] {1, 1.33}, 1);
    private static final FlatLayers PLATE = new FlatLayers(new double[] {1, 0.5, 1}, new double[] {1, 1.5, 1}, 1);

    @Test
    void closedForms_givenThePublishedCases_agree() {
        // P-RADIOM-05, 06 and 07.
        assertThat(WATER.irradiance(0.7)).isCloseTo(0.01154532649264507, within(1e-14));
        assertThat(WATER.irradiance(2.5)).isCloseTo(0.005707301317358261, within(1e-14));
        assertThat(PLATE.irradiance(0.8)).isCloseTo(0.01158292581602342, within(1e-14));
    }

    @ParameterizedTest
    @CsvSource({
        "random, 0.7",
        "jittered, 0.0",
        "jittered, 0.7",
        "jittered, 2.5",
        "cube, 0.0",
        "cube, 0.7",
        "cube, 2.5",
        "adaptive, 0.7"
    })
    void picture_givenFlatWater_isTheClosedFormWithinItsOwnError(String preProcessor, double lateral) {
        Scene scene = scene(square(2, 1.6), clear(1.33), lateral);
        assertAgrees(traced(scene, preProcessor, 2), WATER::irradiance, lateral);
    }

    @ParameterizedTest
    @CsvSource({"random", "jittered"})
    void picture_givenAGlassPlate_isTheClosedFormWithinItsOwnError(String preProcessor) {
        // No light that was reflected inside the plate: the closed form is that of a single pass.
        Scene scene = scene(new Box(new Vector3(-2, 1, -2), new Vector3(2, 1.5, 2)), clear(1.5), 0.8, 2.5);
        assertAgrees(traced(scene, preProcessor, 2), PLATE::irradiance, 0.8);
    }

    @ParameterizedTest
    @CsvSource({"random", "jittered"})
    void picture_givenASheetThatDoesNotBendAndALightWithoutFalloff_isWhatStraightLightWouldBe(String preProcessor) {
        Scene water = scene(square(2, 1.6), clear(1), 0.7);
        Scene scene = Scene.builder()
                .camera(water.camera())
                .light(new PointLight(new Vector3(0, 3, 0), INTENSITY, new Falloff.None(), 0))
                .object(water.objects().get(0))
                .object(water.objects().get(1))
                .build();
        // Irradiance without falloff: intensity · cosine.
        DoubleUnaryOperator straight = r -> 3 / Math.hypot(r, 3) / (4 * Math.PI);
        assertAgrees(traced(scene, preProcessor, 2), straight, 0.7);
    }

    private static Scene scene(Shape refracting, Material material, double lateral) {
        return scene(refracting, material, lateral, 3);
    }

    private static Scene scene(Shape refracting, Material material, double lateral, double lightHeight) {
        return Scene.builder()
                .camera(above(lateral))
                .light(new PointLight(new Vector3(0, lightHeight, 0), INTENSITY))
                .object("floor", square(0, 4), MATT)
                .object("refracting", refracting, material)
                .build();
    }

    /** Looks straight down at the floor from below all that refracts. */
    private static Camera above(double lateral) {
        double height = 0.9;
        return Camera.builder()
                .from(new Vector3(lateral, height, 0))
                .to(new Vector3(lateral, 0, 0))
                .up(Vector3.UNIT_Z)
                .fieldOfView(Math.toDegrees(2 * Math.atan(SHOWN / 2 / height)))
                .size(SIDE, SIDE)
                .build();
    }

    private static ConvexPolygon square(double height, double half) {
        return ConvexPolygon.twoSided(
                new Vector3(-half, height, -half),
                new Vector3(-half, height, half),
                new Vector3(half, height, half),
                new Vector3(half, height, -half));
    }

    private static LightTracedPicture traced(Scene scene, String preProcessor, int threads) {
        ForwardSettings forward = ForwardSettings.builder()
                .preProcessor(preProcessor)
                .rays(preProcessor.equals(JitteredPreProcessor.NAME) ? 12_000 / STRIPS : 12_000)
                .maxDepth(2)
                .build();
        Settings settings = Settings.physical().toBuilder()
                .forward(forward)
                .maps(MapSettings.builder().map(MapName.PHOTON_MAP).build())
                .build();
        JitteredPreProcessor jittered = new JitteredPreProcessor(STRIPS);
        boolean isJittered = preProcessor.equals(JitteredPreProcessor.NAME);
        RenderPlan plan = RenderPlan.of(scene, settings, List.of(), List.of(jittered));
        LightTracedPicture picture = new LightTracedPicture(
                plan, new Workers(threads), isJittered ? STRIPS : 1, isJittered ? jittered::turnTo : strip -> {});
        for (int batch = 0; batch < BATCHES; batch++) {
            picture.add(batch);
        }
        return picture;
    }

    /** Every pixel must lie within 4.5 standard errors of the mean of the closed form over it. */
    private static void assertAgrees(LightTracedPicture traced, DoubleUnaryOperator expected, double lateral) {
        LinearImage picture = traced.picture();
        LinearImage error = traced.batches().standardError();
        for (int y = 0; y < SIDE; y++) {
            for (int x = 0; x < SIDE; x++) {
                double radiance = DIFFUSE / Math.PI * meanOverPixel(expected, lateral, x, y);
                double standardError = error.get(x, y).red();
                assertThat(standardError).as("%d, %d", x, y).isPositive().isLessThan(0.12 * radiance);
                assertThat(picture.get(x, y).red()).as("%d, %d", x, y).isCloseTo(radiance, within(4.5 * standardError));
            }
        }
    }

    private static double meanOverPixel(DoubleUnaryOperator irradiance, double lateral, int column, int row) {
        int steps = 20;
        double step = SHOWN / SIDE / steps;
        double sum = 0;
        for (int i = 0; i < steps * steps; i++) {
            // Looking down with z up in the picture, its right is −x.
            double x = lateral + SHOWN / 2 - (column * steps + i % steps + 0.5) * step;
            double z = SHOWN / 2 - (row * steps + i / steps + 0.5) * step;
            sum += irradiance.applyAsDouble(Math.hypot(x, z));
        }
        return sum / (steps * steps);
    }

    @Test
    void picture_givenAnyNumberOfThreads_isTheSameToTheBit() {
        Scene scene = scene(square(2, 1.6), clear(1.33), 0.5);
        LightTracedPicture one = traced(scene, "jittered", 1);
        assertThat(one.photonsSeen()).isPositive();
        for (int threads : List.of(2, 5)) {
            LightTracedPicture more = traced(scene, "jittered", threads);
            assertThat(more.picture().samples()).isEqualTo(one.picture().samples());
            assertThat(more.batches().standardError().samples())
                    .isEqualTo(one.batches().standardError().samples());
            assertThat(more.lightRays()).isEqualTo(one.lightRays());
        }
    }

    @Test
    void picture_givenTheFloorFromBelow_isBlack() {
        Camera below = Camera.builder()
                .from(new Vector3(0.2, -3, 0))
                .to(new Vector3(0.2, 0, 0))
                .up(Vector3.UNIT_Z)
                .size(4, 4)
                .build();
        LightTracedPicture traced = traced(withCamera(below, scene(square(2, 1), clear(1.33), 0)), "random", 2);
        assertThat(traced.photonsSeen()).isZero();
        assertThat(traced.lightRays()).isPositive();
        assertThat(traced.picture().samples()).containsOnly(0);
    }

    @Test
    void picture_givenSomethingBeforeTheFloor_isBlackThereAndShowsIt() {
        // A lid below the water hides the left half of the floor from the eye, and is lit itself.
        Scene open = scene(square(2, 1.6), clear(1.33), 0);
        Scene lidded = Scene.builder()
                .camera(open.camera())
                .light(open.lights().get(0))
                .object(open.objects().get(0))
                .object(open.objects().get(1))
                .object(
                        "lid",
                        ConvexPolygon.twoSided(
                                new Vector3(0.02, 0.45, -1),
                                new Vector3(1, 0.45, -1),
                                new Vector3(1, 0.45, 1),
                                new Vector3(0.02, 0.45, 1)),
                        Material.builder().diffuse(new Color(0.8, 0, 0)).build())
                .build();
        LinearImage picture = traced(lidded, "cube", 2).picture();
        for (int y = 0; y < SIDE; y++) {
            assertThat(picture.get(0, y).red()).isPositive();
            assertThat(picture.get(0, y).green()).isZero();
            assertThat(picture.get(2, y).green()).isPositive();
        }
    }

    @Test
    void constructor_givenNothingToTrace_isRefused() {
        Scene dull = Scene.builder()
                .camera(above(0))
                .light(new PointLight(new Vector3(0, 3, 0), INTENSITY))
                .object("floor", square(0, 4), MATT)
                .build();
        RenderPlan plan = RenderPlan.of(dull, Settings.physical());
        Workers workers = new Workers(1);
        assertThatThrownBy(() -> new LightTracedPicture(plan, workers, 1, strip -> {}))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("there is none to trace");
    }

    private static Material clear(double index) {
        return Material.builder()
                .transparency(Color.WHITE)
                .inside(Medium.of(index))
                .build();
    }

    private static Scene withCamera(Camera camera, Scene scene) {
        return new Scene(camera, scene.lights(), scene.objects(), scene.background());
    }
}
