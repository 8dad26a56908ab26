package org.diacaustic.page;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.diacaustic.study.Measure;
import org.diacaustic.study.ShadingStudy;
import org.diacaustic.study.StudyPoint;
import org.diacaustic.study.StudyReport;
import org.diacaustic.study.TechniqueStudy;

/** What a study shows, in sentences, each computed from its numbers. */
final class Findings {
    /** Less of the light than this is rounding. */
    private static final double NOTHING = 1e-6;

    /** An error that is more than this part of what it was at the middle budget has not become smaller. */
    private static final double STAYS = 0.95;

    private final StudyReport report;
    private final List<TechniqueStudy> started;

    private Findings(StudyReport report) {
        this.report = report;
        this.started = new StudyNumbers(report).started();
    }

    /** All that there is to say, the most important first. */
    static List<Finding> of(StudyReport report) {
        Findings findings = new Findings(report);
        List<Finding> all = new ArrayList<>();
        all.addAll(WrongBrightness.of(findings.started));
        all.addAll(EqualTime.of(report));
        all.addAll(findings.stuck());
        report.shading().stream().map(Findings::shading).forEach(all::add);
        all.addAll(findings.refused());
        findings.unresolved().ifPresent(all::add);
        findings.single().ifPresent(all::add);
        all.sort(Comparator.comparing(Finding::kind));
        return all;
    }

    /** Techniques whose error is no smaller at the largest budget than at the middle one, by what is left of it. */
    private List<Finding> stuck() {
        Map<String, List<String>> stuck = new LinkedHashMap<>();
        for (TechniqueStudy study : started) {
            StudyPoint middle = study.points().get(study.points().size() / 2);
            StudyPoint last = StudyNumbers.last(study);
            if (last.rays() > middle.rays() && last.isResolved() && last.error() > STAYS * middle.error()) {
                stuck.computeIfAbsent(whatIsLeft(last), reason -> new ArrayList<>())
                        .add(study.technique().name() + " (" + Numbers.percent(middle.error()) + " with "
                                + Numbers.count(middle.rays()) + " rays, " + Numbers.percent(last.error()) + " with "
                                + Numbers.count(last.rays()) + ")");
            }
        }
        return stuck.entrySet().stream()
                .map(entry -> new Finding(
                        Finding.Kind.STUCK,
                        "More rays do not help " + String.join(", ", entry.getValue()) + entry.getKey()))
                .toList();
    }

    private static String whatIsLeft(StudyPoint point) {
        if (TechniqueStudy.isBiasTold(point) && point.squaredBias() > point.variance()) {
            return ": what is left is bias, of the estimate or of too few eye rays.";
        }
        return point.variance() > point.squaredBias() ? ": what is left is chance." : ".";
    }

    private static Finding shading(ShadingStudy study) {
        double brought = 1 + study.run().get(Measure.BRIGHTNESS);
        return new Finding(
                Finding.Kind.SHADING,
                "The shading model " + study.shader() + ", without light traced forward, has an error of "
                        + Numbers.percent(study.run().get(Measure.RMS_ERROR)) + " and brings "
                        + (Math.abs(brought) < NOTHING ? "none" : Numbers.percent(brought))
                        + " of the light that comes over specular surfaces.");
    }

    /** Techniques that were refused for the same reason are told together. */
    private List<Finding> refused() {
        Map<String, List<String>> names = report.studies().stream()
                .filter(study -> !study.refusal().isEmpty())
                .collect(Collectors.groupingBy(
                        TechniqueStudy::refusal,
                        LinkedHashMap::new,
                        Collectors.mapping(study -> study.technique().name(), Collectors.toList())));
        return names.entrySet().stream()
                .map(entry -> new Finding(
                        Finding.Kind.REFUSED,
                        "Refused: " + String.join(", ", entry.getValue()) + ": " + entry.getKey()))
                .toList();
    }

    private Optional<Finding> unresolved() {
        long count = points().filter(point -> !point.isResolved()).count();
        double least = StudyPoint.REFERENCE_MARGIN
                * points().mapToDouble(StudyPoint::referenceError).max().orElse(0);
        return count == 0 || !(least > 0)
                ? Optional.empty()
                : Optional.of(new Finding(
                        Finding.Kind.NOTE,
                        "The reference tells no error below " + Numbers.percent(least) + "; " + count + " of "
                                + report.points() + " points are below."));
    }

    private Optional<Finding> single() {
        long count = points().filter(point -> point.runs().size() < 2).count();
        return count == 0
                ? Optional.empty()
                : Optional.of(new Finding(
                        Finding.Kind.NOTE,
                        count + " of " + report.points() + " points are single pictures: nothing tells their chance."));
    }

    private Stream<StudyPoint> points() {
        return started.stream().flatMap(study -> study.points().stream());
    }
}
