package org.diacaustic.render;

import org.diacaustic.image.LinearImage;

/**
 * What a render made.
 *
 * @param image linear radiance; black where a cancelled render did not come
 * @param counters what was done
 * @param threads how many threads did it
 * @param tilesDone finished tiles
 * @param tilesTotal tiles of the whole picture
 * @param seconds of the eye pass, wall clock
 */
public record Rendering(
        LinearImage image, Counters counters, int threads, int tilesDone, int tilesTotal, double seconds) {

    /** Whether the whole picture was rendered, and not cancelled. */
    public boolean isComplete() {
        return tilesDone == tilesTotal;
    }
}
