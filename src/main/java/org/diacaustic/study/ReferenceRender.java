package org.diacaustic.study;

import java.io.IOException;
import java.util.Map;
import java.util.Optional;
import org.diacaustic.image.LinearImage;
import org.diacaustic.parallel.Workers;
import org.diacaustic.render.ProgressListener;

/** Makes a reference that owes nothing to any map: see {@link LightTracedPicture}. */
public final class ReferenceRender {
    /** Passes tell how far their mean may be off, so they must be some; but large ones spread their rays more evenly. */
    private static final int FEWEST_PASSES = 16;

    private static final long MOST_RAYS_A_PASS = 1 << 20;

    private static final int FEWEST_TIMED_PASSES = 4;
    private static final long RAYS_A_TIMED_PASS = 1 << 19;

    /** What progress towards a time is told in. */
    private static final int PARTS = 1000;

    /** Chooses light rays if nothing else is said: evenly, shifted by chance, with a third of the noise of random ones. */
    public static final String PRE_PROCESSOR = "cube";

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
        LightTracedPicture traced;
        if (budget instanceof ReferenceBudget.Rays rays) {
            int passes = (int) Math.max(FEWEST_PASSES, -Math.floorDiv(-rays.count(), MOST_RAYS_A_PASS));
            traced = render.traced(Math.max(1, rays.count() / passes), seed);
            for (int pass = 0; pass < passes; pass++) {
                traced.add(pass);
                listener.progressed(pass + 1, passes);
            }
        } else {
            double seconds = ((ReferenceBudget.Seconds) budget).count();
            traced = render.traced(RAYS_A_TIMED_PASS, seed);
            while (traced.passes() < FEWEST_TIMED_PASSES || since(start) < seconds) {
                traced.add(traced.passes());
                listener.progressed((int) Math.ceil(PARTS * Math.min(1, since(start) / seconds)), PARTS);
            }
        }
        return new Reference(
                TechniqueRender.sum(direct, traced.picture()),
                Optional.of(traced.standardError()),
                traced.lightRays(),
                traced.passes(),
                since(start));
    }

    private static double since(long start) {
        return (System.nanoTime() - start) * 1e-9;
    }
}
