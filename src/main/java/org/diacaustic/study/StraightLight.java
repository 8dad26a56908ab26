package org.diacaustic.study;

import java.io.IOException;
import java.util.Map;
import org.diacaustic.parallel.Workers;

/**
 * Light that comes through what does not bend it, by straight shadow rays: what they let through, minus what they find if
 * everything transparent stops them, from the same eye rays. Exact at every eye ray; only pixels in which the light has an
 * edge or is uneven have an error, of how eye rays are spread over the pixel.
 */
final class StraightLight {
    private final TechniqueRender through;
    private final TechniqueRender stopped;
    private final PixelBatches batches;

    /**
     * @param samples eye rays of a pixel in each batch
     * @throws IOException if the scene cannot be read
     */
    StraightLight(SceneSource source, int samples, int width, int height, Workers workers) throws IOException {
        this.through = render(source, "non-refractive", samples, workers);
        this.stopped = render(source, "non-transparent", samples, workers);
        this.batches = new PixelBatches(width, height);
    }

    private static TechniqueRender render(SceneSource source, String shader, int samples, Workers workers)
            throws IOException {
        // What media absorb is missing in light traced forward, whatever the thesis' shading model did.
        Map<String, String> settings = Map.of(
                "shader",
                shader,
                "attenuation",
                "true",
                "preprocessor",
                "none",
                "map",
                "none",
                "samples",
                Integer.toString(samples));
        return new TechniqueRender(source, new Technique(shader, Technique.Way.OVER_A_MAP, settings, 0), workers);
    }

    /** Adds a batch with a seed of its own. */
    void add(long seed) {
        batches.add(through.directWith(seed), 1);
        batches.add(stopped.directWith(seed), -1);
        batches.next();
    }

    /** The batches so far. */
    PixelBatches batches() {
        return batches;
    }
}
