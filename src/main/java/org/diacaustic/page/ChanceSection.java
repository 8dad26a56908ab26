package org.diacaustic.page;

import java.util.List;
import java.util.OptionalDouble;
import org.diacaustic.chart.Html;
import org.diacaustic.study.Expectation;
import org.diacaustic.study.Measure;
import org.diacaustic.study.PowerFit;
import org.diacaustic.study.TechniqueStudy;

/** What of the error is chance and what is bias, and how both fall with more light rays, beside what theory expects. */
final class ChanceSection {
    /** Over less, a slope says little. */
    private static final double DECADES = 1.9;

    private static final int POINTS = 4;

    private final StudyNumbers numbers;
    private final ShownTechniques techniques;
    private final StudyCharts charts;

    ChanceSection(StudyNumbers numbers, ShownTechniques techniques, StudyCharts charts) {
        this.numbers = numbers;
        this.techniques = techniques;
        this.charts = charts;
    }

    void write(PageWriter page) {
        page.section("chance", "Bias and chance");
        page.paragraph(
                "The squared error is the variance of a picture, which is chance and falls when pictures are averaged, and"
                        + " the squared bias, which stays. Squared bias is what is left when the chance of the mean of all runs, and the"
                        + " noise of the reference, are taken off; where nothing is left there is no dot.");
        panels(page, techniques.shown());
        if (techniques.areRepresentatives()) {
            page.format(
                    "<details><summary>the other %d techniques</summary>",
                    techniques.others().size());
            panels(page, techniques.others());
            page.add("</details>");
        }
        slopes(page);
        page.endSection();
    }

    private void panels(PageWriter page, List<TechniqueStudy> studies) {
        page.add("<div class=\"panels\">");
        for (Chart chart : charts.chance(studies)) {
            page.format("<figure><figcaption>%s</figcaption>", chart.caption())
                    .chart(chart)
                    .add("</figure>");
        }
        page.add("</div>");
    }

    private void slopes(PageWriter page) {
        page.add("<h3>How steep: powers of the number of light rays</h3>");
        page.table("numbers slopes cards", List.of("technique", "error", "variance", "bias²", "theory"));
        String before = "";
        for (TechniqueStudy study : numbers.started()) {
            Expectation expected = Expectation.of(study.technique());
            page.add("<tr>").format("<th>%s</th>", study.technique().name());
            boolean isLong = study.points().size() >= POINTS;
            cell(page, "error", study.errorFit(Measure.LIGHT_RAYS), isLong, expected.errorPower());
            cell(page, "variance", study.varianceFit(), isLong, expected.variancePower());
            cell(page, "bias²", study.biasFit(), isLong, expected.squaredBiasPower());
            page.add("<td class=\"words\">" + raised(expected.says().equals(before) ? "" : expected.says())
                    + "</td></tr>");
            before = expected.says();
        }
        page.endTable();
        page.remark(
                "Fitted to logarithms, over at least two decades and four budgets; in brackets what holds the true power with a"
                        + " chance of 95 % if there is one. Theory is for smooth light; at edges and folds it is slower. What lies far"
                        + " from theory is marked.");
    }

    /** A text whose powers, such as N^-1/2, are written as powers. */
    private static String raised(String text) {
        return Html.escape(text)
                .replaceAll("\\^-([\\d/]+)", "<sup>−$1</sup>")
                .replaceAll("\\^([\\d/]+)", "<sup>$1</sup>");
    }

    private static void cell(PageWriter page, String title, PowerFit fit, boolean isLong, OptionalDouble expected) {
        boolean isTold = isLong && fit.decades() >= DECADES && Double.isFinite(fit.power());
        String found = isTold ? Numbers.power(fit.power()) : "–";
        String range = isTold && Double.isFinite(fit.interval().low())
                ? "[" + Numbers.power(fit.interval().low()) + ", "
                        + Numbers.power(fit.interval().high()) + "]"
                : "";
        String theory = expected.isPresent() ? "theory " + Numbers.power(expected.getAsDouble()) : "";
        boolean isOff = isTold
                && expected.isPresent()
                && Double.isFinite(fit.interval().low())
                && !fit.interval().contains(expected.getAsDouble());
        page.format(
                "<td class=\"%s\" data-title=\"%s\"><b>%s</b> <span>%s</span><span class=\"theory\">%s</span></td>",
                isOff ? "off" : "", title, found, range, theory);
    }
}
