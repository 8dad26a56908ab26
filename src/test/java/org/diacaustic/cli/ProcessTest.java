package org.diacaustic.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assumptions.assumeThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.diacaustic.image.Exposure;
import org.diacaustic.image.ImageFiles;
import org.diacaustic.image.LinearImage;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What only a process of its own shows: signals, closed streams, exit codes, two writers of one file. */
class ProcessTest {
    private static final String JAVA =
            Path.of(System.getProperty("java.home"), "bin", "java").toString();
    private static final Duration PATIENCE = Duration.ofSeconds(60);
    /** Enough samples a pixel for hours. */
    private static final String ENDLESS = "1000000000";

    @TempDir
    Path folder;

    private Path scene;
    private Path errors;

    @BeforeEach
    void writeScene() throws IOException {
        scene = SmallScene.in(folder);
        errors = folder.resolve("errors.txt");
    }

    private static List<String> command(Object... arguments) {
        List<String> command = new ArrayList<>(List.of(
                JAVA, "-XX:TieredStopAtLevel=1", "-cp", System.getProperty("java.class.path"), Main.class.getName()));
        for (Object argument : arguments) {
            command.add(argument.toString());
        }
        return command;
    }

    private Process start(List<String> command) throws IOException {
        return new ProcessBuilder(command)
                .redirectError(errors.toFile())
                .redirectOutput(folder.resolve("output.txt").toFile())
                .start();
    }

    private static int exitCode(Process process) throws InterruptedException {
        try {
            assertThat(process.waitFor(PATIENCE.toSeconds(), TimeUnit.SECONDS))
                    .as("ends")
                    .isTrue();
            return process.exitValue();
        } finally {
            process.destroyForcibly();
        }
    }

    /** Waits until the render is on its way: a tenth of it has been reported. */
    private void awaitProgress() throws Exception {
        long start = System.nanoTime();
        while (Files.size(errors) == 0) {
            assertThat(System.nanoTime() - start).isLessThan(PATIENCE.toNanos());
            Thread.sleep(20);
        }
    }

    private List<String> files() throws IOException {
        try (Stream<Path> names = Files.list(folder)) {
            return names.map(path -> path.getFileName().toString()).sorted().toList();
        }
    }

    @ParameterizedTest
    @CsvSource({"INT, 130", "TERM, 143"})
    void render_givenSignal_savesWhatThereIsUnderAnotherName(String signal, int code) throws Exception {
        assumeThat(File.separatorChar).isEqualTo('/');
        Path picture = folder.resolve("out.png");
        // 400 tiles of 256 pixels: a tenth takes about a second, the whole ten.
        Process process = start(
                command("render", scene, "-o", picture, "--size", "320x320", "--samples", 400, "--progress", "plain"));
        awaitProgress();
        long start = System.nanoTime();
        new ProcessBuilder("kill", "-" + signal, Long.toString(process.pid()))
                .start()
                .waitFor();
        assertThat(exitCode(process)).isEqualTo(code);
        assertThat(Duration.ofNanos(System.nanoTime() - start)).isLessThan(Duration.ofSeconds(2));
        assertThat(files()).containsExactly("errors.txt", "out.partial.png", "output.txt", "scene.yaml");
        LinearImage saved = ImageFiles.read(folder.resolve("out.partial.png"));
        assertThat(saved.width()).isEqualTo(320);
        double sum = 0;
        for (float sample : saved.samples()) {
            sum += sample;
        }
        assertThat(sum).as("light in what is rendered").isPositive();
        assertThat(Files.readString(errors))
                .containsPattern("diacaustic: interrupted; saved \\d+ % of the picture as .*out.partial.png");
    }

    @Test
    void render_givenSignalInALaterRound_savesTheLastWholePicture() throws Exception {
        assumeThat(File.separatorChar).isEqualTo('/');
        Path picture = folder.resolve("out.png");
        Process process = start(command("render", scene, "-o", picture, "--error", "1e-15", "--progress", "plain"));
        long start = System.nanoTime();
        while (!Files.readString(errors).contains("100 %")) {
            assertThat(System.nanoTime() - start).isLessThan(PATIENCE.toNanos());
            Thread.sleep(20);
        }
        // Rounds follow until a thousand million rays, so it is in one of them, and says at least which.
        process.destroy();
        assertThat(exitCode(process)).isEqualTo(143);
        assertThat(files()).containsExactly("errors.txt", "out.png", "output.txt", "scene.yaml");
        assertThat(Files.readString(errors)).containsPattern("error of .* is reached: it was cancelled");
        assertThat(Files.readString(folder.resolve("output.txt"))).contains("error about ");
    }

    @Test
    void study_givenSignal_savesItsPointsAndSaysThatTheyAreNotAll() throws Exception {
        assumeThat(File.separatorChar).isEqualTo('/');
        Path out = folder.resolve("out");
        // The second budget is one for minutes.
        Process process = start(command(
                "study",
                scene,
                "-o",
                out,
                "--size",
                "40x40",
                "--methods",
                "random-nearest",
                "--budgets",
                "100,1000000000",
                "--seeds",
                3,
                "--reference-rays",
                4000,
                "--no-cold"));
        Path first = out.resolve("points/random-nearest@100.json");
        long start = System.nanoTime();
        while (!Files.exists(first)) {
            assertThat(System.nanoTime() - start).isLessThan(PATIENCE.toNanos());
            Thread.sleep(20);
        }
        new ProcessBuilder("kill", "-INT", Long.toString(process.pid())).start().waitFor();
        assertThat(exitCode(process)).isEqualTo(130);
        assertThat(Files.readString(errors)).contains("interrupted; 1 of 2 points are kept");
        assertThat(Files.readString(out.resolve("study.html"))).contains("partial: 1 of 2 points");
        assertThat(out.resolve("points/random-nearest@1000000000.json")).doesNotExist();
    }

