package org.diacaustic.render;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.diacaustic.image.LinearImage;
import org.diacaustic.preprocess.ForwardTotals;

/**
 * What a render made.
 *
 * @param image linear radiance; black where a cancelled render did not come
 * @param differences by how much pixels would change with a map half as fine; null if there was none
 * @param counters what was done
 * @param forward what the forward passes did; all zeros if there were none
 * @param threads how many threads did it
 * @param tilesDone finished tiles, of all passes
 * @param tilesTotal tiles of the whole picture, in all passes
 * @param seconds of the eye passes, wall clock
 */
public record Rendering(
        LinearImage image,
        LinearImage differences,
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

    /**
     * About the error of the picture for the light that the map brought: root of the mean square ÷ mean of the picture; not a
     * number if there is no telling. Halving the cells divides their error by four, so a third of what that changes is left.
     */
    public double errorEstimate() {
        if (differences == null) {
            return Double.NaN;
        }
        double squares = 0;
        double sum = 0;
        float[] values = image.samples();
        float[] changes = differences.samples();
        for (int i = 0; i < values.length; i++) {
            squares += (double) changes[i] * changes[i];
            sum += values[i];
        }
        return Math.sqrt(squares / values.length) / (sum / values.length) / 3;
    }

    /** How much was infinite or not a number, and where the first of it was; nothing if all was well. */
    public Optional<String> nonFiniteReport() {
        List<String> found = new ArrayList<>();
        if (counters.nonFiniteSamples() > 0) {
            long pixel = counters.firstNonFinitePixel;
            found.add(counters.nonFiniteSamples() + " samples were infinite or not a number and are left out, the"
                    + " first at pixel " + pixel % image.width() + ", " + pixel / image.width());
        }
        if (forward.counters().nonFinite() > 0) {
            found.add(
                    forward.counters().nonFinite() + " light rays came to what is infinite or not a number, and ended");
        }
        return found.isEmpty() ? Optional.empty() : Optional.of(String.join("; ", found));
    }
}
