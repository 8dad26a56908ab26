package org.diacaustic.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import org.diacaustic.render.ProgressListener;
import org.diacaustic.study.Reference;
import org.diacaustic.study.ReferenceBudget;
import org.diacaustic.study.ReferenceRender;
import org.diacaustic.study.SceneSource;
import org.diacaustic.study.StudyFolder;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;

/** What pictures are held against. */
final class ReferenceOptions {
    /** A number of rays, not a time, so that the same study finds the same errors. */
    private static final long RAYS = 400_000_000;

    private static final long QUICK_RAYS = 20_000_000;

    @Option(
            names = "--reference",
            paramLabel = "FILE",
            description = "A reference that is there already; its standard error is FILE's name with .error.pfm.")
    private Path file;

    @Option(
            names = "--reference-rays",
            paramLabel = "N",
            description = "Rays of the reference (default: " + RAYS + ", or " + QUICK_RAYS + " with --quick).")
    private Long rays;

    @Option(
            names = "--reference-time",
            paramLabel = "T",
            converter = TimeSpan.Converter.class,
            description = "Time for the reference, such as 90s, in place of a number of rays.")
    private TimeSpan time;

    @Option(
            names = "--reference-preprocessor",
            paramLabel = "P",
            defaultValue = ReferenceRender.PRE_PROCESSOR,
            description = "Chooses the reference's light rays (default: ${DEFAULT-VALUE}).")
    private String preProcessor;

    /**
     * @throws ParameterException if something is out of range, or excludes something else
     * @throws IOException if there is no such file
     */
    void check(CommandSpec spec) throws IOException {
        if (rays != null && rays < 1) {
            throw new ParameterException(spec.commandLine(), "--reference-rays must be at least 1, but is " + rays);
        }
        int ways = (file == null ? 0 : 1) + (rays == null ? 0 : 1) + (time == null ? 0 : 1);
        if (ways > 1) {
            throw new ParameterException(
                    spec.commandLine(), "--reference, --reference-rays and --reference-time exclude each other");
        }
        if (file != null && !Files.exists(file)) {
            throw new NoSuchFileException(file.toString());
        }
    }

    /** What was asked for, in words. */
    String text(boolean quick) throws IOException {
        if (file != null) {
            return file.toAbsolutePath().normalize() + ", " + Digest.of(file);
        }
        String amount = time != null ? time.seconds() + " s" : count(quick) + " rays";
        return amount + ", " + preProcessor;
    }

    private long count(boolean quick) {
        return rays != null ? rays : quick ? QUICK_RAYS : RAYS;
    }

    /**
     * Reads or renders the reference, and keeps it.
     *
     * @return nothing if it was interrupted
     */
    Optional<Reference> make(
            SceneSource source, int threads, boolean quick, ProgressListener listener, StudyFolder folder)
            throws IOException {
        if (file != null) {
            Reference read = Reference.read(file);
            read.requireSizeOf(source.read(Map.of()).scene().camera());
            folder.keep(read);
            return Optional.of(read);
        }
        ReferenceBudget budget =
                time == null ? new ReferenceBudget.Rays(count(quick)) : new ReferenceBudget.Seconds(time.seconds());
        ReferenceRender render = new ReferenceRender(source, preProcessor, threads);
        Interruption interruption = Interruption.cancelling(render::cancel);
        try {
            Optional<Reference> made = render.run(budget, listener);
            if (made.isPresent()) {
                folder.keep(made.get());
            }
            return made;
        } finally {
            interruption.saved();
        }
    }
}
