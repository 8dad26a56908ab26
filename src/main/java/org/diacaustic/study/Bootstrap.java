package org.diacaustic.study;

import java.util.Arrays;
import org.diacaustic.math.SampleStream;

/**
 * An interval for the true mean of a few numbers of unknown distribution: the studentised bootstrap [Efron and Tibshirani
 * 1993, ch. 12.5], smoothed. Samples are drawn from the numbers, each moved by chance within ±√3·s/√n of itself, s their
 * standard deviation: that makes up for their being spread less than what they are drawn from, and for samples that hold but
 * one number again and again. Of each, (mean − mean of all) ÷ its own standard error is kept; what lies between the 2.5th and
 * 97.5th percentile of those says how far off the mean may be, to either side.
 *
 * <p>Intervals of 3, 5, 8 and 20 numbers hold the true mean in so many per cent of 6000 trials: normal 95, 95, 95, 95;
 * lengths of normal vectors of 8 dimensions, which root mean square errors are like, 95, 95, 94, 95; their squares, of 4
 * dimensions, 93, 94, 94, 94; log-normal with σ = 0.3: 95, 94, 95, 94; log-normal with σ = 1, so skew that no method holds without
 * knowing it: 87, 87, 88, 92. Student's intervals hold those in 84, 82, 83, 87. Plain percentiles hold 76, 84, 88, 92 of normal
 * numbers and 66, 74, 79, 85 of the skew ones, corrected ones (BCa) 71, 85, 88, 93 and 59, 76, 81, 87. On logarithms nothing is
 * won, and means of either sign are lost.
 */
final class Bootstrap {
    private static final int SAMPLES = 2000;
    private static final double OUTSIDE = 0.025;

    /** The same numbers are to have the same interval. */
    private static final long SEED = 0x5EED;

    /** Of a distribution uniform in ±1 the standard deviation is 1/√3. */
    private static final double ROOT_3 = Math.sqrt(3);

    private static final double LOW_BITS = 0x1p-32;

    private Bootstrap() {}

    /**
     * The interval that holds the true mean with a chance of 95 %. Equal numbers have no chance in them, and the interval is
     * that number alone. It may reach below 0 though all numbers are positive, if they are few and far apart.
     *
     * @param values finite; of fewer than two the interval is unknown
     */
    static Interval ofMean(double[] values) {
        int n = values.length;
        if (n < 2) {
            return Interval.UNKNOWN;
        }
        double mean = Arrays.stream(values).sum() / n;
        double variance = 0;
        for (double value : values) {
            variance += (value - mean) * (value - mean) / (n - 1);
        }
        if (Arrays.stream(values).allMatch(value -> value == values[0])) {
            return new Interval(values[0], values[0]);
        }
        double standardError = Math.sqrt(variance / n);
        double[] quotients = quotients(values, mean, ROOT_3 * standardError);
        Arrays.sort(quotients);
        return new Interval(
                mean - percentile(quotients, 1 - OUTSIDE) * standardError,
                mean - percentile(quotients, OUTSIDE) * standardError);
    }

    /** (Mean − true mean) ÷ standard error of many samples. */
    private static double[] quotients(double[] values, double mean, double reach) {
        int n = values.length;
        double[] quotients = new double[SAMPLES];
        SampleStream random = new SampleStream();
        random.start(SEED, n, 0);
        for (int sample = 0; sample < SAMPLES; sample++) {
            double sum = 0;
            double squares = 0;
            for (int i = 0; i < n; i++) {
                // 32 bits say which number, and 32 how far it is moved.
                long bits = random.nextLong();
                int which = (int) ((bits >>> 32) * n >>> 32);
                double off = values[which] - mean + reach * (2 * LOW_BITS * (bits & 0xFFFFFFFFL) - 1);
                sum += off;
                squares += off * off;
            }
            double variance = (squares - sum * sum / n) / (n - 1);
            quotients[sample] = sum / Math.sqrt(variance * n);
        }
        return quotients;
    }

    private static double percentile(double[] sorted, double part) {
        double place = part * (sorted.length - 1);
        int below = (int) place;
        return sorted[below] + (place - below) * (sorted[below + 1] - sorted[below]);
    }
}
