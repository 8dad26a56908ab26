package org.diacaustic.study;

import java.util.List;

/**
 * What it costs a technique to reach an error for good. Between points error is taken for a power of the cost. A line that
 * falls below the error and rises again has not reached it: the last crossing counts. Errors are means over runs.
 */
public sealed interface TimeToError {

    /**
     * It took this much.
     *
     * @param cost in the unit of its measure
     */
    record Reached(double cost) implements TimeToError {}

    /**
     * The first point is below the error already.
     *
     * @param cost of that point: it takes no more
     */
    record AtMost(double cost) implements TimeToError {}

    /**
     * The largest budget was not enough, or more than enough: an error that grows again is not reached for good.
     *
     * @param bestError the least mean error at any budget; not a number if there is no point
     */
    record NotReached(double bestError) implements TimeToError {}

    /**
     * The reference is not good enough to tell.
     *
     * @param leastError that it can tell
     */
    record NotResolved(double leastError) implements TimeToError {}

    /**
     * Finds it. Points where the cost is not known are left out.
     *
     * @param target root mean square error, positive
     * @param cost what is to be counted, such as {@link Measure#PROCESSOR_SECONDS}
     * @throws IllegalArgumentException if the target is not positive
     */
    static TimeToError of(TechniqueStudy study, double target, Measure cost) {
        if (!(target > 0)) {
            throw new IllegalArgumentException("an error to be reached must be positive, but is " + target);
        }
        List<StudyPoint> points =
                study.points().stream().filter(point -> point.mean(cost) > 0).toList();
        if (points.isEmpty()) {
            return new NotReached(Double.NaN);
        }
        StudyPoint last = points.get(points.size() - 1);
        if (last.isResolved() && last.error() > target) {
            return new NotReached(
                    points.stream().mapToDouble(StudyPoint::error).min().getAsDouble());
        }
        double least = StudyPoint.REFERENCE_MARGIN * last.referenceError();
        if (target < least) {
            return new NotResolved(least);
        }
        int below = points.size();
        while (below > 0 && points.get(below - 1).error() <= target) {
            below--;
        }
        if (below == points.size()) {
            return new NotReached(Double.NaN);
        }
        double costBelow = points.get(below).mean(cost);
        return below == 0
                ? new AtMost(costBelow)
                : new Reached(between(points.get(below - 1), points.get(below), target, cost));
    }

    /** What the target costs, on a straight line through the logarithms. */
    private static double between(StudyPoint above, StudyPoint below, double target, Measure cost) {
        double costBelow = below.mean(cost);
        // Nothing is known of how an error falls to zero.
        if (below.shownError() == 0) {
            return costBelow;
        }
        double error = Math.min(target, below.shownError());
        double part = Math.log(above.error() / target) / Math.log(above.error() / error);
        return above.mean(cost) * Math.pow(costBelow / above.mean(cost), part);
    }
}
