package org.diacaustic.trial;

import java.math.BigDecimal;
import java.util.Arrays;
import org.diacaustic.map.Estimator;
import org.diacaustic.stability.Checks;
import org.diacaustic.stability.NumericCase;
import org.diacaustic.stability.Operations;

/** Radii that shrink from pass to pass. */
final class ProgressiveTrials {
    private static final String NUMBER_WHEN = "N_when_ratio_is_";

    /** No more passes are asked about. */
    private static final double MOST = 1e300;

    private ProgressiveTrials() {}

    static void addTo(Operations operations) {
        operations.add(
                "progressive_radius",
                "Estimator.progressiveRadius, which every pass of a progressive render asks, with the alpha of the case (renders"
                        + " take 2/3); the N for a ratio is found by bisection on it.",
                ProgressiveTrials::radius);
        operations.add(
                "ppm_slopes",
                "Progressive passes: 128 places on a floor whose irradiance rises with the square of the distance, each with"
                        + " random photons of its own in every pass (seed 1), PhotonMaps of the radii that"
                        + " Estimator.progressiveRadius gives, and the means of 50 to 5000 passes. Exponents of variance, bias"
                        + " and mean squared error over N by least squares; 95 % percentile intervals by 1000 bootstraps of the"
                        + " places.",
                ProgressiveTrials::slopes);
    }

    private static void radius(NumericCase asked, Checks checks) {
        double alpha = asked.inputs().number("alpha");
        double[] passes = asked.inputs().numbers("N");
        double[] ratios = Arrays.stream(passes)
                .map(pass -> Estimator.progressiveRadius(1, pass, alpha))
                .toArray();
        checks.numbers("ratio", ratios, "");
        for (String key : asked.expected().keys()) {
            if (key.startsWith(NUMBER_WHEN)) {
                double ratio = new BigDecimal(key.substring(NUMBER_WHEN.length())).doubleValue();
                checks.number(key, passes(ratio, alpha), "");
            }
        }
    }

    /** How many passes there are when the radius has come down to a ratio; infinite if that is beyond all numbers. */
    private static double passes(double ratio, double alpha) {
        double low = 1;
        double high = MOST;
        if (Estimator.progressiveRadius(1, high, alpha) > ratio) {
            return Double.POSITIVE_INFINITY;
        }
        double middle = Math.sqrt(low) * Math.sqrt(high);
        while (middle > low && middle < high) {
            if (Estimator.progressiveRadius(1, middle, alpha) > ratio) {
                low = middle;
            } else {
                high = middle;
            }
            middle = high > 2 * low ? Math.sqrt(low) * Math.sqrt(high) : low + 0.5 * (high - low);
        }
        return high;
    }

    private static void slopes(NumericCase asked, Checks checks) {
        ProgressivePasses passes = new ProgressivePasses(asked.inputs().number("alpha"));
        passes.run();
        for (ProgressivePasses.Measure measure : ProgressivePasses.Measure.values()) {
            String name = measure.exponentName();
            if (asked.expected().has(name)) {
                double[] interval = passes.exponent(measure);
                double expected = asked.expected().number(name);
                double middle = 0.5 * (interval[0] + interval[1]);
                checks.number(name + " in the 95 % interval", expected, middle, interval[1] - middle);
            }
        }
    }
}
