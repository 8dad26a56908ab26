package org.diacaustic.page;

import org.diacaustic.image.DifferenceImage;
import org.diacaustic.image.LinearImage;
import org.diacaustic.study.StudyReport;

/** Pictures of errors: red where too bright, blue where too dark, grey where pixels did not count. One scale for all. */
final class ErrorMaps {
    /** Of the colour of a pixel that did not count, what is left. */
    private static final double LEFT = 0.1;

    private static final double GREY = 0.03;

    /**
     * Differences are rounded to this part of the scale: nobody sees finer steps, and the pictures of a page take half the bytes.
     */
    private static final double STEP = 1.0 / 24;

    private final LinearImage counted;
    private final double mean;

    ErrorMaps(StudyReport report) {
        counted = report.counted();
        mean = report.referenceMean();
    }

    /**
     * The map of a picture.
     *
     * @param scale the difference that has the full colour, as a part of the mean of the reference
     */
    LinearImage of(LinearImage picture, LinearImage reference, double scale) {
        double full = scale * mean;
        LinearImage map = DifferenceImage.of(rounded(picture, reference, full), reference, full)
                .picture();
        float[] samples = map.samples();
        for (int i = 0; i < samples.length; i++) {
            if (counted.samples()[i] == 0) {
                samples[i] = (float) (GREY + LEFT * samples[i]);
            }
        }
        return map;
    }

    private static LinearImage rounded(LinearImage picture, LinearImage reference, double full) {
        LinearImage rounded = new LinearImage(picture.width(), picture.height());
        for (int i = 0; i < rounded.samples().length; i++) {
            double difference = (double) picture.samples()[i] - reference.samples()[i];
            // What is not finite stays so, and is shown green.
            double step =
                    Double.isFinite(difference) ? Math.rint(difference / (STEP * full)) * (STEP * full) : difference;
            rounded.samples()[i] = (float) (reference.samples()[i] + step);
        }
        return rounded;
    }

    /** From fully too dark to fully too bright, to be laid beside numbers. */
    static LinearImage ramp() {
        int steps = (int) Math.round(1 / STEP);
        LinearImage ramp = new LinearImage(2 * steps + 1, 1);
        for (int x = 0; x < ramp.width(); x++) {
            double difference = (double) (x - steps) / steps;
            ramp.set(x, 0, difference, difference, difference);
        }
        return DifferenceImage.of(ramp, new LinearImage(ramp.width(), 1), 1).picture();
    }

    /** How two halves of a reference differ. */
    LinearImage ofHalves(LinearImage halves, double scale) {
        return of(halves, new LinearImage(halves.width(), halves.height()), scale);
    }

    /** The round number, 1, 2 or 5 times a power of ten, next above. */
    static double roundAbove(double value) {
        if (!(value > 0 && value < Double.POSITIVE_INFINITY)) {
            return 1;
        }
        int power = (int) Math.floor(Math.log10(value));
        for (int step : new int[] {1, 2, 5}) {
            double round = Double.parseDouble(step + "e" + power);
            if (round >= value) {
                return round;
            }
        }
        return Double.parseDouble("1e" + (power + 1));
    }
}
