package org.diacaustic.fault;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.diacaustic.stability.Launcher;

/**
 * How a process of the program is started. Its virtual machine compiles once and collects garbage on one thread: most runs
 * are over before more would pay.
 */
final class Program {
    private static final List<String> QUICK = List.of("-XX:TieredStopAtLevel=1", "-XX:+UseSerialGC");

    private final Launcher launcher;
    private final Path folder;
    private final Path logs;
    private final List<String> before;
    private final List<String> options;
    private final Map<String, String> environment;

    /**
     * @param folder where it runs
     * @param logs where what it writes is kept
     */
    Program(Launcher launcher, Path folder, Path logs) {
        this(launcher, folder, logs, List.of(), QUICK, Map.of());
    }

    private Program(
            Launcher launcher,
            Path folder,
            Path logs,
            List<String> before,
            List<String> options,
            Map<String, String> environment) {
        this.launcher = launcher;
        this.folder = folder;
        this.logs = logs;
        this.before = before;
        this.options = options;
        this.environment = environment;
    }

    /** The same with more options of the virtual machine, such as {@code -Xmx256m}. */
    Program with(String... more) {
        List<String> all = new ArrayList<>(options);
        all.addAll(List.of(more));
        return new Program(launcher, folder, logs, before, all, environment);
    }

    /** The same, started by another program: these words stand before the command. */
    Program by(String... words) {
        return new Program(launcher, folder, logs, List.of(words), options, environment);
    }

    /** The same, started by a shell script that runs the command as {@code "$@"}. */
    Program byShell(String script) {
        return by("sh", "-c", script, "sh");
    }

    /** The same with a variable of the environment. */
    Program in(String variable, String value) {
        Map<String, String> all = new LinkedHashMap<>(environment);
        all.put(variable, value);
        return new Program(launcher, folder, logs, before, options, all);
    }

    /** Runs to the end. */
    ProgramRun run(Object... arguments) throws IOException, InterruptedException {
        try (RunningProgram running = start(arguments)) {
            return running.await();
        }
    }

    /** Whether it can be started at all. */
    boolean canStart() throws InterruptedException {
        try {
            return run("--version").code() == 0;
        } catch (IOException unknown) {
            return false;
        }
    }

    RunningProgram start(Object... arguments) throws IOException {
        List<String> command = new ArrayList<>(before);
        command.add(launcher.java().toString());
        command.addAll(options);
        command.addAll(launcher.program());
        for (Object argument : arguments) {
            command.add(argument.toString());
        }
        Path output = Files.createTempFile(logs, "out", ".txt");
        Path errors = Files.createTempFile(logs, "err", ".txt");
        ProcessBuilder builder = new ProcessBuilder(command)
                .directory(folder.toFile())
                .redirectOutput(output.toFile())
                .redirectError(errors.toFile());
        // With these, a virtual machine says on standard error that it has seen them.
        builder.environment().keySet().removeAll(List.of("JAVA_TOOL_OPTIONS", "_JAVA_OPTIONS", "JDK_JAVA_OPTIONS"));
        builder.environment().putAll(environment);
        return new RunningProgram(builder.start(), output, errors);
    }
}
