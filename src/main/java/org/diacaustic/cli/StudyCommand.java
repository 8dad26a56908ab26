package org.diacaustic.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import org.diacaustic.page.StudyPage;
import org.diacaustic.study.Budget;
import org.diacaustic.study.CellsChart;
import org.diacaustic.study.Machine;
import org.diacaustic.study.Reference;
import org.diacaustic.study.SceneSource;
import org.diacaustic.study.Study;
import org.diacaustic.study.StudyFolder;
import org.diacaustic.study.StudyReport;
import org.diacaustic.study.StudyRequest;
import org.diacaustic.study.Technique;
import org.diacaustic.study.Techniques;
import org.diacaustic.study.WaterSheetScene;
import picocli.CommandLine.Command;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;
import picocli.CommandLine.TypeConversionException;

/** {@code study}: error against run time, for every technique on one scene. */
@Command(
        name = "study",
        mixinStandardHelpOptions = true,
        versionProvider = Version.class,
        description = {
            "Renders a scene with every technique, with several budgets and seeds, and holds each picture against a reference.",
            "Writes DIR/study.html, which needs nothing else, and the same as JSON and CSV. A study that was stopped goes on where it was."
        })
final class StudyCommand implements Callable<Integer> {
    private static final List<Budget> BUDGETS = rays(3000, 10_000, 30_000, 100_000, 300_000);
    private static final List<Budget> QUICK_BUDGETS = rays(3000, 30_000, 300_000);
    private static final int QUICK_SEEDS = 5;
    private static final PixelSize QUICK_SIZE = new PixelSize(100, 100);

    @Spec
    private picocli.CommandLine.Model.CommandSpec spec;

    @Mixin
    private SceneInput input;

    @Option(
            names = {"-o", "--output"},
            paramLabel = "DIR",
            description = "Folder for what is written; made if it is not there.")
    private Path output;

    @Option(
            names = "--methods",
            paramLabel = "M",
            converter = TechniquesConverter.class,
            description =
                    "Techniques, with commas between them: names such as planar-nearest, planar-* for several, or NAME:key=value:key=value"
                            + " with keys of the scene's settings.")
    private List<Technique> methods;

    @Option(
            names = "--budgets",
            paramLabel = "B",
            converter = BudgetsConverter.class,
            description =
                    "What a picture may cost: light rays, or seconds, such as 3000,30000 or 1s,5s (default: 3000 to 300000 light rays).")
    private List<Budget> budgets;

    @Option(
            names = "--seeds",
            paramLabel = "N",
            description = "Pictures of a cheap point, each with a seed of its own (default: 20; fewer of dear ones).")
    private Integer seeds;

    @Option(
            names = "--quick",
            description =
                    "Eight techniques, three budgets, five seeds, 100 x 100 pixels, unless something else is said.")
    private boolean quick;

    @Mixin
    private ReferenceOptions referenceOptions;

    @Option(names = "--restart", description = "Forget what DIR holds of the study, and begin again.")
    private boolean restart;

    @Option(names = "--no-cold", description = "Do not time whole processes.")
    private boolean noCold;

    @Option(
            names = "--write-scenes",
            paramLabel = "DIR",
            help = true,
            description =
                    "Writes scenes that are too large to be kept with the others into a folder, and does no more.")
    private Path scenes;

    @Option(
            names = "--cells",
            paramLabel = "N",
            description =
                    "Draws a caustic mesh of about so many light rays, such as 500, as DIR/cells.svg, and does no more.")
    private Long cellRays;

    @Option(names = "--threads", paramLabel = "N", description = "Threads; 0 for all cores (default).")
    private int threads;

    @Option(
            names = "--progress",
            paramLabel = "KIND",
            converter = ProgressKind.Converter.class,
            defaultValue = "auto",
            description = "auto, plain, json, none (default: ${DEFAULT-VALUE}).")
    private ProgressKind progress;

    private static List<Budget> rays(long... counts) {
        return Arrays.stream(counts).<Budget>mapToObj(Budget.Rays::new).toList();
    }

    @Override
    public Integer call() throws IOException {
        if (scenes != null) {
            OutputFolder.refuseFile(scenes);
            System.out.println(WaterSheetScene.write(scenes) + ": written, with its mesh beside it");
            return ExitCode.DONE;
        }
        checkOptions();
        OutputFolder.refuseFile(output);
        if (quick) {
            input.proposeSize(QUICK_SIZE);
        }
        input.read(Map.of());
        if (cellRays != null) {
            System.out.println(CellsChart.write(input::readAgain, cellRays, workers(), output) + ": written");
            return ExitCode.DONE;
        }
        return study();
    }

