package org.diacaustic.page;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.diacaustic.study.Distribution;
import org.diacaustic.study.Interval;
import org.diacaustic.study.Measure;
import org.diacaustic.study.StudyPoint;
import org.diacaustic.study.Technique;
import org.diacaustic.study.TechniqueStudy;

/** Charts of error against what it costs. */
final class ErrorCharts {
    private static final String ERROR = "error (rRMSE)";

    /** The line of the reference's own error is drawn if it lies at most this far below the least error. */
    private static final double NEAR = 3;

    private final StudyNumbers numbers;
    private final ShownTechniques techniques;

    ErrorCharts(StudyNumbers numbers, ShownTechniques techniques) {
        this.numbers = numbers;
        this.techniques = techniques;
    }

    /** The shown techniques along an axis, with all there is to compare them to. */
    Chart all(PlotAxis axis) {
        String title = "error against " + axis.title();
        return new Chart(
                "error-" + axis.key(),
                title,
                plot(axis, title).draw(axis == PlotAxis.PROCESSOR ? PlotSize.WIDE : PlotSize.MEDIUM),
                plot(axis, title).draw(PlotSize.SMALL));
    }

    private LogPlot plot(PlotAxis axis, String title) {
        List<PlotLine> lines = techniques.shown().stream()
                .map(study -> line(study, axis, study.technique().name(), techniques.style(study)))
                .toList();
        LogPlot plot = empty(title, axis, lines);
        lines.forEach(plot::line);
        numbers.report().shading().forEach(shading -> {
            double error = shading.run().get(Measure.RMS_ERROR);
            if (error > 0) {
                plot.level("shader " + shading.shader(), error);
            }
        });
        return axis.growsWithRays() ? plot.guides() : plot;
    }

    /** @param lines that there is to be room for */
    private LogPlot empty(String title, PlotAxis axis, List<PlotLine> lines) {
        PlotArea.Axis x = new PlotArea.Axis(axis.label(), axis::tick, PlotRange.ofX(lines));
        PlotArea.Axis y = new PlotArea.Axis(ERROR, Numbers::roundPercent, yRange(lines));
        return new LogPlot(title, x, y).floor("below: the reference’s own error × 5", "reference × 5", floor());
    }

    private PlotRange yRange(List<PlotLine> lines) {
        double[] more = new double[numbers.report().shading().size() + 1];
        for (int i = 1; i < more.length; i++) {
            more[i] = numbers.report().shading().get(i - 1).run().get(Measure.RMS_ERROR);
        }
        double least = lines.stream()
                .flatMap(line -> line.dots().stream())
                .mapToDouble(PlotLine.Dot::y)
                .min()
                .orElse(Double.NaN);
        more[0] = floor() * NEAR > least ? floor() : 0;
        return PlotRange.ofY(lines, more);
    }

    /** Under which no error is told; 0 if the reference has none. */
    private double floor() {
        return StudyPoint.REFERENCE_MARGIN
                * numbers.started().stream()
                        .flatMap(study -> study.points().stream())
                        .mapToDouble(StudyPoint::referenceError)
                        .max()
                        .orElse(0);
    }

    /** A chart for each family, a line for each way to choose light rays, the same axes for all. */
    List<Chart> families() {
        PlotAxis axis = PlotAxis.PROCESSOR;
        List<PlotLine> all = numbers.started().stream()
                .map(study -> line(study, axis, "", techniques.style(study)))
                .toList();
        TechniqueStudy best = techniques.shown().stream()
                .min(Comparator.comparingDouble(
                        study -> StudyNumbers.last(study).shownError()))
                .orElseThrow();
        List<Chart> charts = new ArrayList<>();
        for (Map.Entry<String, List<TechniqueStudy>> family : numbers.families().entrySet()) {
            LogPlot plot = empty(family.getKey() + ": error against " + axis.title(), axis, all);
            plot.behind(line(best, axis, best.technique().name(), techniques.style(best)));
            family.getValue()
                    .forEach(study -> plot.line(
                            line(study, axis, nameWithin(study.technique()), techniques.styleWithinFamily(study))));
            charts.add(new Chart("family-" + family.getKey(), family.getKey(), plot.draw(PlotSize.PANEL)));
        }
        return charts;
    }

    /** What its name says beyond the family's. */
    private static String nameWithin(Technique technique) {
        String rest = technique.name().replace("-" + technique.family(), "");
        return rest.equals(technique.family()) ? technique.preProcessor() : rest;
    }

    private PlotLine line(TechniqueStudy study, PlotAxis axis, String name, Palette.Style style) {
        return new PlotLine(
                name,
                style,
                study.points().stream().map(point -> dot(point, axis)).toList());
    }

    private PlotLine.Dot dot(StudyPoint point, PlotAxis axis) {
        Distribution error = numbers.distribution(point, Measure.RMS_ERROR);
        double cost = point.mean(axis.measure());
        boolean isResolved = point.isResolved();
        String words = String.format(
                Locale.ROOT,
                "%s%s with %s light rays, %s processor time, %d %s",
                isResolved ? "" : "at most ",
                Numbers.percent(point.shownError()),
                Numbers.count(point.rays()),
                Numbers.seconds(point.mean(Measure.PROCESSOR_SECONDS)),
                error.count(),
                error.count() == 1 ? "run" : "runs");
        Interval band = isResolved ? error.band() : Interval.UNKNOWN;
        Interval interval = isResolved ? error.meanInterval() : Interval.UNKNOWN;
        return new PlotLine.Dot(cost, point.shownError(), band, interval, isResolved, words);
    }
}
