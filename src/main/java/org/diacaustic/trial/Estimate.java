package org.diacaustic.trial;

import java.util.Arrays;
import java.util.function.LongToDoubleFunction;
import org.diacaustic.stability.Checks;

/** A number that chance has a part in, from independent runs, and the standard error of its mean. */
final class Estimate {
    /** Independent runs, of seeds {@link #FIRST_SEED} and following. */
    static final int RUNS = 16;

    static final long FIRST_SEED = 1000;

    /** Student's t of 15 degrees of freedom is beyond this as seldom as a normal number is beyond 4. */
    private static final double FOUR_SIGMA = 5.48;

    /** Where chance has next to no part, rounding has: some units in the last place. */
    private static final double ROUNDING = 0x1p-48;

    private final double mean;
    private final double standardError;

    private Estimate(double mean, double standardError) {
        this.mean = mean;
        this.standardError = standardError;
    }

    static Estimate of(double... runs) {
        int count = runs.length;
        double mean = Arrays.stream(runs).sum() / count;
        double squares = 0;
        for (double run : runs) {
            squares += (run - mean) * (run - mean);
        }
        return new Estimate(mean, Math.sqrt(squares / (count - 1) / count));
    }

    /** @param run of a seed */
    static Estimate over(LongToDoubleFunction run) {
        double[] runs = new double[RUNS];
        for (int i = 0; i < RUNS; i++) {
            runs[i] = run.applyAsDouble(FIRST_SEED + i);
        }
        return of(runs);
    }

    /**
     * The same with a limit that is not below 4 sigma of a normal number: of few photons, runs that happen to be alike tell too
     * little.
     *
     * @param sigma of the mean, as theory has it
     */
    Estimate atLeast(double sigma) {
        return new Estimate(mean, Math.max(standardError, sigma * 4 / FOUR_SIGMA));
    }

    /** How many standard errors the mean is above what it should be. */
    double score(double expected) {
        return mean == expected ? 0 : (mean - expected) / standardError;
    }

    /** Compares the mean with what it should be, at the level of 4 standard deviations. */
    void check(Checks checks, String what, double expected) {
        double error = Math.max(standardError, ROUNDING * Math.max(Math.abs(expected), Math.abs(mean)));
        checks.statistic(what, expected, mean, error, FOUR_SIGMA);
    }
}