    @Test
    void render_givenTime_endsTheProcessInTime() throws Exception {
        Path picture = folder.resolve("out.png");
        long start = System.nanoTime();
        Process process = start(command("render", scene, "-o", picture, "--time", "3s"));
        assertThat(exitCode(process)).isZero();
        // A tenth more at most, and what a busy machine takes to start a process and to see its end.
        assertThat(Duration.ofNanos(System.nanoTime() - start)).isLessThan(Duration.ofMillis(3300 + 700));
        assertThat(ImageFiles.read(picture).width()).isEqualTo(20);
    }

    @Test
    void render_givenErrorAndLittleMemory_saysThatMoreRaysDoNotFit() throws Exception {
        Path picture = folder.resolve("out.png");
        List<String> command = command("render", scene, "-o", picture, "--error", "1e-9");
        command.add(1, "-Xmx40m");
        assertThat(exitCode(start(command))).isEqualTo(4);
        assertThat(ImageFiles.read(picture).width()).isEqualTo(20);
        assertThat(Files.readString(errors)).contains("more light rays do not fit in memory");
    }

    @Test
    void render_givenSignalWithinTheFirstPixel_stopsAsSoon() throws Exception {
        assumeThat(File.separatorChar).isEqualTo('/');
        Process process = start(command("render", scene, "-o", folder.resolve("out.pfm"), "--samples", ENDLESS));
        Thread.sleep(1500);
        long start = System.nanoTime();
        process.destroy();
        assertThat(exitCode(process)).isEqualTo(143);
        assertThat(Duration.ofNanos(System.nanoTime() - start)).isLessThan(Duration.ofSeconds(2));
        assertThat(files()).contains("out.partial.pfm").doesNotContain("out.pfm");
    }

    @Test
    void render_givenFailure_exitsWithItsCodeWhileTheHookIsThere() throws Exception {
        assertThat(exitCode(start(command("render", scene, "-o", folder.resolve("none/out.png")))))
                .isEqualTo(3);
        assertThat(exitCode(start(command("render", scene, "--size", "0x0", "-o", folder.resolve("out.png")))))
                .isEqualTo(2);
        assertThat(exitCode(start(command("render", scene, "-o", folder.resolve("out.png")))))
                .isZero();
    }

    @Test
    void render_givenTooLittleMemory_saysSoInOneLine() throws Exception {
        // 12 bytes a pixel: 48 MB.
        ImageFiles.write(new LinearImage(2000, 2000), Exposure.fixed(1), folder.resolve("large.png"));
        SmallScene.in(folder, "diffuse: 0.5", "diffuse: {image: {file: large.png}}");
        List<String> command = command("render", scene, "-o", folder.resolve("out.png"));
        command.add(1, "-Xmx16m");
        assertThat(exitCode(start(command))).isEqualTo(4);
        assertThat(Files.readAllLines(errors)).hasSize(1);
        assertThat(Files.readString(errors)).startsWith("diacaustic: out of memory");
    }

    @Test
    void render_givenClosedStreams_writesThePictureAllTheSame() throws Exception {
        assumeThat(File.separatorChar).isEqualTo('/');
        Path picture = folder.resolve("out.png");
        String words = String.join(" ", command("render", scene, "-o", picture, "--progress", "plain"));
        Process process = start(List.of("sh", "-c", words + " >&- 2>&-"));
        assertThat(exitCode(process)).isZero();
        assertThat(ImageFiles.read(picture).width()).isEqualTo(20);
    }

    @Test
    void render_givenTwoProcessesAndOneFile_leavesAWholePicture() throws Exception {
        Path picture = folder.resolve("out.png");
        List<String> command = command("render", scene, "-o", picture, "--size", "200x160");
        Process first = start(command);
        Process second = start(command);
        assertThat(exitCode(first)).isZero();
        assertThat(exitCode(second)).isZero();
        assertThat(ImageFiles.read(picture).width()).isEqualTo(200);
        assertThat(files()).containsExactly("errors.txt", "out.png", "output.txt", "scene.yaml");
    }

    @Test
    void render_givenGermanUser_writesJsonAllTheSame() throws Exception {
        Path stats = folder.resolve("stats.json");
        List<String> command = command("render", scene, "-o", folder.resolve("out.png"), "--stats", stats);
        command.add(1, "-Duser.language=de");
        command.add(1, "-Duser.country=DE");
        assertThat(exitCode(start(command))).isZero();
        JsonNode root = new ObjectMapper().readTree(stats.toFile());
        assertThat(root.at("/seconds/render").isDouble()).isTrue();
        assertThat(Files.readString(folder.resolve("output.txt")))
                .containsPattern("exposure \\d+\\.\\d+, \\d+\\.\\d+ s");
    }
}
