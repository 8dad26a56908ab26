package org.diacaustic.study;

import java.util.List;
import java.util.function.Predicate;
import java.util.function.ToDoubleFunction;

/**
 * What a technique did, from small budgets to large ones.
 *
 * @param points in the order of their budgets; none if the technique was refused, or its turn has not come
 * @param refusal why it cannot render the scene; empty if it can
 */
public record TechniqueStudy(Technique technique, List<StudyPoint> points, String refusal) {
    /** Squared bias is told if it is this many times as large as what else is in it. */
    private static final double CLEAR = 4;

    public TechniqueStudy {
        points = List.copyOf(points);
    }

    /**
     * How the root mean square error falls with what it costs, of single runs. Points that the reference does not resolve are
     * left out.
     */
    public PowerFit errorFit(Measure cost) {
        List<StudyPoint> resolved =
                points.stream().filter(StudyPoint::isResolved).toList();
        return PowerFit.ofGroups(
                resolved.stream().map(point -> point.values(cost)).toList(),
                resolved.stream().map(point -> point.values(Measure.RMS_ERROR)).toList());
    }

    /** How the variance of a picture falls with its light rays, of points. */
    public PowerFit varianceFit() {
        return fit(StudyPoint::variance, point -> true);
    }

    /**
     * How the squared bias falls with light rays, of points. Left out are points where it is not clearly more than the squared
     * error of the reference, or less than the chance that was taken out of it.
     */
    public PowerFit biasFit() {
        return fit(StudyPoint::squaredBias, TechniqueStudy::isBiasTold);
    }

    /** The mean of so many pictures still varies by variance ÷ pictures, and as much was taken out. */
    public static boolean isBiasTold(StudyPoint point) {
        double reference = point.referenceError() * point.referenceError();
        double chance = point.variance() / point.runs().size();
        return point.squaredBias() > CLEAR * reference && point.squaredBias() > chance;
    }

    private PowerFit fit(ToDoubleFunction<StudyPoint> value, Predicate<StudyPoint> counts) {
        List<StudyPoint> counting = points.stream().filter(counts).toList();
        return PowerFit.of(
                counting.stream().mapToDouble(StudyPoint::rays).toArray(),
                counting.stream().mapToDouble(value).toArray());
    }
}
