package org.diacaustic.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assumptions.assumeThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import org.diacaustic.image.Exposure;
import org.diacaustic.image.ImageFiles;
import org.diacaustic.image.LinearImage;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class RenderCommandTest {
    private static final ObjectMapper JSON = new ObjectMapper();

    @TempDir
    Path folder;

    private Path scene;
    private Path picture;

    @BeforeEach
    void writeScene() throws IOException {
        scene = SmallScene.in(folder);
        picture = folder.resolve("out.pfm");
    }

    private Cli.Result render(Object... more) {
        Object[] arguments = new Object[4 + more.length];
        arguments[0] = "render";
        arguments[1] = scene;
        arguments[2] = "-o";
        arguments[3] = picture;
        System.arraycopy(more, 0, arguments, 4, more.length);
        return Cli.run(arguments);
    }

    private byte[] rendered(Object... more) throws IOException {
        assertThat(render(more).code()).isZero();
        return Files.readAllBytes(picture);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
                    --threads -1        | diacaustic render: --threads must be at least 0, but is -1; see diacaustic render --help
                    --threads two       | diacaustic render: Invalid value for option '--threads': 'two' is not an int; see diacaustic render --help
                    --max-depth -1      | -D max-depth: settings.max-depth: expected a whole number of at least 0, found '-1'
                    --samples 0         | -D samples: settings.samples: expected a whole number of at least 1, found '0'
                    --exposure nan      | -D exposure: settings.exposure: expected a number above 0 or auto, found 'nan'
                    --exposure 0        | -D exposure: settings.exposure: expected a number above 0, found '0'
                    --size 3            | diacaustic render: Invalid value for option '--size': expected two whole numbers of at least 1, such as 640x480, found '3'; see diacaustic render --help
                    --size 0x0          | diacaustic render: Invalid value for option '--size': expected two whole numbers of at least 1, such as 640x480, found '0x0'; see diacaustic render --help
                    --size 9999999999x1 | diacaustic render: Invalid value for option '--size': a side has at most 2147483647 pixels, not 9999999999; see diacaustic render --help
                    --shader raytrace   | diacaustic: unknown shader 'raytrace'; known are auto, non-transparent, non-refractive
                    --map photon-map --shader non-refractive | diacaustic: shader 'non-refractive' lets light through glass straight, and map 'photon-map' brings it again: take shader 'non-transparent', or no map
                    --map ambient-maps  | diacaustic: 'floor' has no end and cannot have an ambient map of its own; use 'map: photon-map' instead
                    --preprocessor cubic | diacaustic: unknown preprocessor 'cubic'; known are auto, none, random, monte-carlo, planar, cube, adaptive, own-map
                    --map caustic-map   | -D map: settings.map: expected one of auto, none, ambient-maps, photon-map, caustic-mesh, found 'caustic-map'; did you mean 'caustic-mesh'?
                    --rays 0            | -D rays: settings.rays: expected a whole number from 1 to 1000000000000, found '0'
                    --sizes 3x3         | diacaustic render: Unknown options: '--sizes', '3x3'; did you mean '--size'?
                    -D fresnl=true      | -D fresnl: settings.fresnl: unknown key; did you mean 'fresnel'?
                    -D fresnel=yes      | -D fresnel: settings.fresnel: expected true or false, found 'yes', which is text in YAML 1.2
                    --progress loud     | diacaustic render: Invalid value for option '--progress': expected one of auto, plain, json, none, found 'loud'; see diacaustic render --help
                    """)
    void render_givenBadOption_saysWhyInOneLine(String options, String line) {
        Cli.Result result = render((Object[]) options.split(" "));
        assertThat(result.errorLines()).containsExactly(line);
        assertThat(result.code()).isEqualTo(2);
        assertThat(picture).doesNotExist();
    }

    @Test
    void render_givenSizeBeyondMemory_givesCode4() {
        Cli.Result result = render("--size", "100000x100000");
        assertThat(result.errorLines()).hasSize(1);
        assertThat(result.code()).isEqualTo(4);
    }

    @Test
    void render_givenMoreLightRaysThanFit_saysHowManyPhotonsItExpects() {
        Cli.Result result = render("--rays", "1000000000000", "--map", "photon-map");
        assertThat(result.errorLines()).hasSize(1);
        assertThat(result.err()).contains("photons are to be expected, but there is room for ");
        assertThat(result.code()).isEqualTo(4);
    }

    /** Modes hold back nobody who may do anything. */
    @Test
    void render_givenPictureThatMayNotBeWritten_leavesIt() throws IOException {
        Files.writeString(picture, "a year's work");
        assumeThat(picture.toFile().setWritable(false) && !Files.isWritable(picture))
                .isTrue();
        assertThat(render()).isEqualTo(failure(picture + ": is there already and may not be written"));
        assertThat(picture).hasContent("a year's work");
    }

    @Test
    void render_givenOneNameForTwoFiles_refuses() {
        Cli.Result result = render("--stats", picture);
        assertThat(result.errorLines()).hasSize(1);
        assertThat(result.errorLines().get(0)).contains("named for two files");
        assertThat(result.code()).isEqualTo(2);
        assertThat(picture).doesNotExist();
    }

    @Test
    void render_givenNoOutput_asksForIt() {
        Cli.Result result = Cli.run("render", scene);
        assertThat(result.errorLines())
                .containsExactly("diacaustic render: missing required option -o OUT; see diacaustic render --help");
        assertThat(result.code()).isEqualTo(2);
    }

    @Test
    void render_givenUnknownEnding_listsThoseKnown() {
        picture = folder.resolve("out.gif");
        Cli.Result result = render();
        assertThat(result.errorLines())
                .containsExactly("diacaustic: " + picture
                        + " has the unknown ending .gif; an image can be written as .png, .tga, .hdr, .pfm, .exr");
        assertThat(result.code()).isEqualTo(2);
    }

    @Test
    void render_givenTargetThatCannotBeWritten_saysSoBeforeReadingTheScene() throws IOException {
        Files.writeString(scene, "not a scene");
        picture = folder.resolve("none/out.png");
        assertThat(render()).isEqualTo(failure(folder.resolve("none") + ": the folder does not exist"));
        picture = Files.createDirectory(folder.resolve("folder.png"));
        assertThat(render()).isEqualTo(failure(picture + ": is a folder, not a file"));
        picture = scene.resolve("out.png");
        assertThat(render()).isEqualTo(failure(scene + ": is a file, not a folder"));
        picture = folder.resolve("out.png");
        assertThat(render("--stats", folder.resolve("none/s.json")))
                .isEqualTo(failure(folder.resolve("none") + ": the folder does not exist"));
    }

    /** A folder in which nobody may make a file, not even the superuser. */
    @Test
    void render_givenFolderThatTakesNoFiles_saysSoBeforeReadingTheScene() throws IOException {
        assumeThat(Path.of("/proc/self")).isDirectory();
        Files.writeString(scene, "not a scene");
        picture = Path.of("/proc/self/out.png");
        assertThat(render()).isEqualTo(failure("/proc/self: no file can be made in the folder"));
    }

    private static Cli.Result failure(String line) {
        return new Cli.Result(3, "", "diacaustic: " + line + System.lineSeparator());
    }

    @Test
    void render_givenAnyThreadCount_givesTheSameBits() throws IOException {
        byte[] alone = rendered("--threads", 1, "--samples", 4);
        for (int threads : new int[] {0, 2, 5, 1000}) {
            assertThat(rendered("--threads", threads, "--samples", 4))
                    .as("%d threads", threads)
                    .isEqualTo(alone);
        }
    }

    @Test
    void render_givenSeeds_givesDifferentPicturesThatRepeat() throws IOException {
        byte[] zero = rendered("--samples", 4, "--seed", 0);
        byte[] one = rendered("--samples", 4, "--seed", 1);
        byte[] minusOne = rendered("--samples", 4, "--seed", -1);
        assertThat(List.of(zero, one, minusOne)).doesNotHaveDuplicates();
        assertThat(zero).isNotEqualTo(one).isNotEqualTo(minusOne);
        assertThat(one).isNotEqualTo(minusOne);
        assertThat(rendered("--samples", 4)).as("1 is the default").isEqualTo(one);
        assertThat(rendered("--samples", 4, "--seed", 0)).isEqualTo(zero);
        assertThat(rendered("-D", "samples=4", "-D", "seed=-1")).isEqualTo(minusOne);
    }

    @Test
    void render_givenHugeDepthBetweenMirrors_neitherOverflowsNorHangs() throws IOException {
        Files.writeString(scene, """
                camera: {from: [0, 0, 0], to: [0, 0, 1], size: [2, 2]}
                materials: {mirror: {reflectivity: 0.999}}
                objects:
                  - plane: {at: [0, 0, 1], normal: [0, 0, -1], material: mirror}
                  - plane: {at: [0, 0, -1], normal: [0, 0, 1], material: mirror}
                """);
        // Rays end when they would carry less than 2^-12: 0.999^n < 2^-12 from n = 8314 on.
        Path stats = folder.resolve("s.json");
        assertThat(render("--max-depth", 1_000_000_000, "--stats", stats).code())
                .isZero();
        assertThat(JSON.readTree(stats.toFile()).at("/counters/reflectionRays").asLong())
                .isEqualTo(4 * 8313);
    }

    @Test
    void main_givenBareScene_rendersBesideIt() throws IOException {
        Path beside = folder.resolve("scene.png");
        assertThat(Cli.run(scene).code()).isZero();
        assertThat(ImageFiles.read(beside).width()).isEqualTo(20);
        assertThat(Cli.run(scene, "--size", "10x8").code())
                .as("over a picture of our own")
                .isZero();
        assertThat(ImageFiles.read(beside).width()).isEqualTo(10);
    }

    @Test
    void main_givenBareSceneBesideSomebodysPicture_leavesThatAlone() throws IOException {
        Path beside = Files.writeString(folder.resolve("scene.png"), "a year's work");
        Cli.Result result = Cli.run(scene);
        assertThat(result.code()).isEqualTo(3);
        assertThat(result.errorLines())
                .containsExactly("diacaustic: " + beside
                        + ": is there already and was not made by diacaustic; choose a name with -o");
        assertThat(beside).hasContent("a year's work");
        Files.delete(beside);
        java.awt.image.BufferedImage foreign = new java.awt.image.BufferedImage(1, 1, 1);
        javax.imageio.ImageIO.write(foreign, "png", beside.toFile());
        assertThat(Cli.run(scene).code()).isEqualTo(3);
    }

    @Test
    void main_givenWrongWords_advises() {
        assertThat(Cli.run("rendr", scene).err()).endsWith("did you mean 'render'?" + System.lineSeparator());
        assertThat(Cli.run().code()).isEqualTo(2);
        assertThat(Cli.run("--version").out()).startsWith("diacaustic ");
        for (String command : List.of("render", "plan", "check", "compare")) {
            Cli.Result help = Cli.run(command, "--help");
            assertThat(help.code()).isZero();
            assertThat(help.out()).startsWith("Usage: diacaustic " + command);
        }
    }

    @Test
    void render_givenPlainProgress_printsALinePerTenth() {
        Cli.Result result = render("--progress", "plain", "--size", "160x160");
        assertThat(result.errorLines()).hasSize(10).allMatch(line -> line.matches("\\d+ %, [0-9.]+ s left"));
        assertThat(result.errorLines().get(9)).startsWith("100 %");
    }

    @Test
    void render_givenJsonProgress_printsAnObjectALine() throws IOException {
        int before = 0;
        for (String line : render("--progress", "json", "--size", "160x160").errorLines()) {
            JsonNode progress = JSON.readTree(line);
            assertThat(progress.get("percent").asInt()).isGreaterThan(before);
            assertThat(progress.get("secondsLeft").asDouble()).isNotNegative();
            before = progress.get("percent").asInt();
        }
        assertThat(before).isEqualTo(100);
    }

    @ParameterizedTest
    @ValueSource(strings = {"none", "auto"})
    void render_givenNoProgressOrNobodyWatching_isQuiet(String kind) {
        Cli.Result result = render("--progress", kind);
        assertThat(result.err()).isEmpty();
        assertThat(result.out()).startsWith(picture + ": 20 x 16, linear radiance, ");
    }

    @Test
    void render_givenStats_writesEveryMember() throws IOException {
        Path stats = folder.resolve("s.json");
        render("--stats", stats, "--threads", 2, "--seed", Long.MIN_VALUE);
        JsonNode root = JSON.readTree(stats.toFile());
        assertThat(root.get("seed").asLong()).isEqualTo(Long.MIN_VALUE);
        assertThat(root.get("threads").asInt()).isEqualTo(2);
        assertThat(root.get("complete").asBoolean()).isTrue();
        assertThat(root.get("errorEstimate").asDouble()).isPositive();
        assertThat(root.get("noiseEstimate").isNull()).isTrue();
        assertMembers(root.get("plan"), "used", "leftOut");
        assertMembers(root.get("seconds"), "parse", "plan", "preprocess", "build", "render", "write");
        assertMembers(root.get("energy"), "emitted", "stored", "absorbed", "escaped", "cut");
        assertMembers(root.get("memory"), "mapBytes", "bytesPerCell", "peakHeapBytes");
        assertMembers(
                root.get("counters"),
                "eyeRays",
                "shadowRays",
                "reflectionRays",
                "refractionRays",
                "intersectionTests",
                "lightRays",
                "objectIntersections",
                "stored",
                "nodesExamined",
                "photonsUsed",
                "cells",
                "plannedLightRays");
        assertThat(root.at("/counters/eyeRays").asInt()).isEqualTo(20 * 16);
        assertThat(root.at("/memory/peakHeapBytes").asLong()).isPositive();
    }

    private static void assertMembers(JsonNode object, String... names) {
        assertThat(object.fieldNames()).toIterable().contains(names);
    }

    @Test
    void render_givenGermanLocale_writesTheSameNumbers() throws IOException {
        Locale before = Locale.getDefault();
        try {
            Locale.setDefault(Locale.GERMANY);
            Path stats = folder.resolve("s.json");
            picture = folder.resolve("out.png");
            Cli.Result result = render("--stats", stats, "--exposure", "1.5", "--progress", "json");
            assertThat(result.out()).contains("exposure 1.50000");
            assertThat(JSON.readTree(stats.toFile()).get("exposure").asDouble()).isEqualTo(1.5);
            assertThat(JSON.readTree(result.errorLines().get(0)).has("secondsLeft"))
                    .isTrue();
        } finally {
            Locale.setDefault(before);
        }
    }

    @Test
    void plan_givenScene_saysWhatRunsAndWhy() throws IOException {
        Cli.Result text = Cli.run("plan", scene, "--samples", 4);
        assertThat(text.code()).isZero();
        assertThat(text.out().lines())
                .allMatch(line -> line.matches("(uses |omits) [a-z -]+: .+ \\(.+\\)"))
                .contains("uses  supersampling: 4 rays a pixel (asked for)");
        JsonNode json = JSON.readTree(Cli.run("plan", scene, "--json").out());
        assertThat(json.get("used").get(0).get("part").asText()).isEqualTo("preprocessor");
        assertThat(json.get("used").size() + json.get("leftOut").size())
                .isEqualTo((int) text.out().lines().count());
    }

    /** What the forward pass did, or zeros if there was none. */
    @Test
    void render_givenStatistics_countsTheForwardPass() throws IOException {
        Path file = folder.resolve("stats.json");
        assertThat(render("--stats", file, "--preprocessor", "cube", "--map", "photon-map")
                        .code())
                .isZero();
        JsonNode stats = JSON.readTree(file.toFile());
        assertThat(stats.at("/counters/primaryLightRays").asLong()).isBetween(1800L, 2200L);
        assertThat(stats.at("/counters/lightRays").asLong())
                .isGreaterThan(stats.at("/counters/primaryLightRays").asLong());
        assertThat(stats.at("/counters/stored").asLong()).isPositive();
        assertThat(stats.at("/counters/photonsUsed").asLong()).isPositive();
        assertThat(stats.at("/memory/mapBytes").asLong()).isPositive();
        JsonNode energy = stats.get("energy");
        double emitted = energy.get("emitted").asDouble();
        double found = 0;
        for (String part : List.of("stored", "absorbed", "escaped", "cut")) {
            found += energy.get(part).asDouble();
        }
        assertThat(emitted).isPositive();
        assertThat(Math.abs(emitted - found)).isLessThan(1e-12 * emitted);

        assertThat(render("--stats", file, "--map", "none").code()).isZero();
        JsonNode none = JSON.readTree(file.toFile());
        for (String zero : List.of("counters/lightRays", "counters/stored", "memory/mapBytes", "energy/emitted")) {
            assertThat(none.at("/" + zero).asDouble()).as(zero).isZero();
        }
    }

    @Test
    void compare_givenEqualPictures_givesZeros() throws IOException {
        rendered();
        Path difference = folder.resolve("diff.png");
        Cli.Result text = Cli.run("compare", picture, picture, "-o", difference);
        assertThat(text.code()).isZero();
        assertThat(text.out()).containsPattern("rRMSE +0.00000\n").containsPattern("pixels +320\n");
        assertThat(ImageFiles.read(difference).width()).isEqualTo(20);
        JsonNode json =
                JSON.readTree(Cli.run("compare", picture, picture, "--json").out());
        for (String metric : List.of("rRMSE", "relMAE", "relMSE", "relMSE99.9", "worstBlock", "largest", "bias")) {
            assertThat(json.get(metric).asDouble(1)).as(metric).isZero();
        }
    }

    @Test
    void compare_givenPicturesThatCannotBeCompared_saysWhy() throws IOException {
        rendered();
        Path small = folder.resolve("small.pfm");
        ImageFiles.write(new LinearImage(2, 2), Exposure.fixed(1), small);
        Cli.Result sizes = Cli.run("compare", picture, small);
        assertThat(sizes.code()).isEqualTo(2);
        assertThat(sizes.errorLines()).hasSize(1);
        assertThat(sizes.err()).contains("differ in size").contains("20 x 16").contains("2 x 2");
        Cli.Result text = Cli.run("compare", picture, scene);
        assertThat(text.code()).isEqualTo(3);
        assertThat(text.errorLines()).hasSize(1);
        Cli.Result missing = Cli.run("compare", picture, folder.resolve("none.png"));
        assertThat(missing.code()).isEqualTo(3);
        assertThat(missing.errorLines())
                .containsExactly("diacaustic: " + folder.resolve("none.png") + ": there is no such file");
    }
}
