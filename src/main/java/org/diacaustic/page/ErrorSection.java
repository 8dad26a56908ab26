package org.diacaustic.page;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.DoubleStream;
import org.diacaustic.study.Measure;
import org.diacaustic.study.TechniqueStudy;
import org.diacaustic.study.TimeToError;

/** Error against what it costs: charts, and what it costs to reach certain errors. */
final class ErrorSection {
    private static final double[] TARGETS = {0.1, 0.03, 0.01, 0.001};

    private final StudyNumbers numbers;
    private final ShownTechniques techniques;
    private final StudyCharts charts;

    ErrorSection(StudyNumbers numbers, ShownTechniques techniques, StudyCharts charts) {
        this.numbers = numbers;
        this.techniques = techniques;
        this.charts = charts;
    }

    void write(PageWriter page) {
        page.section("error", "Error against processor time");
        page.chart(charts.error(PlotAxis.PROCESSOR));
        page.remark(
                "Lines are means over runs, thin bars hold the true mean with a chance of 95 %, and shades are where 90 % of"
                        + " single runs lie (all of them if they are fewer than 20). Hollow marks are errors that the reference cannot"
                        + " tell from its own. rRMSE is the root mean square error of linear light, relative to the mean of the reference.");
        families(page);
        page.endSection();
        otherAxes(page);
        timeToError(page);
    }

    private void families(PageWriter page) {
        List<Chart> families = charts.families();
        if (families.isEmpty()) {
            return;
        }
        page.format(
                "<p>Of each way to read the light the best way to choose rays is drawn above: the one with the least error at the"
                        + " longest processor time that all of them come to. Here are all %d; what comes to the least error"
                        + " of all lies grey behind. Axes are the same everywhere, and a colour is a way to choose rays.</p>",
                numbers.started().size());
        panels(page, families);
    }

    private static void panels(PageWriter page, List<Chart> charts) {
        page.add("<div class=\"panels\">");
        for (Chart chart : charts) {
            page.format("<figure><figcaption>%s</figcaption>", chart.caption())
                    .chart(chart)
                    .add("</figure>");
        }
        page.add("</div>");
    }

    private void otherAxes(PageWriter page) {
        page.section("axes", "Error against other costs");
        page.add("<div class=\"axes\">");
        for (PlotAxis axis : PlotAxis.values()) {
            if (axis != PlotAxis.PROCESSOR) {
                page.format("<label class=\"enlarge\"><input type=\"checkbox\"><span>%s</span>", axis.title())
                        .chart(charts.error(axis))
                        .add("</label>");
            }
        }
        page.add("</div>");
        page.remark(
                "Work is what the thesis counts: intersection tests of all rays, and nodes examined to read the map. Bytes are"
                        + " those of the largest map that a picture needed.");
        page.endSection();
    }

    private void timeToError(PageWriter page) {
        page.section("reach", "Time to an error");
        List<String> heads = new ArrayList<>(List.of("seconds of processors to"));
        DoubleStream.of(TARGETS).forEach(target -> heads.add(Numbers.roundPercent(target)));
        page.table("numbers cards", heads);
        double[] least = DoubleStream.of(TARGETS).map(this::least).toArray();
        for (TechniqueStudy study : numbers.started()) {
            page.add("<tr>").format("<th>%s</th>", study.technique().name());
            Optional<TimeToError> before = Optional.empty();
            for (int i = 0; i < TARGETS.length; i++) {
                TimeToError time = TimeToError.of(study, TARGETS[i], Measure.PROCESSOR_SECONDS);
                // The best error is said once in a row.
                boolean isSaid = time instanceof TimeToError.NotReached && before.equals(Optional.of(time));
                cell(page, TARGETS[i], isSaid ? "not reached" : words(time), time, least[i]);
                before = Optional.of(time);
            }
            page.add("</tr>");
        }
        page.endTable();
        page.remark(
                "On straight lines between points, in logarithms. ≤: the first budget was more than enough. Marked: the least of"
                        + " each column.");
        page.endSection();
    }

    private double least(double target) {
        return numbers.started().stream()
                .mapToDouble(study -> cost(TimeToError.of(study, target, Measure.PROCESSOR_SECONDS)))
                .min()
                .orElse(Double.NaN);
    }

    private static double cost(TimeToError time) {
        if (time instanceof TimeToError.Reached reached) {
            return reached.cost();
        }
        return time instanceof TimeToError.AtMost atMost ? atMost.cost() : Double.POSITIVE_INFINITY;
    }

    private static String words(TimeToError time) {
        if (time instanceof TimeToError.NotReached missed) {
            return "not reached"
                    + (missed.bestError() > 0 ? " (best " + Numbers.percent(missed.bestError()) + ")" : "");
        }
        if (time instanceof TimeToError.NotResolved) {
            return "reference too coarse";
        }
        return (time instanceof TimeToError.AtMost ? "≤ " : "") + Numbers.seconds(cost(time));
    }

    private static void cell(PageWriter page, double target, String words, TimeToError time, double least) {
        boolean isReached = Double.isFinite(cost(time));
        String style = !isReached ? "missed" : cost(time) == least ? "best" : "reached";
        page.format("<td class=\"%s\" data-title=\"%s\">%s</td>", style, Numbers.roundPercent(target), words);
    }
}
