package org.diacaustic.fault;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.diacaustic.stability.Checks;

/** Faults of where pictures and words go. */
final class StreamFaults {
    private static final String OLD = "what was there before";

    /** Of a disc, or of what one user may write to one file, in bytes. */
    private static final int ROOM = 64 << 10;

    private StreamFaults() {}

    static void addTo(FaultOperations operations) {
        operations
                .add(
                        "diskfull",
                        "A picture of 1 MB on a disc of 64 kB, or else with a limit of 64 kB a file: exit code 3, the old picture as it"
                                + " was, no other file left; a device that is always full as the target is refused before.",
                        (bench, asked, checks) -> diskFull(bench, checks))
                .add(
                        "readonly",
                        "A folder and a picture without leave to write, as a user without privileges, a folder that is not there, a"
                                + " folder and a device for a picture: exit code 3 before the scene is read, which is broken.",
                        (bench, asked, checks) -> readOnly(bench, checks))
                .add(
                        "stdout",
                        "Standard output and standard error closed, full, or a pipe that nobody reads, with every kind of progress:"
                                + " the picture is whole, exit code 0 or 3, no endless loop.",
                        (bench, asked, checks) -> streams(bench, checks))
                .add(
                        "twowriters",
                        "Four processes and one picture, in two sizes: each ends with 0, whoever looks meanwhile finds a whole picture of"
                                + " one of the sizes, and no other file is left.",
                        (bench, asked, checks) -> writers(bench, checks));
    }

    private static void diskFull(FaultBench bench, Checks checks) throws IOException, InterruptedException {
        bench.scene(FaultScene.TEXT);
        Path disc = Files.createDirectory(bench.folder().resolve("disc"));
        String mounted = "mount -t tmpfs -o size=64k tmpfs disc && printf '" + OLD
                + "' > disc/out.pfm && \"$@\"; code=$?;" + " ls -A disc >&2; cat disc/out.pfm >&2; exit $code";
        Program small = bench.program().by("unshare", "-rm", "sh", "-c", mounted, "sh");
        boolean canMount =
                bench.succeeds("unshare", "-rm", "mount", "-t", "tmpfs", "-o", "size=64k", "tmpfs", disc.toString());
        if (canMount) {
            ProgramRun run = small.run("render", "scene.yaml", "-o", "disc/out.pfm", "--size", "300x300");
            boolean met = run.code() == 3
                    && run.errorLines().size() == 3
                    && run.errors().endsWith("\nout.pfm\n" + OLD);
            checks.rule("a disc of 64 kB", "exit 3, one line, the old picture alone", run.toString(), met);
        } else {
            checks.note("no disc of 64 kB can be mounted here; files are limited to that size instead");
        }
        Files.delete(disc);
        Path picture = bench.write("out.pfm", BrokenPictures.ascii(OLD));
        ProgramRun limited = bench.program()
                .with("-XX:-UsePerfData")
                .byShell("ulimit -f " + ROOM / 512 + "; exec \"$@\"")
                .run("render", "scene.yaml", "-o", "out.pfm", "--size", "300x300");
        boolean met = limited.code() == 3
                && limited.errorLines().size() == 1
                && limited.says("out\\.pfm|[Ff]ile")
                && bench.files().equals(List.of("out.pfm", "scene.yaml"))
                && Files.readString(picture).equals(OLD);
        checks.rule(
                "files of 64 kB at most",
                "exit 3, one line, the old picture alone",
                limited + ", files " + bench.files(),
                met);
        Files.delete(picture);
        if (Files.exists(Path.of("/dev/full"))) {
            Files.createSymbolicLink(bench.folder().resolve("out.png"), Path.of("/dev/full"));
            ProgramRun device = bench.program().run("render", "scene.yaml", "-o", "out.png");
            checks.rule(
                    "/dev/full",
                    "exit 3, one line",
                    device.toString(),
                    device.code() == 3 && device.says("is a device, not a file"));
        }
    }

