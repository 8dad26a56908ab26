package org.diacaustic.page;

import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import org.diacaustic.study.Measure;
import org.diacaustic.study.StudyPoint;
import org.diacaustic.study.TechniqueStudy;

/**
 * Points of different techniques that are about equal in one respect: of each the one nearest below a limit, which is laid so that
 * as many techniques as can be come close to it.
 *
 * @param limit in the unit of what is to be equal
 * @param points of those that have one, in the order of the techniques
 */
record EqualChoice(double limit, Map<TechniqueStudy, StudyPoint> points) {
    /** Close is what is at least this part of the limit. */
    private static final double CLOSE = 0.5;

    /** Points of about equal processor time: of each technique the one that takes the most of it. */
    static EqualChoice ofTime(List<TechniqueStudy> studies) {
        return of(studies, EqualChoice::time, Comparator.comparingDouble(EqualChoice::time), true);
    }

    /** Points within a processor time that is given. */
    static EqualChoice withinTime(List<TechniqueStudy> studies, double limit) {
        return choice(studies, EqualChoice::time, Comparator.comparingDouble(EqualChoice::time), limit);
    }

    /** Points of about equal error: of each technique the one that takes the least time. */
    static EqualChoice ofError(List<TechniqueStudy> studies) {
        Comparator<StudyPoint> byTime = Comparator.comparingDouble(EqualChoice::time);
        return of(studies, StudyPoint::shownError, byTime.reversed(), false);
    }

    private static double time(StudyPoint point) {
        return point.mean(Measure.PROCESSOR_SECONDS);
    }

    /**
     * Lays the limit.
     *
     * @param worth the greatest of the points below the limit is taken
     * @param isLast whether the largest of limits that are met as often is taken; otherwise the least
     */
    private static EqualChoice of(
            List<TechniqueStudy> studies,
            ToDoubleFunction<StudyPoint> value,
            Comparator<StudyPoint> worth,
            boolean isLast) {
        double best = 0;
        long most = 0;
        double[] limits = studies.stream()
                .flatMap(study -> study.points().stream())
                .mapToDouble(value)
                .filter(limit -> limit > 0)
                .sorted()
                .toArray();
        for (double limit : limits) {
            long close = studies.stream()
                    .filter(study -> below(study, value, limit, worth)
                            .filter(point -> value.applyAsDouble(point) >= CLOSE * limit)
                            .isPresent())
                    .count();
            if (close > most || isLast && close == most) {
                most = close;
                best = limit;
            }
        }
        return choice(studies, value, worth, best);
    }

    private static EqualChoice choice(
            List<TechniqueStudy> studies,
            ToDoubleFunction<StudyPoint> value,
            Comparator<StudyPoint> worth,
            double limit) {
        Map<TechniqueStudy, StudyPoint> points = new LinkedHashMap<>();
        for (TechniqueStudy study : studies) {
            below(study, value, limit, worth).ifPresent(point -> points.put(study, point));
        }
        return new EqualChoice(limit, points);
    }

    private static Optional<StudyPoint> below(
            TechniqueStudy study, ToDoubleFunction<StudyPoint> value, double limit, Comparator<StudyPoint> worth) {
        return study.points().stream()
                .filter(point -> value.applyAsDouble(point) <= limit)
                .max(worth);
    }
}
