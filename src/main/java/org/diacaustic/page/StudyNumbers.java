package org.diacaustic.page;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.EnumMap;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.diacaustic.study.Distribution;
import org.diacaustic.study.Measure;
import org.diacaustic.study.StudyPoint;
import org.diacaustic.study.StudyReport;
import org.diacaustic.study.TechniqueStudy;

/** The numbers of a report that charts and tables ask for again and again, each worked out once. */
final class StudyNumbers {
    private final StudyReport report;
    private final Map<StudyPoint, Map<Measure, Distribution>> distributions = new IdentityHashMap<>();

    StudyNumbers(StudyReport report) {
        this.report = report;
    }

    StudyReport report() {
        return report;
    }

    /** The techniques that have points. */
    List<TechniqueStudy> started() {
        return report.studies().stream()
                .filter(study -> !study.points().isEmpty())
                .toList();
    }

    /** The techniques that have points, by how their light is kept and read. */
    Map<String, List<TechniqueStudy>> families() {
        Map<String, List<TechniqueStudy>> families = new LinkedHashMap<>();
        for (TechniqueStudy study : started()) {
            families.computeIfAbsent(study.technique().family(), name -> new ArrayList<>())
                    .add(study);
        }
        return families;
    }

    Distribution distribution(StudyPoint point, Measure measure) {
        return distributions
                .computeIfAbsent(point, key -> new EnumMap<>(Measure.class))
                .computeIfAbsent(measure, point::distribution);
    }

    static StudyPoint last(TechniqueStudy study) {
        return study.points().get(study.points().size() - 1);
    }

    /** The largest mean cost that all of the techniques come to. */
    double commonCost(List<TechniqueStudy> studies, Measure cost) {
        return studies.stream()
                .mapToDouble(study -> study.points().stream()
                        .mapToDouble(point -> point.mean(cost))
                        .max()
                        .orElseThrow())
                .min()
                .orElse(Double.NaN);
    }

    /**
     * The error of a technique at a cost, on straight lines between its points in logarithms; beyond its points that of the first
     * or last one.
     */
    double errorAt(TechniqueStudy study, Measure cost, double value) {
        StudyPoint before = study.points().get(0);
        for (StudyPoint point : study.points()) {
            double end = point.mean(cost);
            if (end >= value) {
                double start = before.mean(cost);
                if (end == start || value <= start) {
                    return (start >= value ? before : point).shownError();
                }
                double share = Math.log(value / start) / Math.log(end / start);
                return Math.pow(before.shownError(), 1 - share) * Math.pow(point.shownError(), share);
            }
            before = point;
        }
        return before.shownError();
    }

    /** The technique with the least error at the largest cost that all come to. */
    TechniqueStudy best(List<TechniqueStudy> studies, Measure cost) {
        double common = commonCost(studies, cost);
        return studies.stream()
                .min(Comparator.comparingDouble(study -> errorAt(study, cost, common)))
                .orElseThrow();
    }
}
