package org.diacaustic.fault;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;

/** A process of the program on its way; closing kills it. */
final class RunningProgram implements AutoCloseable {
    /** No run is meant to take a tenth as long, in seconds. */
    private static final int PATIENCE = 60;

    private static final int POLL_MILLISECONDS = 5;

    private final Process process;
    private final Path output;
    private final Path errors;
    private long start = System.nanoTime();

    RunningProgram(Process process, Path output, Path errors) {
        this.process = process;
        this.output = output;
        this.errors = errors;
    }

    /** Waits until it has said something on standard error, such as how far it is, or has ended. */
    void awaitWords() throws IOException, InterruptedException {
        long begun = System.nanoTime();
        while (process.isAlive() && Files.size(errors) == 0 && System.nanoTime() - begun < PATIENCE * 1_000_000_000L) {
            TimeUnit.MILLISECONDS.sleep(POLL_MILLISECONDS);
        }
    }

    /** Waits until it has worked for so long, whatever else the machine has to do, or has ended. */
    void awaitWork(double seconds) throws InterruptedException {
        long begun = System.nanoTime();
        while (process.isAlive() && worked() < seconds && System.nanoTime() - begun < PATIENCE * 1_000_000_000L) {
            TimeUnit.MILLISECONDS.sleep(POLL_MILLISECONDS);
        }
    }

    /** The processor time so far, in seconds; endless if the system does not tell. */
    private double worked() {
        return process.info()
                .totalCpuDuration()
                .map(time -> time.toNanos() * 1e-9)
                .orElse(Double.POSITIVE_INFINITY);
    }

    boolean isAlive() {
        return process.isAlive();
    }

    /** Sends a signal, such as INT; the time of the run is measured from here. */
    void signal(String name) throws IOException, InterruptedException {
        start = System.nanoTime();
        new ProcessBuilder("kill", "-" + name, Long.toString(process.pid()))
                .redirectErrorStream(true)
                .start()
                .waitFor();
    }

    /** Waits for the end. */
    ProgramRun await() throws IOException, InterruptedException {
        boolean ended = process.waitFor(PATIENCE, TimeUnit.SECONDS);
        double seconds = (System.nanoTime() - start) * 1e-9;
        if (!ended) {
            process.destroyForcibly().waitFor();
        }
        return new ProgramRun(ended ? process.exitValue() : ProgramRun.HUNG, seconds, text(output), text(errors));
    }

    private static String text(Path file) throws IOException {
        return new String(Files.readAllBytes(file), StandardCharsets.UTF_8);
    }

    @Override
    public void close() {
        process.destroyForcibly();
    }
}
