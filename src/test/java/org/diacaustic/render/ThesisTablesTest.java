package org.diacaustic.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import org.diacaustic.image.LinearImage;
import org.diacaustic.math.Ray;
import org.diacaustic.scene.Camera;
import org.diacaustic.scenefile.Problems;
import org.diacaustic.scenefile.SceneFile;
import org.diacaustic.scenefile.SceneReader;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * The thesis' scenes. Its Table 3 has 201,996 tests, 21,696 shadow, 592 reflection and 5,180 refraction rays, its Table 7
 * has 185,114, 19,018, 1,042 and 1,786; both shading models agree, in the thesis too. Its Table 11 has 85,492, 266 and
 * 2,492 rays, with 2,226,208 tests of non-transparent and 2,257,544 of non-refractive shading. The cameras, which the
 * thesis does not give, were fitted, so ours are a little different: but always the same.
 */
class ThesisTablesTest {

    @ParameterizedTest(name = "{0}, {1}")
    @CsvSource({
        "control, non-transparent, 200974, 21433, 589, 5168",
        "control, non-refractive, 200974, 21433, 589, 5168",
        "refraction, non-transparent, 184378, 19281, 589, 1788",
        "refraction, non-refractive, 184378, 19281, 589, 1788",
        "complex, non-transparent, 2225218, 85518, 267, 2493",
        "complex, non-refractive, 2256078, 85518, 267, 2493",
    })
    void render_givenScene_countsAsItsTable(
            String scene, String shader, long tests, long shadow, long reflection, long refraction) {
        Counters counters = render(scene, shader).counters();

        assertThat(counters.eyeRays()).isEqualTo(40_000);
        assertThat(counters.intersectionTests()).isEqualTo(tests);
        assertThat(counters.shadowRays()).isEqualTo(shadow);
        assertThat(counters.reflectionRays()).isEqualTo(reflection);
        assertThat(counters.refractionRays()).isEqualTo(refraction);
    }

    @Test
    void render_givenBoxUnderItsSurface_isBlackWithoutLightThroughIt() {
        assertThat(render("complex", "non-transparent").image().samples()).containsOnly(0f);
    }

    @ParameterizedTest
    @ValueSource(strings = {"control", "refraction"})
    void render_givenFloorUnderTheSheet_isDarkOrLitByTheShader(String scene) {
        // The floor is 0.7 green under a light of intensity 1 without falloff; the sheet lets 0.9 through.
        assertThat(greenUnderTheSheet(scene, "non-transparent")).isZero();
        assertThat(greenUnderTheSheet(scene, "non-refractive")).isCloseTo(0.7 * 0.9, within(0.01));
    }

    /** The mean of a patch of the floor that lies under the sheet, but is not seen through it. */
    private static double greenUnderTheSheet(String scene, String shader) {
        LinearImage image = render(scene, shader).image();
        Camera camera = read(scene).scene().camera();
        Ray ray = new Ray();
        double sum = 0;
        int count = 0;
        for (int y = 0; y < image.height(); y++) {
            for (int x = 0; x < image.width(); x++) {
                camera.aim(x + 0.5, y + 0.5, 0, 0, ray);
                double t = -ray.originY / ray.directionY;
                double tSheet = (4 - ray.originY) / ray.directionY;
                boolean underTheSheet = Math.abs(ray.pointX(t)) + Math.abs(ray.pointZ(t)) < 3.4;
                boolean throughTheSheet = Math.abs(ray.pointX(tSheet)) + Math.abs(ray.pointZ(tSheet)) < 3.6;
                boolean nearTheBall = Math.hypot(ray.pointX(t) + 0.9, ray.pointZ(t) - 1.25) < 2;
                if (underTheSheet && !throughTheSheet && !nearTheBall && ray.pointX(t) > 0.5) {
                    sum += image.get(x, y).green();
                    count++;
                }
            }
        }
        assertThat(count).isGreaterThan(100);
        return sum / count;
    }

    private static Rendering render(String scene, String shader) {
        SceneFile file = read(scene);
        return Renderer.render(
                file.scene(), file.settings().toBuilder().shader(shader).build());
    }

    private static SceneFile read(String scene) {
        Problems problems = new Problems();
        return SceneReader.read(Path.of("scenes", scene + ".yaml"), problems).orElseThrow();
    }
}
