package org.diacaustic.cli;

import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import org.diacaustic.render.Goal;
import org.diacaustic.scene.Camera;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;

/** How good a picture is to be, or when it is to be there. */
final class GoalOptions {
    /** What is left for ending the process and for what cannot be foreseen, in seconds. */
    private static final double TO_END = 0.08;

    /** To encode and write a pixel, in seconds, on a slow machine. */
    private static final double TO_WRITE_A_PIXEL = 3e-7;

    /** No more of the time than this is kept back. */
    private static final double LARGEST_PART = 0.2;

    /** As good as never, in seconds. */
    private static final double LONGEST = 1e9;

    @Option(
            names = "--time",
            paramLabel = "T",
            converter = TimeSpan.Converter.class,
            description = "Use this much time, from the start of the process to its end: 10s, 1.5m, 2h, 500ms.")
    private TimeSpan time;

    @Option(
            names = "--error",
            paramLabel = "E",
            converter = ErrorBound.Converter.class,
            description = "Go on until the estimated error is as small: 1% or 0.01.")
    private ErrorBound error;

    /** @throws ParameterException if the number of passes is given too, which is what a goal finds out */
    void refusePasses(SceneOptions options, CommandSpec spec) {
        if (options.hasPasses() && (time != null || error != null)) {
            throw new ParameterException(
                    spec.commandLine(),
                    "--passes and " + (time == null ? "--error" : "--time") + " exclude each other");
        }
    }

    /** What is asked for; nothing if neither is. */
    Optional<Goal> goal(ProcessTime process, Camera camera) {
        if (time == null && error == null) {
            return Optional.empty();
        }
        OptionalLong deadline = time == null ? OptionalLong.empty() : OptionalLong.of(deadline(process, camera));
        return Optional.of(
                new Goal(error == null ? OptionalDouble.empty() : OptionalDouble.of(error.part()), deadline));
    }

    private long deadline(ProcessTime process, Camera camera) {
        double toWrite = TO_END + TO_WRITE_A_PIXEL * camera.width() * camera.height();
        double left = time.seconds() - Math.min(LARGEST_PART * time.seconds(), toWrite) - process.seconds();
        return System.nanoTime() + (long) (1e9 * Math.min(left, LONGEST));
    }
}
