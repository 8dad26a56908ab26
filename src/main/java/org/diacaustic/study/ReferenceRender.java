package org.diacaustic.study;

import java.io.IOException;
import java.util.Map;
import java.util.Optional;
import org.diacaustic.image.LinearImage;
import org.diacaustic.parallel.Workers;
import org.diacaustic.render.ProgressListener;

/** Makes a reference that owes nothing to any map: see {@link LightTracedPicture}. */
public final class ReferenceRender {
    /** They tell how far their mean may be off, so they must be some; but many rays at once are spread more evenly. */
    private static final int BATCHES = 16;

    /** What is traced at least to see how long that takes. */
    private static final long RAYS_OF_A_TRIAL = 1 << 16;

    private static final double TRIAL_PART = 0.05;

    /** Chooses light rays if nothing else is said: {@link JitteredPreProcessor}. */
    public static final String PRE_PROCESSOR = JitteredPreProcessor.NAME;

    private final TechniqueRender render;
    private final Workers workers;

    /**
     * @param preProcessor chooses the light rays; unbiased
     * @throws IOException if the scene cannot be read
     */
    public ReferenceRender(SceneSource source, String preProcessor, int threads) throws IOException {
        this.workers = new Workers(threads);
        Technique technique =
                new Technique("reference", Technique.Way.INTO_PIXELS, Map.of("preprocessor", preProcessor));
        this.render = new TechniqueRender(source, technique, workers);
    }

    /**
     * Makes the reference.
     *
     * @param listener hears which part is done
     * @throws IllegalArgumentException if the camera has a lens, or there is no light to be traced
     */
    public Reference run(ReferenceBudget budget, ProgressListener listener) {
        long start = System.nanoTime();
        LinearImage direct = render.direct();
        // Techniques that are held against it use the seed itself, and must share no ray with it.
        long seed = ~render.seed();
        long rays = budget instanceof ReferenceBudget.Rays given
                ? given.count()
                : raysWithin(((ReferenceBudget.Seconds) budget).count() - since(start), seed);
        LightTracedPicture traced = render.traced(Math.max(1, rays / BATCHES), seed);
        for (int batch = 0; batch < BATCHES; batch++) {
            traced.add(batch);
            listener.progressed(batch + 1, BATCHES);
        }
        return new Reference(
                TechniqueRender.sum(direct, traced.picture()),
                Optional.of(traced.standardError()),
                traced.lightRays(),
                traced.batches(),
                since(start));
    }

    /** About as many rays as can be traced in the time, a twentieth of which is spent to find out. */
    private long raysWithin(double seconds, long seed) {
        // The first is slow: the virtual machine learns from it.
        trial(RAYS_OF_A_TRIAL, seed);
        long rays = RAYS_OF_A_TRIAL;
        double taken = trial(rays, seed);
        for (double spent = taken; spent + 2 * taken < TRIAL_PART * seconds; spent += taken) {
            rays *= 2;
            taken = trial(rays, seed);
        }
        return (long) Math.max(RAYS_OF_A_TRIAL, Math.min(1e15, rays / taken * (1 - TRIAL_PART) * seconds));
    }

    /** How many seconds so many rays take. */
    private double trial(long rays, long seed) {
        long start = System.nanoTime();
        render.traced(rays, seed).add(0);
        return since(start);
    }

    private static double since(long start) {
        return (System.nanoTime() - start) * 1e-9;
    }
}
