package org.diacaustic.render;

import java.util.ArrayList;
import java.util.List;

/**
 * What rounds of a caustic mesh tell of further ones: how many light rays an error needs, and how many a time and a memory
 * allow. All but the error is foretold rather too dear than too cheap.
 */
final class RayForecast {
    /** The slope of log error against log rays, as long as one round does not tell it. */
    private static final double FIRST_SLOPE = -0.75;

    private static final double STEEPEST = -1.1;
    private static final double FLATTEST = -0.4;

    /** Aims at less than what is asked, so that one round gets there rather than two. */
    private static final double AIM = 0.85;

    private static final double LEAST_GROWTH = 2;
    private static final double LARGEST_GROWTH = 16;

    /** A round that is no better than this part of the best before it is no progress. */
    private static final double PROGRESS = 0.95;

    /** What building maps takes meanwhile ÷ what they take in the end. */
    private static final double PEAK = 2;

    /** The slope of log seconds against log rays of making maps: the machine gets faster yet while it works. */
    private static final double LIGHT_SLOPE = 0.9;

    /** As above of asking maps, as long as one round does not tell it. */
    private static final double FIRST_LOOKUP_SLOPE = 0.75;

    /** The slope of asking maps gets steeper as more and more cells lie in a pixel, and ends at 1. */
    private static final double STEEPENING = 0.2;

    private static final double LARGEST_TIMES = 0x1p40;

    private final List<Measured> rounds = new ArrayList<>();
    private double best = Double.POSITIVE_INFINITY;
    private int inVain;

    /**
     * What a round had and took.
     *
     * @param error estimated
     * @param lightSeconds of following light rays and making maps
     * @param eyeSeconds of all else
     * @param lookups nodes that were looked at in maps
     * @param tests of rays, which are as many however fine the maps are
     * @param testsOnce those of them that no further round needs
     * @param mapBytes of the maps
     */
    record Measured(
            long rays,
            double error,
            double lightSeconds,
            double eyeSeconds,
            long lookups,
            long tests,
            long testsOnce,
            long mapBytes) {}

    void add(Measured round) {
        inVain = round.error < PROGRESS * best ? 0 : inVain + 1;
        best = Math.min(best, round.error);
        rounds.add(round);
    }

    private Measured before() {
        return rounds.get(rounds.size() - 2);
    }

    private Measured last() {
        return rounds.get(rounds.size() - 1);
    }

    /** The rays of the last round. */
    long rays() {
        return last().rays;
    }

    /** Whether two rounds in a row brought nothing. */
    boolean isStuck() {
        return inVain >= 2;
    }

    /** The rays that bring the error to the target, if that is within reach of one round. */
    long raysForError(double target) {
        double needed = StrictMath.pow(AIM * target / last().error, 1 / slope());
        return times(Math.max(LEAST_GROWTH, Math.min(LARGEST_GROWTH, needed)));
    }

    private double slope() {
        if (rounds.size() == 1) {
            return FIRST_SLOPE;
        }
        double slope = slope(before().error, last().error);
        // What is not a number, after pictures without light, is no progress.
        return slope < FLATTEST ? Math.max(STEEPEST, slope) : FLATTEST;
    }

    /** The most rays of a round that ends within so many seconds; 0 if none does. */
    long raysForSeconds(double seconds) {
        double fits = 0;
        double fitsNot = LARGEST_TIMES;
        // By bisection, to a thousandth.
        while (fitsNot > 1.001 * fits && fitsNot > 0x1p-20) {
            double times = fits == 0 ? fitsNot / 2 : Math.sqrt(fits * fitsNot);
            if (seconds(times) <= seconds) {
                fits = times;
            } else {
                fitsNot = times;
            }
        }
        return times(fits);
    }

    /** The seconds of a round with so many times the rays of the last. */
    double seconds(double times) {
        Measured last = last();
        double eyeWork = last.lookups * StrictMath.pow(times, lookupSlope()) + (last.tests - last.testsOnce);
        return last.lightSeconds * StrictMath.pow(times, LIGHT_SLOPE)
                + last.eyeSeconds * eyeWork / Math.max(1, last.lookups + last.tests);
    }

    /** The slope of the logarithm of lookups against that of rays. */
    private double lookupSlope() {
        if (rounds.size() == 1) {
            return FIRST_LOOKUP_SLOPE;
        }
        double slope = slope(before().lookups, last().lookups);
        return slope > 0 ? Math.min(1, slope + STEEPENING) : STEEPENING;
    }

    private double slope(double valueBefore, double valueLast) {
        return StrictMath.log(valueLast / valueBefore) / StrictMath.log((double) last().rays / before().rays);
    }

    /** Whether a single round was measured yet. */
    boolean isFirst() {
        return rounds.size() == 1;
    }

    /** The most rays whose maps can be made in so many bytes. */
    long raysForBytes(double bytes) {
        return times(bytes / (PEAK * last().mapBytes));
    }

    private long times(double growth) {
        double rays = growth * last().rays;
        return rays < Long.MAX_VALUE ? (long) rays : Long.MAX_VALUE;
    }
}