    private Integer study() throws IOException {
        StudyRequest request = request();
        for (Technique technique : request.techniques()) {
            input.readAgain(technique.overrides());
        }
        SceneSource source = input::readAgain;
        Study.requireComparable(source);
        OutputFolder.make(output, "study.html");
        StudyFolder folder = StudyFolder.open(output, identity(request), restart);
        Optional<Reference> kept = folder.reference();
        Optional<Reference> reference = kept.isPresent()
                ? kept
                : referenceOptions.make(source, workers(), quick, progress.listener(System.err), folder);
        if (reference.isEmpty()) {
            System.err.println("diacaustic: interrupted before the reference was whole; nothing is kept");
            return ExitCode.LIMIT;
        }
        Study study = new Study(source, request, reference.get(), folder);
        ColdProcesses cold = new ColdProcesses(input, workers());
        Interruption interruption = Interruption.cancelling(() -> {
            study.cancel();
            cold.cancel();
        });
        try {
            StudyReport report = study.run(progress.listener(System.err));
            if (report.isComplete() && !noCold) {
                List<Budget> asked = request.budgets();
                report = report.with(cold.time(report, asked.get(asked.size() / 2), progress.listener(System.err)));
            }
            report.write(folder);
            Path page = StudyPage.write(report, folder);
            System.out.print(report.table());
            System.out.println(page + ": written, " + report.points() + " of " + report.pointsPlanned() + " points");
            if (!report.isComplete()) {
                System.err.println("diacaustic: interrupted; " + report.points() + " of " + report.pointsPlanned()
                        + " points are kept, and the same command goes on from there");
            }
            return report.isComplete() ? ExitCode.DONE : ExitCode.LIMIT;
        } finally {
            interruption.saved();
        }
    }

    private StudyRequest request() {
        List<Technique> techniques = methods != null ? methods : quick ? Techniques.quick() : Techniques.known();
        int pictures = seeds != null ? seeds : quick ? QUICK_SEEDS : StudyRequest.SEEDS;
        return new StudyRequest(
                String.valueOf(input.path().getFileName()),
                command(),
                Machine.here(new Version().getVersion()[0]),
                techniques,
                budgets != null ? budgets : quick ? QUICK_BUDGETS : BUDGETS,
                pictures,
                workers());
    }

    /** The command as it was given. */
    private String command() {
        return "java -jar diacaustic.jar "
                + spec.commandLine().getParent().getParseResult().originalArgs().stream()
                        .map(word ->
                                word.matches("[A-Za-z0-9_./:=,*+-]+") ? word : "'" + word.replace("'", "'\\''") + "'")
                        .collect(Collectors.joining(" "));
    }

    /** All that the numbers of a point depend on. */
    private Map<String, String> identity(StudyRequest request) throws IOException {
        Map<String, String> identity = new LinkedHashMap<>();
        identity.put("program", request.machine().program());
        identity.put("java", request.machine().java());
        identity.put("processor", request.machine().processor());
        identity.put("scene", Digest.of(input.path()));
        identity.put("options", String.join(" ", input.optionTexts()));
        identity.put("reference", referenceOptions.text(quick));
        identity.put("seeds", Integer.toString(request.seeds()));
        identity.put("threads", Integer.toString(request.threads()));
        return identity;
    }

    private int workers() {
        return threads == 0 ? Runtime.getRuntime().availableProcessors() : threads;
    }

    private void checkOptions() throws IOException {
        if (output == null) {
            throw new ParameterException(spec.commandLine(), "missing required option -o DIR");
        }
        if (threads < 0) {
            throw new ParameterException(spec.commandLine(), "--threads must be at least 0, but is " + threads);
        }
        if (cellRays != null && cellRays < 1) {
            throw new ParameterException(spec.commandLine(), "--cells must be at least 1, but is " + cellRays);
        }
        if (seeds != null && seeds < 1) {
            throw new ParameterException(spec.commandLine(), "--seeds must be at least 1, but is " + seeds);
        }
        referenceOptions.check(spec);
    }

    /** Reads a list of techniques. */
    static final class TechniquesConverter implements ITypeConverter<List<Technique>> {
        @Override
        public List<Technique> convert(String text) {
            try {
                return Techniques.parse(text);
            } catch (IllegalArgumentException wrong) {
                throw new TypeConversionException(wrong.getMessage());
            }
        }
    }
}
