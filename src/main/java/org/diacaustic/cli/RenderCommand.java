package org.diacaustic.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import org.diacaustic.image.Exposure;
import org.diacaustic.image.ImageFiles;
import org.diacaustic.image.ImageFormat;
import org.diacaustic.image.LinearImage;
import org.diacaustic.render.Refined;
import org.diacaustic.render.RenderPlan;
import org.diacaustic.render.Rendering;
import org.diacaustic.scenefile.SceneFile;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** {@code render}: a scene file becomes a picture. */
@Command(
        name = "render",
        mixinStandardHelpOptions = true,
        versionProvider = Version.class,
        description = "Renders a scene file to a picture.")
final class RenderCommand implements Callable<Integer> {
    /** What {@code diacaustic SCENE} adds: the picture goes beside the scene, over none but our own. */
    static final String BESIDE = "--beside";

    @Spec
    private picocli.CommandLine.Model.CommandSpec spec;

    @Mixin
    private SceneOptions options;

    @Mixin
    private GoalOptions goals;

    @Option(
            names = {"-o", "--output"},
            paramLabel = "OUT",
            description = "Picture: .png .tga .hdr .pfm .exr")
    private Path output;

    @Option(names = BESIDE, hidden = true)
    private boolean beside;

    @Option(names = "--threads", paramLabel = "N", description = "Threads; 0 for all cores (default).")
    private int threads;

    @Option(names = "--stats", paramLabel = "FILE", description = "Write statistics as JSON.")
    private Path stats;

    @Option(
            names = "--error-picture",
            paramLabel = "FILE",
            description = "Write the estimated error of each pixel as a picture.")
    private Path errorPicture;

    @Option(
            names = "--progress",
            paramLabel = "KIND",
            converter = ProgressKind.Converter.class,
            defaultValue = "auto",
            description = "auto, plain, json, none (default: ${DEFAULT-VALUE}).")
    private ProgressKind progress;

    private final ProcessTime time;

    /** @param time by which the process is measured */
    RenderCommand(ProcessTime time) {
        this.time = time;
    }

    @Override
    public Integer call() throws IOException {
        if (threads < 0) {
            throw new ParameterException(spec.commandLine(), "--threads must be at least 0, but is " + threads);
        }
        goals.refusePasses(options, spec);
        Path picture = picture();
        ImageFiles.checkWritable(picture);
        requireDifferent(picture);
        if (stats != null) {
            StatisticsFile.checkWritable(stats);
        }
        if (errorPicture != null) {
            ImageFiles.checkWritable(errorPicture);
        }
        Stopwatch watch = new Stopwatch();
        SceneFile scene = options.read();
        watch.lap("parse");
        RenderPlan plan = RenderPlan.of(scene.scene(), scene.settings());
        watch.lap("plan");
        int workers = threads == 0 ? Runtime.getRuntime().availableProcessors() : threads;
        RenderWork work =
                RenderWork.of(plan, goals.goal(time, scene.scene().camera()), workers, progress.listener(System.err));
        ImageFormat.of(picture)
                .checkSize(
                        scene.scene().camera().width(), scene.scene().camera().height());
        Interruption interruption = Interruption.cancelling(work.cancel());
        try {
            Refined refined = work.run().get();
            watch.lap("render");
            save(refined, picture, watch);
            return refined.shortfall().isPresent() ? ExitCode.LIMIT : ExitCode.DONE;
        } finally {
            interruption.saved();
        }
    }

    private void save(Refined refined, Path picture, Stopwatch watch) throws IOException {
        Rendering rendering = refined.rendering();
        Path target = rendering.isComplete() ? picture : partialName(picture);
        Exposure exposure = exposure(refined.plan(), rendering);
        ImageFiles.write(rendering.image(), exposure, target);
        watch.lap("write");
        RenderReport.print(refined, exposure, target, watch.total());
        if (errorPicture != null) {
            writeErrorPicture(rendering, exposure);
        }
        if (stats != null) {
            StatisticsFile.write(stats, refined, exposure, watch);
        }
    }

    private void writeErrorPicture(Rendering rendering, Exposure exposure) throws IOException {
        LinearImage picture = rendering
                .errorPicture()
                .orElseThrow(() -> new CommandFailure(
                        ExitCode.BAD_INPUT, "--error-picture needs map 'caustic-mesh': no other tells its error"));
        ImageFiles.write(picture, exposure, errorPicture);
    }

    /** Refuses to write the picture, the statistics and the scene over each other. */
    private void requireDifferent(Path picture) {
        List<Path> files = new ArrayList<>(List.of(options.path(), picture));
        if (stats != null) {
            files.add(stats);
        }
        if (errorPicture != null) {
            files.add(errorPicture);
        }
        for (int i = 1; i < files.size(); i++) {
            for (Path other : files.subList(0, i)) {
                if (files.get(i)
                        .toAbsolutePath()
                        .normalize()
                        .equals(other.toAbsolutePath().normalize())) {
                    throw new ParameterException(spec.commandLine(), files.get(i) + " is named for two files at once");
                }
            }
        }
    }

    private Path picture() throws IOException {
        if (output != null) {
            return output;
        }
        if (!beside) {
            throw new ParameterException(spec.commandLine(), "missing required option -o OUT");
        }
        Path picture = Path.of(options.path().toString().replaceFirst("\\.[^.]*$", "") + ".png");
        if (Files.exists(picture) && !ImageFiles.isOurs(picture)) {
            throw new CommandFailure(
                    ExitCode.FILE,
                    picture + ": is there already and was not made by diacaustic; choose a name with -o");
        }
        return picture;
    }

    /** OUT.partial.png for OUT.png: a picture that was interrupted never takes the place of a whole one. */
    private static Path partialName(Path picture) {
        return Path.of(picture.toString().replaceFirst("(\\.[^.]*)$", ".partial$1"));
    }

    private static Exposure exposure(RenderPlan plan, Rendering rendering) {
        return plan.settings().isExposureAutomatic()
                ? Exposure.auto(rendering.image())
                : Exposure.fixed(plan.settings().exposure());
    }
}
