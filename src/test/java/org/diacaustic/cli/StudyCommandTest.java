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
    private static final String TECHNIQUES =
            "light-tracing,random-photons,ambient-maps,few:map=photon-map:gather-count=9";

    @Test
    void study_givenWhatCannotBe_saysItInOneLine(@TempDir Path folder) throws IOException {
        Path scene = SmallScene.in(folder);
        Path out = folder.resolve("out");
        refused(2, "missing required parameter: SCENE; see", "study", "-o", out);
        refused(2, "missing required option -o DIR", "study", scene);
        refused(2, "--rays must be at least 1", "study", scene, "-o", out, "--rays", "100,0");
        refused(2, "--cells must be at least 1", "study", scene, "-o", out, "--cells", "0");
        refused(2, "--reference-rays must be at least 1", "study", scene, "-o", out, "--reference-rays", "0");
        refused(2, "unit ms, s, m or h", "study", scene, "-o", out, "--reference-time", "1d");
        refused(2, "a number above 0", "study", scene, "-o", out, "--reference-time", "0s");
        refused(2, "unknown technique 'mash'", "study", scene, "-o", out, "--techniques", "mash");
        refused(2, "exclude each other", "study", scene, "-o", out, "--reference-rays", 5, "--reference-time", "5s");
        refused(3, "nowhere.pfm: there is no such file", "study", scene, "-o", out, "--reference", "nowhere.pfm");
        refused(2, "gather-cuont: unknown key", "study", scene, "-o", out, "-D", "gather-cuont=5");
        refused(2, "gather-cuont: unknown key", "study", scene, "-o", out, "--techniques", "few:gather-cuont=5");
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
    void study_givenAScene_writesWhatItFoundAndItsPictures(@TempDir Path folder) throws IOException {
        Path scene = SmallScene.in(folder);
        Path out = folder.resolve("a/b");
        Cli.Result result = study(scene, out, "--reference-rays", 40_000);

        assertThat(result.err()).isEmpty();
        assertThat(result.code()).isZero();
        assertThat(result.out())
                .contains("technique", "rRMSE", "ambient-maps")
                .contains("noise of the reference")
                .endsWith(out.resolve("study.json") + ": written, with the pictures beside it\n");
        JsonNode json = new ObjectMapper().readTree(out.resolve("study.json").toFile());
        assertThat(json.path("reference").path("batches").asInt()).isEqualTo(16);
        assertThat(json.path("techniques")).hasSize(4);
        JsonNode traced = json.path("techniques").path(0);
        assertThat(traced.path("runs")).hasSize(2);
        JsonNode run = traced.path("runs").path(1);
        assertThat(run.path("rays").asLong()).isEqualTo(4000);
        // All that is refracted and mirrored counts.
        assertThat(run.path("lightRays").asLong()).isGreaterThan(4000);
        assertThat(run.path("pixels").asLong()).isPositive();
        assertThat(run.path("rRMSE").asDouble()).isPositive();
        assertThat(run.path("file").asText()).isEqualTo("pictures/light-tracing-4000.pfm");
        assertThat(out.resolve("pictures/light-tracing-4000.pfm")).exists();
        assertThat(out.resolve("pictures/few-1000.png")).exists();
        // The floor has no end, which ambient maps need; the others go on.
        JsonNode refused = json.path("techniques").path(2);
        assertThat(refused.path("refusal").asText()).contains("floor");
        assertThat(refused.path("runs")).isEmpty();
    }

    @Test
    void study_givenItsOwnReference_findsTheSame(@TempDir Path folder) throws IOException {
        Path scene = SmallScene.in(folder);
        Path first = folder.resolve("first");
        Path second = folder.resolve("second");
        study(scene, first, "--reference-rays", 40_000, "--threads", 1);
        study(scene, second, "--reference", first.resolve("reference.pfm"), "--threads", 3);

        ObjectMapper mapper = new ObjectMapper();
        JsonNode one = mapper.readTree(first.resolve("study.json").toFile()).path("techniques");
        JsonNode two = mapper.readTree(second.resolve("study.json").toFile()).path("techniques");
        for (int technique : new int[] {0, 1, 3}) {
            JsonNode a = one.path(technique).path("runs").path(1);
            JsonNode b = two.path(technique).path("runs").path(1);
            assertThat(b.path("lightRays")).isEqualTo(a.path("lightRays"));
            assertThat(b.path("rRMSE").asDouble()).isCloseTo(a.path("rRMSE").asDouble(), within(1e-6));
            assertThat(b.path("leastRRMSE").asDouble())
                    .isCloseTo(a.path("leastRRMSE").asDouble(), within(1e-6));
            assertThat(Files.readAllBytes(second.resolve(b.path("file").asText())))
                    .isEqualTo(Files.readAllBytes(first.resolve(a.path("file").asText())));
        }
    }

    @Test
    void study_givenAReferenceOfAnotherSize_isRefused(@TempDir Path folder) throws IOException {
        Path reference = folder.resolve("other.pfm");
        ImageFiles.write(new LinearImage(3, 3), org.diacaustic.image.Exposure.fixed(1), reference);
        refused(
                2,
                "the images differ in size",
                "study",
                SmallScene.in(folder),
                "-o",
                folder.resolve("out"),
                "--reference",
                reference,
                "--rays",
                100,
                "--techniques",
                "random-photons");
    }

    @Test
    void study_givenATime_takesAboutThatForTheReference(@TempDir Path folder) throws IOException {
        Path out = folder.resolve("out");
        Cli.Result result = Cli.run(
                "study",
                SmallScene.in(folder),
                "-o",
                out,
                "--reference-time",
                "0.1s",
                "--rays",
                100,
                "--techniques",
                "random-photons",
                "--size",
                "4x4");
        assertThat(result.code()).isZero();
        JsonNode reference =
                new ObjectMapper().readTree(out.resolve("study.json").toFile()).path("reference");
        assertThat(reference.path("batches").asInt()).isEqualTo(16);
        assertThat(reference.path("width").asInt()).isEqualTo(4);
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

    private static Cli.Result study(Path scene, Path out, Object... more) {
        Object[] fixed = {"study", scene, "-o", out, "--rays", "1000,4000", "--techniques", TECHNIQUES};
        Object[] all = java.util.Arrays.copyOf(fixed, fixed.length + more.length);
        System.arraycopy(more, 0, all, fixed.length, more.length);
        return Cli.run(all);
    }
}
