package org.diacaustic.page;

import java.util.List;
import java.util.stream.Stream;
import org.diacaustic.study.StudyPoint;
import org.diacaustic.study.TechniqueStudy;

/** Charts of what chance does to a technique, and what it does wrong whatever chance does. */
final class ChanceCharts {
    private static final Palette.Style VARIANCE = Palette.style(5);
    private static final Palette.Style BIAS = Palette.style(1);

    private final StudyNumbers numbers;
    private final PlotArea.Axis x;
    private final PlotArea.Axis y;

    ChanceCharts(StudyNumbers numbers) {
        this.numbers = numbers;
        List<PlotLine> all = numbers.started().stream()
                .flatMap(study -> Stream.of(variance(study), bias(study)))
                .toList();
        x = new PlotArea.Axis("light rays chosen", Numbers::roundCount, PlotRange.ofX(all));
        y = new PlotArea.Axis("square of relative error", Numbers::scientific, PlotRange.ofY(all));
    }

    /** One technique; all have the same axes. */
    Chart of(TechniqueStudy study) {
        String name = study.technique().name();
        LogPlot plot = new LogPlot(name + ": squared bias and variance against light rays", x, y);
        plot.line(variance(study)).line(bias(study));
        return new Chart("chance-" + name, name, plot.draw(PlotSize.PANEL));
    }

    private PlotLine variance(TechniqueStudy study) {
        return new PlotLine(
                "variance",
                VARIANCE,
                study.points().stream()
                        .map(point -> dot(point, point.variance()))
                        .toList());
    }

    private PlotLine bias(TechniqueStudy study) {
        return new PlotLine(
                "bias²",
                BIAS,
                study.points().stream()
                        .map(point -> dot(point, point.squaredBias()))
                        .toList());
    }

    private PlotLine.Dot dot(StudyPoint point, double square) {
        String words = Numbers.percent(Math.sqrt(square)) + " of the mean, with " + Numbers.count(point.rays())
                + " light rays";
        return new PlotLine.Dot(point.rays(), square, words);
    }
}
