package org.diacaustic.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.diacaustic.image.ImageFiles;
import org.diacaustic.image.LinearImage;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class StudyCommandTest {
    private static final String METHODS =
            "light-tracing,random-nearest,planar-ambient-maps,few:map=photon-map:gather-count=9";

    @Test
    void study_givenWhatCannotBe_saysItInOneLine(@TempDir Path folder) throws IOException {
        Path scene = SmallScene.in(folder);
        Path out = folder.resolve("out");
        refused(2, "issing required parameter: 'SCENE'", "study", "-o", out);
        refused(2, "missing required option -o DIR", "study", scene);
        refused(2, "at least 1 light ray", "study", scene, "-o", out, "--budgets", "100,0");
        refused(2, "or a time, such as 2s, found 'many'", "study", scene, "-o", out, "--budgets", "many");
        refused(2, "'100' is there twice", "study", scene, "-o", out, "--budgets", "100,2s,100");
        refused(2, "--seeds must be at least 1", "study", scene, "-o", out, "--seeds", "0");
        refused(2, "--cells must be at least 1", "study", scene, "-o", out, "--cells", "0");
        refused(2, "--reference-rays must be at least 1", "study", scene, "-o", out, "--reference-rays", "0");
        refused(2, "unit ms, s, m or h", "study", scene, "-o", out, "--reference-time", "1d");
        refused(2, "a number above 0", "study", scene, "-o", out, "--reference-time", "0s");
        refused(2, "unknown technique 'mash'", "study", scene, "-o", out, "--methods", "mash");
        refused(2, "exclude each other", "study", scene, "-o", out, "--reference-rays", 5, "--reference-time", "5s");
        refused(3, "nowhere.pfm: there is no such file", "study", scene, "-o", out, "--reference", "nowhere.pfm");
        refused(2, "gather-cuont: unknown key", "study", scene, "-o", out, "-D", "gather-cuont=5");
        refused(2, "gather-cuont: unknown key", "study", scene, "-o", out, "--methods", "few:gather-cuont=5");
        Path file = Files.writeString(folder.resolve("notes.txt"), "mine");
        refused(3, file + ": is a file, not a folder", "study", scene, "-o", file);
        refused(3, file + ": is a file, not a folder", "study", "--write-scenes", file);
        assertThat(out).doesNotExist();
    }

    @Test
    void study_givenACameraWithALens_isRefused(@TempDir Path folder) throws IOException {
        Path scene = SmallScene.in(folder, "camera: {", "camera: {lens-radius: 0.1, ");
        refused(2, "pinhole", "study", scene, "-o", folder.resolve("out"), "--reference-rays", 1000);
    }

    private static void refused(int code, String line, Object... arguments) {
        Cli.Result result = Cli.run(arguments);
        assertThat(result.errorLines()).hasSize(1).first().asString().contains(line);
        assertThat(result.code()).isEqualTo(code);
        assertThat(result.out()).isEmpty();
    }

    @Test
    void study_givenAScene_writesThePageTheNumbersAndPictures(@TempDir Path folder) throws IOException {
        Path scene = SmallScene.in(folder);
        Path out = folder.resolve("a/b");
        Cli.Result result = study(scene, out, "--reference-rays", 40_000, "--size", "40x40");

        assertThat(result.err()).isEmpty();
        assertThat(result.code()).isZero();
        assertThat(result.out())
                .contains("technique", "rRMSE", "ambient-maps", "non-refractive")
                .endsWith(out.resolve("study.html") + ": written, 6 of 6 points\n");
        JsonNode json = json(out);
        assertThat(json.path("complete").asBoolean()).isTrue();
        assertThat(json.path("command").asText()).contains("--methods " + METHODS, "--size 40x40");
        assertThat(json.path("reference").path("batches").asInt()).isEqualTo(4);
        assertThat(json.path("shading")).hasSize(2);
        // The middle budget is the larger of two; light-tracing is nothing that render can do.
        assertThat(json.path("cold").path("budget").asText()).isEqualTo("4000");
        assertThat(json.path("cold").path("start").asDouble()).isPositive();
        assertThat(json.path("cold").path("seconds").path("few").asDouble())
                .isGreaterThan(json.path("cold").path("start").asDouble());
        assertThat(json.path("cold").path("seconds")).hasSize(2);
        assertThat(json.path("techniques")).hasSize(4);
        JsonNode traced = json.path("techniques").path(0);
        assertThat(traced.path("points")).hasSize(2);
        JsonNode point = traced.path("points").path(1);
        assertThat(point.path("rays").asLong()).isEqualTo(4000);
        JsonNode run = point.path("runs").path(1);
        assertThat(run.path("seed").asLong()).isEqualTo(2);
        // All that is refracted and mirrored counts.
        assertThat(run.path("lightRays").asLong()).isGreaterThan(4000);
        assertThat(run.path("rRMSE").asDouble()).isPositive();
        assertThat(run.path("work").asDouble()).isGreaterThan(4000);
        assertThat(out.resolve("pictures/light-tracing-4000.pfm")).exists();
        assertThat(out.resolve("pictures/few-1000.png")).exists();
        // The floor has no end, which ambient maps need; the others go on.
        JsonNode refused = json.path("techniques").path(2);
        assertThat(refused.path("refusal").asText()).contains("floor");
        assertThat(refused.path("points")).isEmpty();
        // A head, and three techniques with two budgets and two seeds.
        assertThat(Files.readAllLines(out.resolve("runs.csv"))).hasSize(1 + 3 * 2 * 2);
        assertThat(Files.readAllLines(out.resolve("points.csv"))).hasSize(1 + 3 * 2);
        assertThat(Files.readString(out.resolve("study.html"))).contains("</html>");
    }

    @Test
    void study_givenItsOwnReference_findsTheSame(@TempDir Path folder) throws IOException {
        Path scene = SmallScene.in(folder);
        Path first = folder.resolve("first");
        Path second = folder.resolve("second");
        study(scene, first, "--reference-rays", 40_000, "--threads", 1, "--no-cold");
        study(scene, second, "--reference", first.resolve("reference.pfm"), "--threads", 3, "--no-cold");

        JsonNode one = json(first).path("techniques");
        JsonNode two = json(second).path("techniques");
        for (int technique : new int[] {0, 1, 3}) {
            JsonNode a = one.path(technique).path("points").path(1);
            JsonNode b = two.path(technique).path("points").path(1);
            for (String exact : new String[] {"rRMSE", "relMSE", "bias", "lightRays", "intersectionTests"}) {
                assertThat(b.path("runs").path(1).path(exact))
                        .isEqualTo(a.path("runs").path(1).path(exact));
            }
            assertThat(b.path("referenceError").asDouble())
                    .isCloseTo(a.path("referenceError").asDouble(), within(1e-12));
        }
        assertThat(Files.readAllBytes(second.resolve("pictures/few-4000.pfm")))
                .isEqualTo(Files.readAllBytes(first.resolve("pictures/few-4000.pfm")));
    }

    @Test
    void study_givenTheSameAgain_keepsWhatIsThere(@TempDir Path folder) throws IOException {
        Path scene = SmallScene.in(folder);
        Path out = folder.resolve("out");
        Object[] few = {"--reference-rays", 4000, "--no-cold"};
        study(scene, out, few);
        String runs = Files.readString(out.resolve("runs.csv"));
        assertThat(study(scene, out, few).code()).isZero();
        assertThat(Files.readString(out.resolve("runs.csv"))).isEqualTo(runs);

        refused(2, "holds a study with reference 4000 rays", "study", scene, "-o", out, "--reference-rays", 5000);
        Cli.Result again = study(scene, out, "--reference-rays", 4000, "--no-cold", "--restart");
        assertThat(again.code()).isZero();
        // Other times.
        assertThat(Files.readString(out.resolve("runs.csv"))).isNotEqualTo(runs);
    }

    @Test
    void study_givenAReferenceOfAnotherSize_isRefused(@TempDir Path folder) throws IOException {
        Path reference = folder.resolve("other.pfm");
        ImageFiles.write(new LinearImage(3, 3), org.diacaustic.image.Exposure.fixed(1), reference);
        Path scene = SmallScene.in(folder);
        refused(2, "the images differ in size", "study", scene, "-o", folder.resolve("out"), "--reference", reference);
    }

    @Test
    void study_givenQuick_isSmallUnlessSomethingElseIsSaid(@TempDir Path folder) throws IOException {
        Path out = folder.resolve("out");
        Cli.Result result = Cli.run(
                "study",
                SmallScene.in(folder),
                "-o",
                out,
                "--quick",
                "--methods",
                "random-nearest",
                "--budgets",
                "100",
                "--reference-time",
                "0.1s",
                "--no-cold",
                "--size",
                "40x40");
        assertThat(result.code()).isZero();
        JsonNode json = json(out);
        assertThat(json.path("reference").path("width").asInt()).isEqualTo(40);
        assertThat(json.path("techniques").path(0).path("points").path(0).path("runs"))
                .hasSize(5);
    }

    @Test
    void study_givenAFolderForScenes_writesThem(@TempDir Path folder) {
        Cli.Result result = Cli.run("study", "--write-scenes", folder);
        assertThat(result.code()).isZero();
        assertThat(result.out()).startsWith(folder.resolve("water-sheet.yaml") + ": written");
        assertThat(folder.resolve("water-sheet.obj")).exists();
    }

    @Test
    void study_givenCells_drawsThemAndDoesNoMore(@TempDir Path folder) throws IOException {
        Path out = folder.resolve("out");
        Cli.Result result = Cli.run("study", SmallScene.in(folder), "-o", out, "--cells", 100);
        assertThat(result.code()).isZero();
        assertThat(result.out()).isEqualTo(out.resolve("cells.svg") + ": written" + System.lineSeparator());
        assertThat(out.toFile().list()).containsExactly("cells.svg");
    }

    private static JsonNode json(Path out) throws IOException {
        return new ObjectMapper().readTree(out.resolve("study.json").toFile());
    }

    private static Cli.Result study(Path scene, Path out, Object... more) {
        Object[] fixed = {"study", scene, "-o", out, "--budgets", "1000,4000", "--seeds", 2, "--methods", METHODS};
        Object[] all = java.util.Arrays.copyOf(fixed, fixed.length + more.length);
        System.arraycopy(more, 0, all, fixed.length, more.length);
        return Cli.run(all);
    }
}
