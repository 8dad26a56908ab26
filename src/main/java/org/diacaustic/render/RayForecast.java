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

    /** The part of the eye pass' time that grows with the rays, at least. */
    private static final double GROWING_PART = 0.25;

    private final List<Measured> rounds = new ArrayList<>();
    private double best = Double.POSITIVE_INFINITY;
    private int inVain;

    /**
     * What a round had and took.
     *
     * @param error estimated
     * @param lightSeconds of following light rays and making maps
     * @param eyeSeconds of all else
     * @param mapBytes of the maps
     */
    record Measured(long rays, double error, double lightSeconds, double eyeSeconds, long mapBytes) {}

    void add(Measured round) {
        inVain = round.error < PROGRESS * best ? 0 : inVain + 1;
        best = Math.min(best, round.error);
        rounds.add(round);
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
        Measured before = rounds.get(rounds.size() - 2);
        double slope = StrictMath.log(last().error / before.error) / StrictMath.log((double) last().rays / before.rays);
        // What is not a number, after pictures without light, is no progress.
        return slope < FLATTEST ? Math.max(STEEPEST, slope) : FLATTEST;
    }

    /** The most rays of a round that ends within so many seconds. */
    long raysForSeconds(double seconds) {
        double growing = last().eyeSeconds * growingPart();
        double fixed = last().eyeSeconds - growing;
        return times(Math.max(0, (seconds - fixed) / (last().lightSeconds + growing)));
    }

    /** The part of the last eye pass' time that is proportional to the rays. */
    private double growingPart() {
        if (rounds.size() == 1) {
            return GROWING_PART;
        }
        Measured before = rounds.get(rounds.size() - 2);
        double perRay = (last().eyeSeconds - before.eyeSeconds) / (last().rays - before.rays);
        return Math.max(GROWING_PART, Math.min(1, perRay * last().rays / last().eyeSeconds));
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
