package org.diacaustic.reproduction;

import java.util.Comparator;
import org.diacaustic.image.ImageMetrics;
import org.diacaustic.image.LinearImage;

/** What can be measured in pictures. */
final class Pictures {
    private final Results results;

    Pictures(Results results) {
        this.results = results;
    }

    /**
     * How far a picture lies from non-refractive shading, root mean square over mean. In the control scene, where nothing
     * refracts, that shading is exact.
     */
    double error(Outcome outcome) {
        LinearImage reference = results.get(outcome.experiment().scene(), Method.NON_REFRACTIVE, MapKind.NONE)
                .picture();
        return ImageMetrics.of(outcome.picture(), reference).relativeRootMeanSquareError();
    }

    double error(ThesisScene scene, Method method, MapKind map) {
        return error(results.get(scene, method, map));
    }

    /** The outcome of a pre-processor whose picture is nearest to non-refractive shading. */
    Outcome best(ThesisScene scene) {
        return results.all().stream()
                .filter(outcome -> outcome.experiment().scene() == scene
                        && !outcome.experiment().method().isShadingModel())
                .min(Comparator.comparingDouble(this::error))
                .orElseThrow();
    }

    /** The largest channel of all pixels. */
    static double brightest(LinearImage image) {
        double largest = 0;
        for (float sample : image.samples()) {
            largest = Math.max(largest, sample);
        }
        return largest;
    }

    /** The part of neighbouring pixels, neither black nor as bright as can be, that are exactly alike. */
    static double flatness(LinearImage image) {
        long lit = 0;
        long alike = 0;
        for (int y = 0; y < image.height(); y++) {
            for (int x = 0; x + 1 < image.width(); x++) {
                float[] samples = image.samples();
                int i = image.offset(x, y);
                float here = samples[i];
                float next = samples[i + 3];
                if (here > 0 && next > 0 && here < 1 && next < 1) {
                    lit++;
                    alike += here == next && samples[i + 1] == samples[i + 4] && samples[i + 2] == samples[i + 5]
                            ? 1
                            : 0;
                }
            }
        }
        return lit == 0 ? 0 : (double) alike / lit;
    }
}
