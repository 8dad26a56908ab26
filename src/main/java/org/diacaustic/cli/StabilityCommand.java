package org.diacaustic.cli;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import org.diacaustic.fault.FaultTrials;
import org.diacaustic.image.WholeFile;
import org.diacaustic.parallel.Workers;
import org.diacaustic.stability.CaseFile;
import org.diacaustic.stability.Launcher;
import org.diacaustic.stability.NumericCase;
import org.diacaustic.stability.Operation;
import org.diacaustic.stability.Operations;
import org.diacaustic.stability.StabilityReport;
import org.diacaustic.stability.StabilityRun;
import org.diacaustic.stability.StabilityText;
import org.diacaustic.stability.Verdict;
import org.diacaustic.trial.RandomSceneTrials;
import org.diacaustic.trial.Trials;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** {@code stability}: numeric cases with exact answers, put to the code that renders. */
@Command(
        name = "stability",
        mixinStandardHelpOptions = true,
        versionProvider = Version.class,
        description = {
            "Puts stiff and extreme cases with exact answers to the code that renders.",
            "Prints a line a case: what was expected, what came, error/tolerance, verdict; then a line a category. Exit code 4 if any case fails."
        })
final class StabilityCommand implements Callable<Integer> {
    @Spec
    private picocli.CommandLine.Model.CommandSpec spec;

    @Option(
            names = "--cases",
            paramLabel = "FILE",
            description = "File of cases, JSON of the schema caustics-numerics/1 (default: those that come along).")
    private Path file;

    @Option(
            names = {"-o", "--output"},
            paramLabel = "DIR",
            description = "Folder for stability.md and stability.json; made if it is not there.")
    private Path output;

    @Option(
            names = "--category",
            paramLabel = "X",
            split = ",",
            description = "Only cases of this category, such as REFR; several with commas between them.")
    private List<String> categories = List.of();

    @Option(names = "--faults", description = "Also cases that start processes: broken files, limits, signals.")
    private boolean faults;

    @Option(
            names = "--jdk",
            paramLabel = "HOME",
            description = "Home of another JDK, whose pictures must have the same bits.")
    private Path jdk;

    @Option(
            names = "--random",
            paramLabel = "N",
            description = "Also renders N scenes of chance at scales 2^-20, 1, 2^20, with 5,000 rays each.")
    private int randomScenes;

    @Option(names = "--threads", paramLabel = "N", description = "Threads; 0 for all cores (default).")
    private int threads;

    @Option(names = "--debug", description = "Show a stack trace when something fails.")
    private boolean debug;

    @Override
    public Integer call() throws IOException {
        if (threads < 0) {
            throw new ParameterException(spec.commandLine(), "--threads must be at least 0, but is " + threads);
        }
        if (randomScenes < 0) {
            throw new ParameterException(spec.commandLine(), "--random must be at least 0, but is " + randomScenes);
        }
        List<NumericCase> cases = new ArrayList<>(file == null ? CaseFile.bundled() : CaseFile.read(file));
        cases.addAll(RandomSceneTrials.cases(randomScenes));
        cases = chosen(cases);
        if (output != null) {
            OutputFolder.make(output, "stability.md");
        }
        Set<Operation.Need> allowed = faults ? EnumSet.allOf(Operation.Need.class) : EnumSet.of(Operation.Need.NOTHING);
        int workers = threads == 0 ? Runtime.getRuntime().availableProcessors() : threads;
        StabilityReport report = new StabilityRun(operations(), allowed)
                .run(cases, new Workers(workers), result -> System.out.println(StabilityText.line(result)));
        report.categories().forEach(category -> System.out.println(StabilityText.line(category)));
        System.out.println(StabilityText.summary(report));
        if (output != null) {
            write("stability.json", report.json());
            write("stability.md", report.page());
        }
        return report.count(Verdict.FAIL) == 0 ? ExitCode.DONE : ExitCode.LIMIT;
    }

    private List<NumericCase> chosen(List<NumericCase> cases) {
        Set<String> known = new TreeSet<>();
        cases.forEach(one -> known.add(one.category()));
        List<String> wanted =
                categories.stream().map(name -> name.toUpperCase(Locale.ROOT)).toList();
        for (String name : wanted) {
            if (!known.contains(name)) {
                throw new ParameterException(
                        spec.commandLine(),
                        "--category must be one of " + String.join(", ", known) + ", but is " + name);
            }
        }
        return cases.stream()
                .filter(one -> wanted.isEmpty() || wanted.contains(one.category()))
                .toList();
    }

    private Operations operations() {
        Launcher launcher = launcher();
        Operations operations = Trials.all(launcher);
        FaultTrials.addTo(operations, launcher);
        return operations;
    }

    private Launcher launcher() {
        if (jdk != null && !Files.isExecutable(javaOf(jdk))) {
            throw new ParameterException(
                    spec.commandLine(), "--jdk must be the home of a JDK, but " + javaOf(jdk) + " cannot be run");
        }
        return new Launcher(
                javaOf(Path.of(System.getProperty("java.home"))),
                List.of("-cp", classPath(), Main.class.getName()),
                Optional.ofNullable(jdk).map(StabilityCommand::javaOf));
    }

    /** Of this process, in absolute paths: others run elsewhere. */
    private static String classPath() {
        return Arrays.stream(System.getProperty("java.class.path").split(File.pathSeparator))
                .map(entry -> Path.of(entry).toAbsolutePath().toString())
                .collect(Collectors.joining(File.pathSeparator));
    }

    private static Path javaOf(Path home) {
        return home.resolve("bin").resolve("java");
    }

    private void write(String name, String text) throws IOException {
        WholeFile.write(output.resolve(name), out -> out.write(text.getBytes(StandardCharsets.UTF_8)));
    }
}