    private static void readOnly(FaultBench bench, Checks checks) throws IOException, InterruptedException {
        bench.scene("not a scene");
        String before = "^diacaustic: .*";
        ProgramRun none = bench.program().run("render", "scene.yaml", "-o", "none/out.png");
        bench.refused("a folder that is not there", none, 3, before + "the folder does not exist");
        Files.createDirectory(bench.folder().resolve("folder.png"));
        ProgramRun folder = bench.program().run("render", "scene.yaml", "-o", "folder.png");
        bench.refused("a folder for a picture", folder, 3, before + "is a folder, not a file");
        ProgramRun file = bench.program().run("render", "scene.yaml", "-o", "scene.yaml/out.png");
        bench.refused("a file for a folder", file, 3, before + "is a file, not a folder");
        if (Files.isDirectory(Path.of("/proc/self"))) {
            ProgramRun refusing = bench.program().run("render", "scene.yaml", "-o", "/proc/self/out.png");
            bench.refused("a folder that takes no files", refusing, 3, before + "no file can be made in the folder");
        }
        Path locked = Files.createDirectory(bench.folder().resolve("locked"));
        Path picture = bench.write("old.png", BrokenPictures.ascii(OLD));
        bench.makeReadOnly(locked, picture);
        Program plain = bench.withoutPrivileges(checks);
        if (plain != null) {
            ProgramRun inLocked = plain.run("render", "scene.yaml", "-o", "locked/out.png");
            bench.refused("a folder of mode 0555", inLocked, 3, before + "locked: no file can be made in the folder");
            ProgramRun over = plain.run("render", "scene.yaml", "-o", "old.png");
            bench.refused("a picture of mode 0444", over, 3, before + "old.png: ");
            ProgramRun stats = plain.run("render", "scene.yaml", "-o", "out.png", "--stats", "locked/s.json");
            bench.refused("statistics in a folder of mode 0555", stats, 3, before + "locked: ");
        }
        checks.same("the picture of mode 0444", OLD, Files.readString(picture));
    }

    private static void streams(FaultBench bench, Checks checks) throws IOException, InterruptedException {
        bench.scene(FaultScene.TEXT);
        String[] scripts = {
            "\"$@\" >&-",
            "\"$@\" >&- 2>&-",
            "\"$@\" 2>&-",
            "\"$@\" > /dev/full",
            "\"$@\" > /dev/full 2> /dev/full",
            "(\"$@\"; echo $? > code) | true; exit $(cat code)",
            "(\"$@\" 2>&1; echo $? > code) | true; exit $(cat code)"
        };
        for (String script : scripts) {
            for (String progress : script.contains("2>") ? List.of("plain", "json") : List.of("plain")) {
                ProgramRun run = bench.render(bench.program().byShell(script), "--progress", progress);
                boolean met = (run.code() == 0 || run.code() == 3)
                        && FaultBench.isWhole(bench.folder().resolve(FaultBench.PICTURE))
                        && !run.showsTrace();
                checks.rule(
                        script.replace("\"$@\"", "render") + ", progress " + progress,
                        "exit 0 or 3, a whole picture",
                        run.toString(),
                        met);
                Files.deleteIfExists(bench.folder().resolve("code"));
            }
        }
    }

    private static void writers(FaultBench bench, Checks checks) throws IOException, InterruptedException {
        bench.scene(FaultScene.TEXT);
        Path picture = bench.folder().resolve(FaultBench.PICTURE);
        List<RunningProgram> running = new ArrayList<>();
        for (int i = 0; i < 4; i++) {
            running.add(
                    bench.program().start(FaultBench.renderArguments("--size", i % 2 == 0 ? "200x160" : "160x200")));
        }
        int looks = 0;
        int torn = 0;
        while (running.stream().anyMatch(RunningProgram::isAlive)) {
            if (Files.exists(picture)) {
                looks++;
                torn += FaultBench.isWhole(picture) ? 0 : 1;
            }
            TimeUnit.MILLISECONDS.sleep(5);
        }
        for (RunningProgram one : running) {
            checks.same("exit code", 0, one.await().code());
        }
        checks.same("pictures that were not whole, of " + looks + " looks", 0, torn);
        checks.holds("the picture at the end is whole", FaultBench.isWhole(picture));
        checks.same("files", List.of("out.png", "scene.yaml"), bench.files());
    }
}
