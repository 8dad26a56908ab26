package org.diacaustic.study;

import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.IntConsumer;
import org.diacaustic.parallel.Workers;
import org.diacaustic.render.PlanException;
import org.diacaustic.render.ProgressListener;

/** Renders one scene with several techniques and numbers of light rays, and holds every picture against a reference. */
public final class Study {
    private final SceneSource source;
    private final Reference reference;
    private final List<Technique> techniques;
    private final List<Long> rays;

    /**
     * @param rays to choose for a picture, from few to many
     * @throws IllegalArgumentException if there are no rays to choose
     */
    public Study(SceneSource source, Reference reference, List<Technique> techniques, List<Long> rays) {
        if (rays.isEmpty() || rays.stream().anyMatch(count -> count < 1)) {
            throw new IllegalArgumentException("a study needs numbers of light rays of at least 1, but has " + rays);
        }
        this.source = source;
        this.reference = reference;
        this.techniques = List.copyOf(techniques);
        this.rays = rays.stream().sorted().distinct().toList();
    }

    /**
     * Runs the study. Apart from times, its results depend on the scene's seed only.
     *
     * @param listener hears of every finished picture
     * @throws IOException if the scene cannot be read
     * @throws IllegalArgumentException if the reference is not of the picture's size
     */
    public StudyReport run(int threads, ProgressListener listener) throws IOException {
        List<TechniqueStudy> studies = new ArrayList<>();
        DiffusePixels pixels = DiffusePixels.of(source.read(Map.of()).scene());
        int total = techniques.size() * rays.size();
        for (Technique technique : techniques) {
            int before = studies.size() * rays.size();
            studies.add(study(technique, pixels, threads, done -> listener.progressed(before + done, total)));
        }
        return new StudyReport(reference, pixels.picture(), studies, threads);
    }

    private TechniqueStudy study(Technique technique, DiffusePixels pixels, int threads, IntConsumer progress)
            throws IOException {
        TechniqueRender render = new TechniqueRender(source, technique, new Workers(threads));
        List<StudyRun> runs = new ArrayList<>();
        try {
            // The first picture also pays for what the virtual machine has to learn.
            render.render(rays.get(0));
            for (long count : rays) {
                runs.add(measure(render, count, pixels));
                progress.accept(runs.size());
            }
        } catch (PlanException refused) {
            progress.accept(rays.size());
            return new TechniqueStudy(technique, List.of(), refused.getMessage());
        }
        return new TechniqueStudy(technique, runs, "");
    }

    private StudyRun measure(TechniqueRender render, long count, DiffusePixels pixels) {
        double processorBefore = processorSeconds();
        long start = System.nanoTime();
        TechniqueRender.Made made = render.render(count);
        double seconds = (System.nanoTime() - start) * 1e-9;
        double processor = processorSeconds() - processorBefore;
        return new StudyRun(
                count,
                made.lightRays(),
                seconds,
                processor,
                made.picture(),
                PictureError.of(made.picture(), reference, pixels));
    }

    private static double processorSeconds() {
        return ProcessHandle.current()
                .info()
                .totalCpuDuration()
                .map(Duration::toNanos)
                .map(nanoseconds -> nanoseconds * 1e-9)
                .orElse(Double.NaN);
    }
}
