package org.diacaustic.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.diacaustic.image.LinearImage;
import org.diacaustic.math.Ray;
import org.diacaustic.scene.Camera;
import org.diacaustic.scene.ForwardSettings;
import org.diacaustic.scene.MapName;
import org.diacaustic.scene.MapSettings;
import org.diacaustic.scene.Settings;
import org.diacaustic.scenefile.FileScope;
import org.diacaustic.scenefile.Problems;
import org.diacaustic.scenefile.SceneDocument;
import org.diacaustic.scenefile.SceneFile;
import org.diacaustic.scenefile.SceneReader;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** The thesis' three scenes with every technique: how bright and how uneven what they light is. */
class ThesisPicturesTest {
    static Stream<Arguments> techniques() {
        return Stream.of("random", "monte-carlo", "planar", "cube", "adaptive", "own-map")
                .flatMap(preProcessor -> Stream.of(MapName.PHOTON_MAP, MapName.AMBIENT_MAPS)
                        .map(map -> Arguments.of(preProcessor, map)));
    }

    /** The floor is 0.7 green, the sheet lets 0.9 through and bends nothing: 0.63, evenly. */
    @ParameterizedTest
    @MethodSource("techniques")
    void render_givenControlScene_lightsTheFloorEvenly(String preProcessor, MapName map) {
        List<Double> greens = underTheSheet("control", preProcessor, map);
        assertThat(mean(greens)).isCloseTo(0.63, within(0.02));
        // Of 50 photons at random one expects a noise of 0.14.
        boolean isLattice = !preProcessor.equals("random") && !preProcessor.equals("monte-carlo");
        assertThat(contrast(greens)).isLessThan(isLattice ? 0.1 : 0.2);
    }

    /** Waves gather the same light into stripes: about as much in all, but uneven. */
    @ParameterizedTest
    @MethodSource("techniques")
    void render_givenRefractionScene_showsTheStripesOfTheWaves(String preProcessor, MapName map) {
        List<Double> greens = underTheSheet("refraction", preProcessor, map);
        assertThat(mean(greens)).isBetween(0.45, 0.75);
        assertThat(contrast(greens)).isGreaterThan(0.25);
    }

    /** Without a map this picture is black, as another test asserts. */
    @ParameterizedTest
    @MethodSource("techniques")
    void render_givenComplexScene_isLitThroughTheWater(String preProcessor, MapName map) {
        LinearImage image = render(read("complex"), preProcessor, map);
        List<Double> greens = new ArrayList<>();
        for (int y = image.height() * 2 / 3; y < image.height(); y++) {
            for (int x = 0; x < image.width(); x++) {
                greens.add((double) image.get(x, y).green());
            }
        }
        assertThat(mean(greens)).isBetween(0.2, 0.9);
        assertThat(contrast(greens)).isGreaterThan(0.2);
    }

    private static LinearImage render(SceneFile file, String preProcessor, MapName map) {
        Settings settings = file.settings().toBuilder()
                .forward(ForwardSettings.builder()
                        .preProcessor(preProcessor)
                        .rays(100_000)
                        .build())
                .maps(MapSettings.builder().map(map).build())
                .build();
        return Renderer.render(file.scene(), settings).image();
    }

    private static SceneFile read(String name) {
        Problems problems = new Problems();
        Path path = Path.of("scenes", name + ".yaml");
        SceneDocument document = SceneDocument.read(path, FileScope.inFolderOf(path), problems);
        return SceneReader.read(document, problems).orElseThrow();
    }

    /** A patch of the floor that lies under the sheet, away from its edges and the ball, and is not seen through the sheet. */
    private static List<Double> underTheSheet(String name, String preProcessor, MapName map) {
        SceneFile file = read(name);
        Camera camera = file.scene().camera();
        LinearImage image = render(file, preProcessor, map);
        List<Double> greens = new ArrayList<>();
        Ray ray = new Ray();
        for (int y = 0; y < image.height(); y++) {
            for (int x = 0; x < image.width(); x++) {
                camera.aim(x + 0.5, y + 0.5, 0, 0, ray);
                double t = -ray.originY / ray.directionY;
                double tSheet = (4 - ray.originY) / ray.directionY;
                boolean underTheSheet = Math.abs(ray.pointX(t)) + Math.abs(ray.pointZ(t)) < 3.3;
                boolean throughTheSheet = Math.abs(ray.pointX(tSheet)) + Math.abs(ray.pointZ(tSheet)) < 3.6;
                boolean nearTheBall = Math.hypot(ray.pointX(t) + 0.9, ray.pointZ(t) - 1.25) < 2;
                if (underTheSheet && !throughTheSheet && !nearTheBall) {
                    greens.add((double) image.get(x, y).green());
                }
            }
        }
        assertThat(greens.size()).isGreaterThan(500);
        return greens;
    }

    private static double mean(List<Double> values) {
        return values.stream().mapToDouble(value -> value).average().orElseThrow();
    }

    /** The standard deviation ÷ the mean. */
    private static double contrast(List<Double> values) {
        double mean = mean(values);
        double variance = values.stream()
                .mapToDouble(value -> (value - mean) * (value - mean))
                .average()
                .orElseThrow();
        return Math.sqrt(variance) / mean;
    }
}
