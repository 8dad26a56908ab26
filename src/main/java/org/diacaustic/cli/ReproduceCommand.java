package org.diacaustic.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.Locale;
import java.util.Set;
import java.util.concurrent.Callable;
import org.diacaustic.reproduction.Reproduction;
import org.diacaustic.reproduction.ReproductionReport;
import org.diacaustic.reproduction.ThesisScene;
import picocli.CommandLine.Command;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;
import picocli.CommandLine.TypeConversionException;

/** {@code reproduce}: the tables and figures of the thesis, rendered again. */
@Command(
        name = "reproduce",
        mixinStandardHelpOptions = true,
        versionProvider = Version.class,
        description = {
            "Renders the scenes of the thesis with each of its techniques.",
            "Writes its Tables 3 to 14 beside ours, its Figures 4 to 33, and a verdict on what it concludes: DIR/reproduction.html,"
                    + " the same as .json, pictures and scenes."
        })
final class ReproduceCommand implements Callable<Integer> {
    @Spec
    private picocli.CommandLine.Model.CommandSpec spec;

    @Option(
            names = {"-o", "--output"},
            paramLabel = "DIR",
            required = true,
            description = "Folder for what is written; made if it is not there.")
    private Path output;

    @Option(
            names = "--scene",
            paramLabel = "S",
            converter = SceneConverter.class,
            description = "control, refraction or complex; all if it is not given.")
    private ThesisScene scene;

    @Option(names = "--quick", description = "Few seeds: minutes become seconds, spreads are rough.")
    private boolean quick;

    @Option(
            names = "--seed",
            paramLabel = "N",
            defaultValue = "1",
            description = "First seed (default: ${DEFAULT-VALUE}).")
    private long seed;

    @Option(names = "--threads", paramLabel = "N", description = "Threads; 0 for all cores (default).")
    private int threads;

    @Option(
            names = "--progress",
            paramLabel = "KIND",
            converter = ProgressKind.Converter.class,
            defaultValue = "auto",
            description = "auto, plain, json, none (default: ${DEFAULT-VALUE}).")
    private ProgressKind progress;

    @Option(names = "--debug", description = "Show a stack trace when something fails.")
    private boolean debug;

    @Override
    public Integer call() throws IOException {
        if (threads < 0) {
            throw new ParameterException(spec.commandLine(), "--threads must be at least 0, but is " + threads);
        }
        OutputFolder.make(output, "reproduction.html");
        Set<ThesisScene> scenes = scene == null ? EnumSet.allOf(ThesisScene.class) : EnumSet.of(scene);
        int seeds = quick ? Reproduction.QUICK_SEEDS : Reproduction.SEEDS;
        int workers = threads == 0 ? Runtime.getRuntime().availableProcessors() : threads;
        ReproductionReport report = new Reproduction(scenes, seed, seeds).run(workers, progress.listener(System.err));
        System.out.println(report.write(output) + ": " + report.summary());
        return ExitCode.DONE;
    }

    /** Reads a scene as it is written on the command line. */
    static final class SceneConverter implements ITypeConverter<ThesisScene> {
        @Override
        public ThesisScene convert(String text) {
            for (ThesisScene scene : ThesisScene.values()) {
                if (scene.key().equals(text)) {
                    return scene;
                }
            }
            throw new TypeConversionException(
                    "expected one of control, refraction, complex, found '" + text.toLowerCase(Locale.ROOT) + "'");
        }
    }
}
