package org.diacaustic.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import org.diacaustic.image.WholeFile;
import org.diacaustic.scene.Scene;
import org.diacaustic.scenefile.FileScope;
import org.diacaustic.scenefile.Problems;
import org.diacaustic.scenefile.SceneDocument;
import org.diacaustic.scenefile.SceneFile;
import org.diacaustic.scenefile.SceneReader;
import org.diacaustic.study.CellsChart;
import org.diacaustic.study.Reference;
import org.diacaustic.study.ReferenceBudget;
import org.diacaustic.study.ReferenceRender;
import org.diacaustic.study.SceneSource;
import org.diacaustic.study.Study;
import org.diacaustic.study.StudyReport;
import org.diacaustic.study.Technique;
import org.diacaustic.study.Techniques;
import org.diacaustic.study.WaterSheetScene;
import picocli.CommandLine.Command;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import picocli.CommandLine.TypeConversionException;

/** {@code study}: error against light rays and time, for several techniques on one scene. */
@Command(
        name = "study",
        mixinStandardHelpOptions = true,
        versionProvider = Version.class,
        description = {
            "Renders a scene with several techniques and numbers of light rays, and holds each picture against a reference.",
            "Counts pixels that show one diffuse object and nothing else. The reference is light traced straight into the"
                    + " pixels, without any map, unless one is given. Writes DIR/study.json and the pictures."
        })
final class StudyCommand implements Callable<Integer> {
    private static final ReferenceBudget DEFAULT_REFERENCE = new ReferenceBudget.Seconds(60);

    @Spec
    private picocli.CommandLine.Model.CommandSpec spec;

    @Parameters(paramLabel = "SCENE", arity = "0..1", description = "Scene file, YAML or JSON.")
    private Path scene;

    @Option(
            names = {"-o", "--output"},
            paramLabel = "DIR",
            description = "Folder for what is written; made if it is not there.")
    private Path output;

    @Option(
            names = "--reference",
            paramLabel = "FILE",
            description = "A reference that is there already; its standard error is FILE's name with .error.pfm.")
    private Path referenceFile;

    @Option(names = "--reference-rays", paramLabel = "N", description = "Light rays of the reference.")
    private Long referenceRays;

    @Option(
            names = "--reference-time",
            paramLabel = "T",
            converter = TimeSpan.Converter.class,
            description = "Time for the reference, such as 90s (default: 60s).")
    private TimeSpan referenceTime;

    @Option(
            names = "--reference-preprocessor",
            paramLabel = "P",
            defaultValue = ReferenceRender.PRE_PROCESSOR,
            description = "Chooses the reference's light rays (default: ${DEFAULT-VALUE}).")
    private String referencePreProcessor;

    @Option(
            names = "--rays",
            paramLabel = "N",
            split = ",",
            defaultValue = "16384,65536,262144,1048576",
            description = "Light rays to choose for a picture (default: ${DEFAULT-VALUE}).")
    private List<Long> rays;

    @Option(
            names = "--techniques",
            paramLabel = "T",
            converter = TechniquesConverter.class,
            description =
                    "Names, with commas between them, or NAME:key=value:key=value with keys of the scene's settings.")
    private List<Technique> techniques;

    @Option(
            names = "--write-scenes",
            paramLabel = "DIR",
            description =
                    "Writes scenes that are too large to be kept with the others into a folder, and does no more.")
    private Path scenes;

    @Option(
            names = "--cells",
            paramLabel = "N",
            description =
                    "Draws a caustic mesh of about so many light rays, such as 500, as DIR/cells.svg, and does no more.")
    private Long cellRays;

    @Option(names = "--size", paramLabel = "WxH", converter = PixelSize.Converter.class, description = "In pixels.")
    private PixelSize size;

    @Option(names = "--seed", paramLabel = "N", description = "Seed of all random choices.")
    private Long seed;

    @Option(
            names = "-D",
            paramLabel = "key=value",
            description = "Any key of the scene's settings, for all techniques.")
    private Map<String, String> overrides = new LinkedHashMap<>();

