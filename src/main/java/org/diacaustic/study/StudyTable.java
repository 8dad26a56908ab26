package org.diacaustic.study;

import java.util.Locale;

/** A study as text in columns. */
final class StudyTable {
    private static final String HEAD = "%-18s %9s %11s %8s %8s %10s %10s %9s%n";
    private static final String LINE = "%-18s %9d %11d %8.3f %8.2f %10s %10.5f %+9.5f%n";

    private final StudyReport report;
    private final StringBuilder text = new StringBuilder();

    StudyTable(StudyReport report) {
        this.report = report;
    }

    String text() {
        add(HEAD, "technique", "rays", "light rays", "seconds", "cpu", "rRMSE", "relMAE", "bias");
        report.studies().forEach(this::technique);
        report.studies().stream()
                .flatMap(study -> study.runs().stream())
                .findFirst()
                .ifPresent(this::reference);
        return text.toString();
    }

    private void technique(TechniqueStudy study) {
        String name = study.technique().name();
        if (!study.refusal().isEmpty()) {
            add("%-18s %s%n", name, study.refusal());
            return;
        }
        for (StudyRun run : study.runs()) {
            PictureError error = run.error();
            String rms = error.isResolved()
                    ? String.format(Locale.ROOT, "%.5f", error.rms())
                    : String.format(Locale.ROOT, "<%.5f", error.leastRms());
            add(
                    LINE,
                    name,
                    run.rays(),
                    run.lightRays(),
                    run.seconds(),
                    run.processorSeconds(),
                    rms,
                    error.absolute(),
                    error.bias());
        }
        TechniqueStudy.Slope slope = study.slope();
        if (slope.points() > 1) {
            add("%-18s error falls like light rays to the power %.3f", name, slope.value());
            add(slope.points() > 2 ? " (±%.3f)%n" : "%n", slope.standardError());
        }
    }

    private void reference(StudyRun any) {
        add(
                "on %d pixels; noise of the reference, taken out: rRMSE %.5f; it resolves errors above %.5f%n",
                any.error().pixels(), any.error().noiseRms(), any.error().leastRms());
    }

    private void add(String format, Object... values) {
        text.append(String.format(Locale.ROOT, format, values));
    }
}
