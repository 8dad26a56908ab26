package org.diacaustic.study;

import java.util.List;

/**
 * What a technique did with one budget: the same picture again and again, each time with another seed.
 *
 * @param rays light rays chosen for a picture, in all passes together
 * @param passes whose pictures were averaged for one
 * @param squaredBias mean over the pixels of (mean of the pictures − reference)², without what chance and the noise of the
 *     reference put into it, ÷ mean²; may be below 0 by chance. Not a number if there is one run only
 * @param variance mean over the pixels of the variance of a single picture ÷ mean²; not a number if there is one run only
 * @param referenceError of the reference itself, as a root mean square
 * @param runs in the order of their seeds, at least one
 */
public record StudyPoint(
        Budget budget,
        long rays,
        int passes,
        double squaredBias,
        double variance,
        double referenceError,
        List<StudyRun> runs) {
    /** An error is told only if the reference's own is this many times smaller. */
    public static final double REFERENCE_MARGIN = 5;

    public StudyPoint {
        runs = List.copyOf(runs);
        if (runs.isEmpty()) {
            throw new IllegalArgumentException("a point of a study needs at least one run");
        }
    }

    /** How a measure is spread over the runs. */
    public Distribution distribution(Measure measure) {
        return Distribution.of(values(measure));
    }

    /** A measure of each run. */
    double[] values(Measure measure) {
        return runs.stream().mapToDouble(run -> run.get(measure)).toArray();
    }

    /** The mean of a measure over the runs. */
    public double mean(Measure measure) {
        return Distribution.mean(values(measure));
    }

    /** The root mean square error, as the mean over the runs. */
    public double error() {
        return mean(Measure.RMS_ERROR);
    }

    /** Whether the reference is good enough to tell this error. */
    public boolean isResolved() {
        return error() > 0 && error() >= REFERENCE_MARGIN * referenceError;
    }

    /** The error; where the reference does not resolve it, the least that it could have told. */
    public double shownError() {
        return isResolved() ? error() : Math.max(error(), referenceError);
    }
}
