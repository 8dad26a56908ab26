package org.diacaustic.study;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;

/** A study as comma-separated values: a line a picture, and a line a point. */
final class StudyCsv {
    private final StudyReport report;

    StudyCsv(StudyReport report) {
        this.report = report;
    }

    /** Every picture with everything that was measured of it. */
    String runs() {
        List<List<String>> lines = new ArrayList<>();
        List<String> head = head();
        head.add("seed");
        for (Measure measure : Measure.values()) {
            head.add(measure.key());
        }
        lines.add(head);
        for (TechniqueStudy study : report.studies()) {
            for (StudyPoint point : study.points()) {
                for (StudyRun run : point.runs()) {
                    List<String> line = start(study.technique(), point);
                    line.add(Long.toString(run.seed()));
                    for (Measure measure : Measure.values()) {
                        line.add(number(run.get(measure)));
                    }
                    lines.add(line);
                }
            }
        }
        return text(lines);
    }

    /** Every point: the mean of each measure with its interval, and what the runs have wrong together and each alone. */
    String points() {
        List<List<String>> lines = new ArrayList<>();
        List<String> head = head();
        head.addAll(List.of("runs", "squaredBias", "variance", "referenceError", "resolved"));
        for (Measure measure : Measure.values()) {
            head.add(measure.key());
            head.add(measure.key() + "Low");
            head.add(measure.key() + "High");
        }
        lines.add(head);
        for (TechniqueStudy study : report.studies()) {
            for (StudyPoint point : study.points()) {
                List<String> line = start(study.technique(), point);
                line.add(Integer.toString(point.runs().size()));
                line.add(number(point.squaredBias()));
                line.add(number(point.variance()));
                line.add(number(point.referenceError()));
                line.add(Boolean.toString(point.isResolved()));
                for (Measure measure : Measure.values()) {
                    Distribution distribution = point.distribution(measure);
                    line.add(number(distribution.mean()));
                    line.add(number(distribution.meanInterval().low()));
                    line.add(number(distribution.meanInterval().high()));
                }
                lines.add(line);
            }
        }
        return text(lines);
    }

    private static List<String> head() {
        return new ArrayList<>(List.of("technique", "family", "preprocessor", "budget", "rays", "passes"));
    }

    private static List<String> start(Technique technique, StudyPoint point) {
        return new ArrayList<>(List.of(
                technique.name(),
                technique.family(),
                technique.preProcessor(),
                point.budget().label(),
                Long.toString(point.rays()),
                Integer.toString(point.passes())));
    }

    /** Empty if it is not a number. */
    private static String number(double value) {
        return Double.isNaN(value) ? "" : Double.toString(value);
    }

    private static String text(List<List<String>> lines) {
        return lines.stream()
                .map(line -> line.stream().map(StudyCsv::quoted).collect(Collectors.joining(",")))
                .collect(Collectors.joining("\n", "", "\n"));
    }

    /** As RFC 4180 wants it. */
    private static String quoted(String value) {
        boolean isPlain = value.chars().noneMatch(c -> c == ',' || c == '"' || c == '\n' || c == '\r');
        return isPlain ? value : '"' + value.replace("\"", "\"\"") + '"';
    }
}
