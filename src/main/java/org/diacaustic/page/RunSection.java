package org.diacaustic.page;

import java.util.ArrayList;
import java.util.List;
import org.diacaustic.study.Budget;
import org.diacaustic.study.Machine;
import org.diacaustic.study.StudyReport;
import org.diacaustic.study.TechniqueStudy;

/** What a study ran on, how to run it again, and what to know of it. */
final class RunSection {
    /** Fewer runs are said. */
    private static final int ENOUGH_RUNS = 20;

    private final StudyReport report;

    RunSection(StudyReport report) {
        this.report = report;
    }

    void write(PageWriter page) {
        page.section("run", "How it was run");
        page.format("<pre><code>%s</code></pre>", report.command());
        page.paragraph(
                "The same command gives the same errors and counts to the last digit. Times differ from run to run and from"
                        + " machine to machine."
                        + (hasSeconds()
                                ? " Budgets of seconds are the exception: how many rays they buy depends on the machine."
                                : ""));
        page.paragraph(
                "Techniques have the scene's own settings, but for those that are listed with their numbers: nothing is clamped, and"
                        + " light rays are spread so that they are right on average, which some of the thesis' are not. Random"
                        + " choices, and where lattices begin, differ from seed to seed.");
        Machine machine = report.machine();
        page.table("facts", List.of("", ""));
        page.row(List.of("Diacaustic", machine.program()));
        page.row(List.of("Java", machine.java()));
        page.row(List.of("system", machine.system()));
        page.row(List.of("processor", machine.processor().isEmpty() ? "not told by the system" : machine.processor()));
        page.row(List.of("cores, threads used", machine.cores() + ", " + report.threads()));
        page.row(List.of("first seed", Long.toString(report.seed())));
        if (report.gatherRadius() > 0) {
            page.row(List.of(
                    "gather radius", Numbers.digits(report.gatherRadius()) + " scene units, where it is fixed"));
        }
        page.row(List.of("runs a point", runs()));
        page.endTable();
        List<String> refused = new ArrayList<>();
        for (TechniqueStudy study : report.studies()) {
            if (!study.refusal().isEmpty()) {
                refused.add(study.technique().name() + ": " + study.refusal());
            }
        }
        if (!refused.isEmpty()) {
            page.add("<h3>Not possible in this scene</h3><ul>");
            refused.forEach(text -> page.format("<li>%s</li>", text));
            page.add("</ul>");
        }
        page.endSection();
    }

    private boolean hasSeconds() {
        return report.studies().stream()
                .flatMap(study -> study.points().stream())
                .anyMatch(point -> point.budget() instanceof Budget.Seconds);
    }

    private String runs() {
        var counts = report.studies().stream()
                .flatMap(study -> study.points().stream())
                .mapToInt(point -> point.runs().size())
                .summaryStatistics();
        if (counts.getCount() == 0) {
            return "none yet";
        }
        String range = counts.getMin() == counts.getMax()
                ? Integer.toString(counts.getMin())
                : counts.getMin() + " to " + counts.getMax();
        return counts.getMin() < ENOUGH_RUNS ? range + "; intervals of fewer than 20 are rough" : range;
    }
}
