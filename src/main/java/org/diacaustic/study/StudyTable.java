package org.diacaustic.study;

import java.util.Locale;

/** A study as text in columns. */
final class StudyTable {
    private static final String HEAD = "%-24s %9s %5s %9s %9s %10s %10s %9s%n";
    private static final String LINE = "%-24s %9s %5d %9.3f %9.3f %10s %10.5f %+9.5f%n";

    private final StudyReport report;
    private final StringBuilder text = new StringBuilder();

    StudyTable(StudyReport report) {
        this.report = report;
    }

    String text() {
        add(HEAD, "technique", "budget", "runs", "seconds", "cpu", "rRMSE", "relMAE", "bias");
        report.studies().forEach(this::technique);
        for (ShadingStudy shading : report.shading()) {
            StudyRun run = shading.run();
            add(
                    LINE,
                    shading.shader(),
                    "-",
                    1,
                    run.get(Measure.WALL_SECONDS),
                    run.get(Measure.PROCESSOR_SECONDS),
                    error(run.get(Measure.RMS_ERROR)),
                    run.get(Measure.ABSOLUTE_ERROR),
                    run.get(Measure.BRIGHTNESS));
        }
        report.reference()
                .standardError()
                .ifPresent(error -> add("the reference's own error: %.5f", report.rootMeanSquare(error)));
        report.reference()
                .halves()
                .ifPresent(halves -> add("; its halves differ by %.5f", report.rootMeanSquare(halves)));
        add("%n");
        add("rRMSE in brackets: less than %.0f times the reference's own error%n", StudyPoint.REFERENCE_MARGIN);
        return text.toString();
    }

    private void technique(TechniqueStudy study) {
        for (StudyPoint point : study.points()) {
            String error = error(point.error());
            add(
                    LINE,
                    study.technique().name(),
                    point.budget().label(),
                    point.runs().size(),
                    point.mean(Measure.WALL_SECONDS),
                    point.mean(Measure.PROCESSOR_SECONDS),
                    point.isResolved() ? error : "(" + error + ")",
                    point.mean(Measure.ABSOLUTE_ERROR),
                    point.mean(Measure.BRIGHTNESS));
        }
        if (!study.refusal().isEmpty()) {
            add("%-24s %s%n", study.technique().name(), study.refusal());
        }
    }

    private static String error(double value) {
        return String.format(Locale.ROOT, "%.5f", value);
    }

    private void add(String format, Object... values) {
        text.append(String.format(Locale.ROOT, format, values));
    }
}