    @Option(names = "--allow-outside", description = "Let the scene name files outside its folder.")
    private boolean allowOutside;

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
        if (scenes != null) {
            requireFolder(scenes);
            System.out.println(WaterSheetScene.write(scenes) + ": written, with its mesh beside it");
            return ExitCode.DONE;
        }
        checkOptions();
        requireFolder(output);
        if (cellRays != null) {
            return drawCells();
        }
        List<Technique> chosen = techniques == null ? Techniques.known() : techniques;
        checkScene(chosen);
        int workers = workers();
        SceneSource source = extra -> read(extra, new Problems());
        Reference reference = reference(source, workers);
        Files.createDirectories(output);
        WholeFile.checkWritable(output.resolve("study.json"));
        StudyReport report = new Study(source, reference, chosen, rays).run(workers, progress.listener(System.err));
        Path written = report.write(output);
        System.out.print(report.table());
        System.out.println(written + ": written, with the pictures beside it");
        return ExitCode.DONE;
    }

    private Integer drawCells() throws IOException {
        checkScene(List.of());
        SceneSource source = extra -> read(extra, new Problems());
        System.out.println(CellsChart.write(source, cellRays, workers(), output) + ": written");
        return ExitCode.DONE;
    }

    private int workers() {
        return threads == 0 ? Runtime.getRuntime().availableProcessors() : threads;
    }

    private static void requireFolder(Path folder) {
        if (Files.exists(folder) && !Files.isDirectory(folder)) {
            throw new CommandFailure(ExitCode.FILE, folder + ": is a file, not a folder");
        }
    }

    private void checkOptions() {
        if (scene == null || output == null) {
            throw new ParameterException(
                    spec.commandLine(), "missing required " + (scene == null ? "parameter: SCENE" : "option -o DIR"));
        }
        if (threads < 0) {
            throw new ParameterException(spec.commandLine(), "--threads must be at least 0, but is " + threads);
        }
        if (rays.stream().anyMatch(count -> count < 1)) {
            throw new ParameterException(spec.commandLine(), "--rays must be at least 1, but are " + rays);
        }
        if (cellRays != null && cellRays < 1) {
            throw new ParameterException(spec.commandLine(), "--cells must be at least 1, but is " + cellRays);
        }
        if (referenceRays != null && referenceRays < 1) {
            throw new ParameterException(
                    spec.commandLine(), "--reference-rays must be at least 1, but is " + referenceRays);
        }
        int ways = (referenceFile == null ? 0 : 1) + (referenceRays == null ? 0 : 1) + (referenceTime == null ? 0 : 1);
        if (ways > 1) {
            throw new ParameterException(
                    spec.commandLine(), "--reference, --reference-rays and --reference-time exclude each other");
        }
    }

    private Reference reference(SceneSource source, int workers) throws IOException {
        if (referenceFile != null) {
            return Reference.read(referenceFile);
        }
        ReferenceBudget budget = DEFAULT_REFERENCE;
        if (referenceRays != null) {
            budget = new ReferenceBudget.Rays(referenceRays);
        } else if (referenceTime != null) {
            budget = new ReferenceBudget.Seconds(referenceTime.seconds());
        }
        return new ReferenceRender(source, referencePreProcessor, workers).run(budget, progress.listener(System.err));
    }

    /** Finds what is wrong with the scene or a technique's settings before time is spent; warnings are printed once. */
    private void checkScene(List<Technique> chosen) throws IOException {
        Problems problems = new Problems();
        read(Map.of(), problems);
        String lines = problems.toString();
        if (!lines.isEmpty()) {
            System.err.println(lines);
        }
        for (Technique technique : chosen) {
            read(technique.settings(), new Problems());
        }
    }

    private SceneFile read(Map<String, String> extra, Problems problems) throws IOException {
        FileScope files = allowOutside ? FileScope.anywhere(scene) : FileScope.inFolderOf(scene);
        SceneDocument document = SceneDocument.read(scene, files, problems);
        Map<String, String> settings = new LinkedHashMap<>(overrides);
        if (seed != null) {
            settings.put("seed", seed.toString());
        }
        settings.putAll(extra);
        settings.forEach((key, value) -> document.override("settings", key, value));
        SceneFile file = SceneReader.read(document, problems)
                .orElseThrow(() -> new ProblemsFailure(problems.exitCode(), problems.toString()));
        if (size == null) {
            return file;
        }
        Scene whole = file.scene();
        Scene resized = new Scene(
                whole.camera().withSize(size.width(), size.height()),
                whole.lights(),
                whole.objects(),
                whole.background());
        return new SceneFile(resized, file.settings());
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
