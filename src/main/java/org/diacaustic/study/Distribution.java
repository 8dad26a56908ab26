package org.diacaustic.study;

import java.util.Arrays;
import org.apache.commons.math3.stat.descriptive.rank.Percentile;

/**
 * How a number is spread over runs. If it is not a number in one of them, it is not in any of these.
 *
 * @param mean of the runs
 * @param band from the 5th to the 95th percentile of single runs; of fewer than 20 runs from the least to the largest, since
 *     what is beyond them is not known
 * @param meanInterval holds the true mean with a chance of 95 %, by {@link Bootstrap}; unknown of one run
 */
public record Distribution(int count, double mean, Interval band, Interval meanInterval) {
    private static final double LOW = 5;
    private static final double HIGH = 95;

    static Distribution of(double[] values) {
        double mean = mean(values);
        // What is infinite has a mean, but no spread.
        if (values.length < 2 || Double.isNaN(mean) || Double.isInfinite(mean)) {
            return new Distribution(values.length, mean, Interval.UNKNOWN, Interval.UNKNOWN);
        }
        // The r-th of n runs is taken for percentile 100·r/(n + 1), and the first and last for what lies beyond.
        Percentile percentile = new Percentile();
        percentile.setData(values);
        Interval band = new Interval(percentile.evaluate(LOW), percentile.evaluate(HIGH));
        return new Distribution(values.length, mean, band, Bootstrap.ofMean(values));
    }

    /** Not a number of no values. */
    static double mean(double[] values) {
        return Arrays.stream(values).sum() / values.length;
    }
}
