package org.diacaustic.study;

import java.io.IOException;
import java.util.Map;
import java.util.Optional;
import org.diacaustic.image.LinearImage;
import org.diacaustic.parallel.Workers;
import org.diacaustic.render.ProgressListener;

/** Makes a reference that owes nothing to any map: straight rays where they are exact ({@link StraightLight}), else {@link LightTracedPicture}. */
public final class ReferenceRender {
    /** They tell how far their mean may be off, so they must be some; but rays are spread the more evenly the more there are at once. */
    private static final int BATCHES = 4;

    /** What is traced at least to see how long that takes. */
    private static final long RAYS_OF_A_TRIAL = 1 << 16;

    private static final double TRIAL_PART = 0.05;

    /** Chooses light rays if nothing else is said: {@link JitteredPreProcessor}. */
    public static final String PRE_PROCESSOR = JitteredPreProcessor.NAME;

    /** Eye rays of a pixel by which straight rays are timed. */
    private static final int SAMPLES_OF_A_TRIAL = 4;

    private final SceneSource source;
    private final TechniqueRender render;
    private final Workers workers;

    /**
     * @param preProcessor chooses the light rays; unbiased
     * @throws IOException if the scene cannot be read
     */
    public ReferenceRender(SceneSource source, String preProcessor, int threads) throws IOException {
        this.source = source;
        this.workers = new Workers(threads);
        Technique technique =
                new Technique("reference", Technique.Way.INTO_PIXELS, Map.of("preprocessor", preProcessor), 0);
        this.render = new TechniqueRender(source, technique, workers);
    }

    /** Stops soon, from any thread; {@link #run} then returns nothing. */
    public void cancel() {
        render.cancel();
    }

    /**
     * Makes the reference.
     *
     * @param budget of light rays; of eye rays where light goes straight
     * @param listener hears which part is done
     * @return nothing if it was cancelled
     * @throws IOException if the scene cannot be read
     * @throws IllegalArgumentException if the camera has a lens, or there is no light to be traced
     */
    public Optional<Reference> run(ReferenceBudget budget, ProgressListener listener) throws IOException {
        Reference reference = render.isStraight() ? straight(budget, listener) : traced(budget, listener);
        return workers.stop().isSet() ? Optional.empty() : Optional.of(reference);
    }

    private Reference straight(ReferenceBudget budget, ProgressListener listener) throws IOException {
        Clock clock = new Clock();
        LinearImage direct = render.direct();
        double rays = budget instanceof ReferenceBudget.Rays given
                ? given.count()
                : ((ReferenceBudget.Seconds) budget).count() * straightRaysASecond(direct);
        int samples = (int) Math.max(1, Math.min(1 << 20, rays / (render.pixels() * BATCHES)));
        StraightLight light = straightLight(samples, direct);
        for (int batch = 0; batch < BATCHES && !workers.stop().isSet(); batch++) {
            light.add(~render.seed() - batch);
            listener.progressed(batch + 1, BATCHES);
        }
        return reference(
                Reference.Origin.STRAIGHT_RAYS,
                direct,
                light.batches(),
                (long) (samples * render.pixels()) * BATCHES,
                clock);
    }

    private StraightLight straightLight(int samples, LinearImage direct) throws IOException {
        return new StraightLight(source, samples, direct.width(), direct.height(), workers);
    }

    private double straightRaysASecond(LinearImage direct) throws IOException {
        StraightLight light = straightLight(SAMPLES_OF_A_TRIAL, direct);
        // The first is slow: the virtual machine learns from it.
        light.add(0);
        Clock clock = new Clock();
        light.add(0);
        return SAMPLES_OF_A_TRIAL * render.pixels() / clock.wallSeconds();
    }

    private Reference traced(ReferenceBudget budget, ProgressListener listener) {
        Clock clock = new Clock();
        LinearImage direct = render.direct();
        // Techniques that are held against it use the seed itself and those after it, and must share no ray with it.
        long seed = ~render.seed();
        long rays = budget instanceof ReferenceBudget.Rays given
                ? given.count()
                : raysWithin(((ReferenceBudget.Seconds) budget).count() - clock.wallSeconds(), seed);
        LightTracedPicture traced = render.traced(Math.max(1, rays / BATCHES), seed);
        for (int batch = 0; batch < BATCHES && !workers.stop().isSet(); batch++) {
            traced.add(batch);
            listener.progressed(batch + 1, BATCHES);
        }
        return reference(Reference.Origin.LIGHT_TRACED, direct, traced.batches(), traced.lightRays(), clock);
    }

    /** Null if there are not all batches. */
    private Reference reference(
            Reference.Origin origin, LinearImage direct, PixelBatches batches, long rays, Clock clock) {
        if (workers.stop().isSet()) {
            return null;
        }
        return new Reference(
                origin,
                TechniqueRender.sum(direct, batches.mean()),
                Optional.of(batches.standardError()),
                Optional.of(batches.halves()),
                rays,
                batches.count(),
                clock.wallSeconds());
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
        Clock clock = new Clock();
        render.traced(rays, seed).add(0);
        return clock.wallSeconds();
    }
}
