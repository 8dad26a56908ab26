package org.diacaustic.fault;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;
import org.diacaustic.image.ImageFiles;
import org.diacaustic.image.LinearImage;
import org.diacaustic.stability.Checks;
import org.diacaustic.stability.Launcher;

/** A temporary folder in which a fault is brought about and the program meets it; closing removes it. */
final class FaultBench implements AutoCloseable {
    /** Where runs put their picture. */
    static final String PICTURE = "out.png";

    /** Where they put it if it is not whole. */
    static final String PARTIAL = "out.partial.png";

    private static final String SCENE = "scene.yaml";

    /** Where a case says nothing of time, a fault must be told within so many seconds, even on a busy machine. */
    private static final double PROMPT = 30;

    private final Launcher launcher;
    private final Checks checks;
    private final Path root;
    private final Path folder;
    private final Path logs;

    FaultBench(Launcher launcher, Checks checks) throws IOException {
        this.launcher = launcher;
        this.checks = checks;
        root = Files.createTempDirectory("diacaustic-fault");
        folder = Files.createDirectory(root.resolve("work"));
        logs = Files.createDirectory(root.resolve("logs"));
    }

    Path folder() {
        return folder;
    }

    Program program() {
        return new Program(launcher, folder, logs);
    }

    Path write(String name, String text) throws IOException {
        return write(name, text.getBytes(StandardCharsets.UTF_8));
    }

    Path write(String name, byte[] bytes) throws IOException {
        return Files.write(folder.resolve(name), bytes);
    }

    /** The names of what is in the folder, sorted. */
    List<String> files() throws IOException {
        try (Stream<Path> found = Files.list(folder)) {
            return found.map(path -> folder.relativize(path).toString())
                    .sorted()
                    .toList();
        }
    }

    /** Writes the scene that {@link #render} renders. */
    void scene(String text) throws IOException {
        write(SCENE, text);
    }

    /** Runs something. */
    @FunctionalInterface
    interface Attempt {
        ProgramRun run() throws IOException, InterruptedException;
    }

    /** The first of three runs that takes no more than so many seconds, or the fastest: a busy machine is no fault. */
    static ProgramRun within(double seconds, Attempt attempt) throws IOException, InterruptedException {
        ProgramRun fastest = attempt.run();
        for (int again = 0; again < 2 && fastest.seconds() > seconds; again++) {
            ProgramRun next = attempt.run();
            fastest = next.seconds() < fastest.seconds() ? next : fastest;
        }
        return fastest;
    }

    ProgramRun render(Object... more) throws IOException, InterruptedException {
        return render(program(), more);
    }

    /** Renders the scene to {@link #PICTURE}. */
    ProgramRun render(Program program, Object... more) throws IOException, InterruptedException {
        clear();
        return program.run(renderArguments(more));
    }

    /** What {@link #render} says to the program. */
    static Object[] renderArguments(Object... more) {
        Object[] arguments = new Object[4 + more.length];
        arguments[0] = "render";
        arguments[1] = SCENE;
        arguments[2] = "-o";
        arguments[3] = PICTURE;
        System.arraycopy(more, 0, arguments, 4, more.length);
        return arguments;
    }

    /** Renders a scene and checks that it is refused. */
    void refuses(String what, String scene, int code, String pattern) throws IOException, InterruptedException {
        scene(scene);
        refused(what, render(), code, pattern);
    }

    /** Checks that a run ended with a code and one line that matches a pattern, soon, and left no picture. */
    void refused(String what, ProgramRun run, int code, String pattern) throws IOException {
        refused(what, run, code, pattern, PROMPT);
    }

    void refused(String what, ProgramRun run, int code, String pattern, double seconds) throws IOException {
        boolean met = run.code() == code
                && run.errorLines().size() == 1
                && !run.showsTrace()
                && run.says(pattern)
                && run.output().isEmpty()
                && run.seconds() < seconds
                && noneOf(files(), "out\\.(?!yaml).*|\\..*\\.tmp");
        checks.rule(what, "exit " + code + ", one line: " + pattern, describe(run), met);
    }

    /** Renders a scene and checks that there is a whole picture, and on standard error nothing but what is expected. */
    void renders(String what, String scene, String pattern) throws IOException, InterruptedException {
        scene(scene);
        rendered(what, render(), pattern);
    }

    /** Checks that a run left a whole picture of numbers. */
    void rendered(String what, ProgramRun run, String pattern) throws IOException {
        boolean met = run.code() == 0
                && !run.showsTrace()
                && run.errors().strip().matches("(?s)" + pattern)
                && isWhole(folder.resolve(PICTURE))
                && noneOf(files(), "\\..*\\.tmp");
        checks.rule(what, "exit 0, a whole picture, said: " + pattern, describe(run), met);
    }

    private String describe(ProgramRun run) throws IOException {
        return run + ", files " + files();
    }

    private static boolean noneOf(List<String> files, String pattern) {
        return files.stream().noneMatch(file -> file.matches(pattern));
    }

    /** Whether a file is a picture that can be read to its end and has numbers only. */
    static boolean isWhole(Path file) {
        try {
            LinearImage picture = ImageFiles.read(file);
            for (float sample : picture.samples()) {
                if (!Float.isFinite(sample)) {
                    return false;
                }
            }
            return true;
        } catch (IOException broken) {
            return false;
        }
    }

    /** Removes what the last run left. */
    void clear() throws IOException {
        for (String left : List.of(PICTURE, PARTIAL)) {
            Files.deleteIfExists(folder.resolve(left));
        }
    }

    /** Whether a command ends with 0. */
    boolean succeeds(String... command) throws IOException, InterruptedException {
        try {
            return new ProcessBuilder(command)
                            .redirectErrorStream(true)
                            .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                            .start()
                            .waitFor()
                    == 0;
        } catch (IOException unknown) {
            return false;
        }
    }

    /** Takes all leave to write from paths; and lets everybody into the folder, so that another user can run in it. */
    void makeReadOnly(Path... paths) throws IOException {
        for (Path path : List.of(root, folder, logs)) {
            Files.setPosixFilePermissions(path, PosixFilePermissions.fromString("rwxrwxrwx"));
        }
        for (Path path : paths) {
            String mode = Files.isDirectory(path) ? "r-xr-xr-x" : "r--r--r--";
            Files.setPosixFilePermissions(path, PosixFilePermissions.fromString(mode));
        }
    }

    /** The program as a user whom modes of files hold back; null, with a note, if there is no way to be one. */
    Program withoutPrivileges(Checks checks) throws IOException, InterruptedException {
        Path probe = Files.createDirectory(
                root.resolve("probe"),
                PosixFilePermissions.asFileAttribute(PosixFilePermissions.fromString("r-xr-xr-x")));
        if (!Files.isWritable(probe)) {
            return program();
        }
        Program nobody = program().by("setpriv", "--reuid=65534", "--regid=65534", "--clear-groups");
        if (nobody.canStart()) {
            return nobody;
        }
        checks.note("modes of files were not tried: this user may do anything, and there is no way to be another");
        return null;
    }

    @Override
    public void close() {
        try (Stream<Path> found = Files.walk(root)) {
            for (Path path : found.sorted(Comparator.reverseOrder()).toList()) {
                Files.delete(path);
            }
        } catch (IOException left) {
            throw new UncheckedIOException(left);
        }
    }
}
