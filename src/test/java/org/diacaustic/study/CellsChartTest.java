package org.diacaustic.study;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.diacaustic.render.PlanException;
import org.diacaustic.scenefile.Problems;
import org.diacaustic.scenefile.SceneDocument;
import org.diacaustic.scenefile.SceneReader;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class CellsChartTest {
    /** Light straight down through a sheet that does not bend it, onto a floor 10 by 10 pixels large in the middle. */
    private static final String SCENE = """
            camera: {from: [0, 20, 0], to: [0, 0, 0], up: [0, 0, -1], size: [20, 20], field-of-view: 90%s}
            lights:
              - directional: {direction: [0, -1, 0], irradiance: 1}
            materials:
              grey: {diffuse: 0.5}
              sheet: {transparency: 1, ior: %s}
            objects:
              - polygon: {vertices: [[-50, 0, 50], [50, 0, 50], [50, 0, -50], [-50, 0, -50]], material: grey}
              - polygon: {vertices: [[-10, 5, 10], [10, 5, 10], [10, 5, -10], [-10, 5, -10]], material: sheet}
            """;

    private static final Pattern TRIANGLE = Pattern.compile("M(-?\\d+) (-?\\d+)l(-?\\d+) (-?\\d+) (-?\\d+) (-?\\d+)z");

    @TempDir
    private Path folder;

    private String draw(String camera, String indexOfRefraction) throws IOException {
        Path file = CellsChart.write(
                extra -> {
                    Problems problems = new Problems();
                    SceneDocument document = SceneDocument.parse(
                            "sheet.yaml", String.format(SCENE, camera, indexOfRefraction), problems);
                    extra.forEach((key, value) -> document.override("settings", key, value));
                    return SceneReader.read(document, problems).orElseThrow(() -> new AssertionError(problems));
                },
                200,
                1,
                folder);
        return Files.readString(file);
    }

    /** Twice the area of all triangles of a path. */
    private static long area(String path) {
        long sum = 0;
        Matcher triangle = TRIANGLE.matcher(path);
        while (triangle.find()) {
            long x = Long.parseLong(triangle.group(3));
            long y = Long.parseLong(triangle.group(4));
            sum += Math.abs(x * Long.parseLong(triangle.group(6)) - y * Long.parseLong(triangle.group(5)));
        }
        return sum;
    }

    @Test
    void write_givenLens_isRefused() {
        assertThatThrownBy(() -> draw(", lens-radius: 0.1, focus-distance: 5", "1.5"))
                .isInstanceOf(PlanException.class)
                .hasMessageContaining("lens-radius");
    }

    @Test
    void write_givenStraightLight_drawsCellsThatTileLightSpaceAndFloor() throws IOException {
        String[] paths = draw("", "1.5").split("<path ");
        assertThat(paths).hasSize(3);
        // All of light space: a square of 320 units, 8 steps each; corners are rounded to steps.
        assertThat(area(paths[1]) / 2.0 / (2560.0 * 2560.0)).isBetween(0.999, 1.001);
        // The sheet is half as wide as the picture at the floor, where the light arrives straight: a quarter of it.
        assertThat(area(paths[2]) / 2.0 / (2560.0 * 2560.0)).isBetween(0.2495, 0.2505);
    }
}
