package org.diacaustic.render;

import java.util.Optional;
import org.diacaustic.image.LinearImage;
import org.diacaustic.preprocess.ForwardTotals;

/**
 * What a render made.
 *
 * @param image linear radiance; black where a cancelled render did not come
 * @param counters what was done
 * @param forward what the forward passes did; all zeros if there were none
 * @param threads how many threads did it
 * @param tilesDone finished tiles, of all passes
 * @param tilesTotal tiles of the whole picture, in all passes
 * @param seconds of the eye passes, wall clock
 */
public record Rendering(
        LinearImage image,
        Counters counters,
        ForwardTotals forward,
        int threads,
        int tilesDone,
        int tilesTotal,
        double seconds) {

    /** Whether the whole picture was rendered, and not cancelled. */
    public boolean isComplete() {
        return tilesDone == tilesTotal;
    }

    /** How many samples were infinite or not a number, and where the first was; nothing if all was well. */
    public Optional<String> nonFiniteReport() {
        if (counters.nonFiniteSamples() == 0) {
            return Optional.empty();
        }
        long pixel = counters.firstNonFinitePixel;
        return Optional.of(counters.nonFiniteSamples() + " samples were infinite or not a number and are left out, the"
                + " first at pixel " + pixel % image.width() + ", " + pixel / image.width());
    }
}
