package org.diacaustic.fault;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.diacaustic.image.ImageFiles;
import org.diacaustic.image.LinearImage;
import org.diacaustic.stability.Checks;
import org.diacaustic.stability.NumericCase;

/** Ends that come early: signals, limits of time, clocks. */
final class SignalFaults {
    /** Enough samples a pixel for hours. */
    private static final String ENDLESS = "1000000000";

    /** All classes that have to do with time. */
    private static final List<String> TIMING = List.of(
            "cli/Stopwatch",
            "cli/ProcessTime",
            "cli/GoalOptions",
            "cli/ProgressKind$ProgressLine",
            "render/Goal",
            "render/RoundSignal",
            "render/PassRun",
            "render/Rounds",
            "render/MeshRounds",
            "render/PassRounds",
            "parallel/Workers");

    private static final Pattern WALL_CLOCK =
            Pattern.compile("currentTimeMillis|java/time/(?!Duration)|java/util/(Date|Calendar|Timer)");

    private SignalFaults() {}

    static void addTo(FaultOperations operations) {
        operations
                .add(
                        "killresume",
                        "A render that is killed leaves nothing, and is begun again: there are no checkpoints.",
                        (bench, asked, checks) ->
                                checks.notApplicable("renders are not resumed; checkpoints are still to come"))
                .add(
                        "badcheckpoint",
                        "There are no checkpoints.",
                        (bench, asked, checks) ->
                                checks.notApplicable("renders are not resumed; checkpoints are still to come"))
                .add(
                        "sigint",
                        "SIGINT, SIGTERM and SIGHUP in rows, SIGINT in the forward pass, in the first pixel and twice: within 2 s the"
                                + " picture so far is saved under another name, exit code 130, 143 and 129; there are no checkpoints.",
                        (bench, asked, checks) -> signals(bench, checks))
                .add(
                        "timelimit",
                        "Our option is --time, a goal that is also a limit: a scene for hours with the times of the case, in rows and in"
                                + " the forward pass, ends within the time + 1 s with a picture and a line that says what was done; 0,"
                                + " negative, without a unit: exit code 2.",
                        SignalFaults::timeLimit)
                .add(
                        "clock",
                        "The clock of the machine cannot be set back for a test; instead the class files that have to do with"
                                + " time limits and times left are looked through: they name no clock but System.nanoTime and the uptime of the"
                                + " virtual machine, which are monotonic.",
                        (bench, asked, checks) -> clock(checks));
    }

    private static void signals(FaultBench bench, Checks checks) throws IOException, InterruptedException {
        bench.scene(FaultScene.TEXT);
        Object[] rows = {"--size", "320x320", "--samples", 400, "--progress", "plain"};
        end(bench, checks, "SIGINT in rows", 130, true, rows, "INT");
        end(bench, checks, "SIGTERM in rows", 143, true, rows, "TERM");
        end(bench, checks, "SIGHUP in rows", 129, true, rows, "HUP");
        end(bench, checks, "SIGINT twice", 130, true, rows, "INT", "INT");
        end(bench, checks, "SIGINT in the first pixels", 130, false, new Object[] {"--samples", ENDLESS}, "INT");
        Object[] forward = {"--rays", "1000000", "--passes", "1000000", "--map", "photon-map", "--size", "1x1"};
        end(bench, checks, "SIGTERM in the forward pass", 143, false, forward, "TERM");
    }

