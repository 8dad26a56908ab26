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
 * @param noiseEstimate the standard error over the passes: root of the mean square ÷ mean of the picture. What all passes have
 *     wrong in the same way, such as light spread by a gather radius, is not in it. Not a number if there is no telling from one pass
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
        double noiseEstimate,
        Counters counters,
        ForwardTotals forward,
        int threads,
        int tilesDone,
        int tilesTotal,
        double seconds) {
    /** Halving cells divides their error by four, so a third of what that changed is left. */
    private static final double ERROR_OF_CHANGE = 1.0 / 3;

    /** Whether the whole picture was rendered, and not cancelled. */
    public boolean isComplete() {
        return tilesDone == tilesTotal;
    }

    /**
     * About the error of each pixel for the light that the map brought, in its unit; nothing if there is no telling. Of single
     * pixels it tells less than of the picture: where two maps agree by chance it is small.
     */
    public Optional<LinearImage> errorPicture() {
        if (differences == null) {
            return Optional.empty();
        }
        LinearImage picture = new LinearImage(differences.width(), differences.height());
        float[] changes = differences.samples();
        for (int i = 0; i < changes.length; i++) {
            picture.samples()[i] = (float) (Math.abs(changes[i]) * ERROR_OF_CHANGE);
        }
        return Optional.of(picture);
    }

    /**
     * About the error of the picture for the light that the map brought: root of the mean square ÷ mean of the picture; not a
     * number if there is no telling.
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
        // Nothing is wrong with a picture that stays black.
        return squares == 0 ? 0 : Math.sqrt(squares / values.length) / (sum / values.length) * ERROR_OF_CHANGE;
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
