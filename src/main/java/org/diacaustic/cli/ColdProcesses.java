package org.diacaustic.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import org.diacaustic.render.ProgressListener;
import org.diacaustic.study.Budget;
import org.diacaustic.study.ColdTimes;
import org.diacaustic.study.StudyPoint;
import org.diacaustic.study.StudyReport;
import org.diacaustic.study.Technique;
import org.diacaustic.study.TechniqueStudy;

/** Starts the program anew for one picture of each technique, and takes the time: what a user waits for who renders once. */
final class ColdProcesses {
    /** Processes that do nothing; the fastest counts. */
    private static final int EMPTY_PROCESSES = 3;

    private final SceneInput input;
    private final int threads;
    private volatile boolean isCancelled;
    private volatile Process running;

    ColdProcesses(SceneInput input, int threads) {
        this.input = input;
        this.threads = threads;
    }

    /** Starts no further process, and ends the one that runs; from any thread. */
    void cancel() {
        isCancelled = true;
        Process process = running;
        if (process != null) {
            process.destroy();
        }
    }

    /**
     * Times the point of one budget of each technique.
     *
     * @param listener hears of every technique that is done
     * @throws IOException if no process can be started
     */
    ColdTimes time(StudyReport report, Budget budget, ProgressListener listener) throws IOException {
        double start = Double.POSITIVE_INFINITY;
        for (int i = 0; i < EMPTY_PROCESSES; i++) {
            start = Math.min(start, seconds(List.of("--version")).orElse(Double.POSITIVE_INFINITY));
        }
        Path picture = Files.createTempFile("cold", ".pfm");
        Map<String, Double> renders = new LinkedHashMap<>();
        try {
            int done = 0;
            for (TechniqueStudy study : report.studies()) {
                for (StudyPoint point : study.points()) {
                    if (point.budget().equals(budget) && study.technique().isRendered()) {
                        seconds(arguments(study.technique(), point, picture))
                                .ifPresent(
                                        taken -> renders.put(study.technique().name(), taken));
                    }
                }
                listener.progressed(++done, report.studies().size());
            }
        } finally {
            Files.delete(picture);
        }
        return new ColdTimes(start < Double.POSITIVE_INFINITY ? start : Double.NaN, budget, renders);
    }

    private List<String> arguments(Technique technique, StudyPoint point, Path picture) {
        Map<String, String> settings = new LinkedHashMap<>(technique.overrides());
        settings.put("rays", Long.toString(Math.max(1, point.rays() / point.passes())));
        settings.put("passes", Integer.toString(point.passes()));
        List<String> arguments = new ArrayList<>(List.of("render", input.path().toString(), "-o", picture.toString()));
        arguments.addAll(input.optionTexts());
        arguments.addAll(List.of("--threads", Integer.toString(threads), "--progress", "none"));
        settings.forEach((key, value) -> arguments.addAll(List.of("-D", key + "=" + value)));
        return arguments;
    }

    /** How long a process takes; nothing if it fails, or is not to be. */
    private OptionalDouble seconds(List<String> arguments) throws IOException {
        List<String> command = new ArrayList<>(List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-cp",
                System.getProperty("java.class.path"),
                Main.class.getName()));
        command.addAll(arguments);
        if (isCancelled) {
            return OptionalDouble.empty();
        }
        long start = System.nanoTime();
        Process process = new ProcessBuilder(command)
                .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                .redirectError(ProcessBuilder.Redirect.DISCARD)
                .start();
        running = process;
        if (isCancelled) {
            process.destroy();
        }
        try {
            int code = process.waitFor();
            double taken = (System.nanoTime() - start) * 1e-9;
            return code == ExitCode.DONE ? OptionalDouble.of(taken) : OptionalDouble.empty();
        } catch (InterruptedException stopped) {
            process.destroy();
            Thread.currentThread().interrupt();
            return OptionalDouble.empty();
        } finally {
            running = null;
        }
    }
}