    /** @param inRows whether to wait until a tenth of the picture is reported; else until it has worked for 1.5 s */
    private static void end(
            FaultBench bench, Checks checks, String what, int code, boolean inRows, Object[] options, String... signals)
            throws IOException, InterruptedException {
        bench.clear();
        ProgramRun run;
        try (RunningProgram running = bench.program().start(FaultBench.renderArguments(options))) {
            if (inRows) {
                running.awaitWords();
            } else {
                running.awaitWork(1.5);
            }
            for (String signal : signals) {
                running.signal(signal);
            }
            run = running.await();
        }
        checks.atMost(what + ": seconds to the end", 2, run.seconds());
        boolean saved = FaultBench.isWhole(bench.folder().resolve(FaultBench.PARTIAL));
        boolean met = run.code() == code
                && run.says("interrupted; saved \\d+ % of the picture as out\\.partial\\.png")
                && !run.showsTrace()
                && saved
                && bench.files().equals(List.of(FaultBench.PARTIAL, "scene.yaml"));
        checks.rule(what, "exit " + code + ", the picture so far", run + ", files " + bench.files(), met);
        if (inRows) {
            checks.holds(what + ": the picture has light", saved && hasLight(bench));
        }
    }

    private static boolean hasLight(FaultBench bench) throws IOException {
        LinearImage picture = ImageFiles.read(bench.folder().resolve(FaultBench.PARTIAL));
        for (float sample : picture.samples()) {
            if (sample > 0) {
                return true;
            }
        }
        return false;
    }

    private static void timeLimit(FaultBench bench, NumericCase asked, Checks checks)
            throws IOException, InterruptedException {
        bench.scene(FaultScene.TEXT);
        List<Double> limits = new ArrayList<>(List.of(1.0));
        Matcher named = Pattern.compile("(\\d+(?:\\.\\d+)?) ?s\\b")
                .matcher(asked.inputs().text("variant", ""));
        while (named.find()) {
            double limit = Double.parseDouble(named.group(1));
            if (limit >= 0.5 && limit <= 10) {
                limits.add(limit);
            }
        }
        for (double limit : limits) {
            ends(bench, checks, "rows", limit, "--samples", ENDLESS, "--size", "64x64");
        }
        ends(bench, checks, "passes of light", 1, "--map", "photon-map", "--size", "64x64");
        ends(
                bench,
                checks,
                "one endless pass of light",
                1,
                "--map",
                "photon-map",
                "--rays",
                "100000000",
                "--size",
                "8x8");
        ends(bench, checks, "mirrors without end", 1, "--max-depth", "1000000000", "-D", "minimum-throughput=0");
        for (String time : List.of("0s", "0", "-1s", "2", "nan")) {
            bench.refused(
                    "--time '" + time + "'",
                    bench.render("--time=" + time),
                    2,
                    "expected a number above 0 with a unit");
        }
    }

    private static void ends(FaultBench bench, Checks checks, String where, double limit, Object... options)
            throws IOException, InterruptedException {
        Object[] all = new Object[options.length + 1];
        System.arraycopy(options, 0, all, 0, options.length);
        all[options.length] = "--time=" + limit + "s";
        ProgramRun run = FaultBench.within(limit + 1, () -> bench.render(all));
        checks.atMost(limit + " s, in " + where + ": seconds", limit + 1, run.seconds());
        boolean whole = run.code() == 0
                && FaultBench.isWhole(bench.folder().resolve(FaultBench.PICTURE))
                && run.output().contains("out.png: ");
        boolean partial = run.code() == 4
                && FaultBench.isWhole(bench.folder().resolve(FaultBench.PARTIAL))
                && run.says("the time is over .* saved \\d+ % of the picture as out\\.partial\\.png");
        checks.rule(
                limit + " s, in " + where,
                "exit 0 or 4, a picture, what was done",
                run.toString(),
                (whole || partial) && !run.showsTrace());
    }

    private static void clock(Checks checks) throws IOException {
        for (String name : TIMING) {
            Matcher wall = WALL_CLOCK.matcher(constants("/org/diacaustic/" + name + ".class"));
            boolean isThere = wall.find();
            checks.rule("clocks of " + name, "monotonic", isThere ? wall.group() : "monotonic", !isThere);
        }
    }

    private static String constants(String resource) throws IOException {
        try (InputStream in = SignalFaults.class.getResourceAsStream(resource)) {
            if (in == null) {
                throw new IOException("there is no class " + resource);
            }
            return new String(in.readAllBytes(), StandardCharsets.ISO_8859_1);
        }
    }
}
