package org.diacaustic.study;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import org.diacaustic.chart.Ink;
import org.diacaustic.chart.LogAxis;
import org.diacaustic.chart.SvgCanvas;

/**
 * Error against light rays, a line for each technique, both axes logarithmic. Errors that the reference does not resolve are
 * left out, as they are of slopes. Two grey lines from the highest point show how errors fall like 1/√N and 1/N.
 */
final class ErrorChart {
    private static final int WIDTH = 640;
    private static final int HEIGHT = 400;
    private static final int LEFT = 56;
    private static final int RIGHT = 500;
    private static final int TOP = 40;
    private static final int BOTTOM = 356;
    private static final int LINE_HEIGHT = 13;

    /** Told apart by people who do not see all colours, too. */
    private static final List<String> COLORS =
            List.of("#dc7c26", "#26262f", "#266fb3", "#5fa8d3", "#3f8f5b", "#a05195", "#8a8a94");

    private final List<Line> lines = new ArrayList<>();
    private final LogAxis across;
    private final LogAxis up;

    private record Line(String name, String color, double[] rays, double[] errors) {
        double last(double[] values) {
            return values[values.length - 1];
        }
    }

    /** Whether there is an error to draw. */
    static boolean hasSomething(List<TechniqueStudy> studies) {
        return studies.stream().flatMap(study -> study.runs().stream()).anyMatch(ErrorChart::counts);
    }

    private static boolean counts(StudyRun run) {
        return run.lightRays() > 0 && run.error().isResolved();
    }

    /** @throws IllegalArgumentException if there is no error to draw */
    ErrorChart(List<TechniqueStudy> studies) {
        for (TechniqueStudy study : studies) {
            List<StudyRun> runs =
                    study.runs().stream().filter(ErrorChart::counts).toList();
            if (!runs.isEmpty()) {
                lines.add(new Line(
                        study.technique().name(),
                        COLORS.get(lines.size() % COLORS.size()),
                        runs.stream().mapToDouble(StudyRun::lightRays).toArray(),
                        runs.stream().mapToDouble(run -> run.error().rms()).toArray()));
            }
        }
        if (lines.isEmpty()) {
            throw new IllegalArgumentException("no technique has an error that the reference resolves");
        }
        across = LogAxis.of(lines.stream().map(Line::rays).toList(), LEFT, RIGHT);
        up = LogAxis.of(lines.stream().map(Line::errors).toList(), BOTTOM, TOP);
    }

    String svg() {
        SvgCanvas canvas = new SvgCanvas(WIDTH, HEIGHT, "error against light rays");
        canvas.fill(0, 0, WIDTH, HEIGHT, Ink.PAPER);
        canvas.text(LEFT - 44, TOP - 18, "rRMSE against light rays followed; grey: 1/\u221aN and 1/N");
        for (int decade = across.firstDecade(); decade <= across.lastDecade(); decade++) {
            double x = across.place(Math.pow(10, decade));
            canvas.fill(x, TOP, 1, BOTTOM - TOP, Ink.GRID);
            canvas.textAround(x, BOTTOM + 16, String.format(Locale.ROOT, "%,.0f", Math.pow(10, decade)));
        }
        for (int decade = up.firstDecade(); decade <= up.lastDecade(); decade++) {
            double y = up.place(Math.pow(10, decade));
            canvas.fill(LEFT, y, RIGHT - LEFT, 1, Ink.GRID);
            canvas.text(LEFT - 44, y + 3, String.format(Locale.ROOT, "%s", Math.pow(10, decade)));
        }
        drawSlope(-0.5, canvas);
        drawSlope(-1, canvas);
        for (Line line : lines) {
            double[] x = places(line.rays, across);
            double[] y = places(line.errors, up);
            canvas.line(x, y, 2, line.color);
            for (int i = 0; i < x.length; i++) {
                canvas.dot(x[i], y[i], 3, line.color);
            }
        }
        drawNames(canvas);
        return canvas.file();
    }

    private static double[] places(double[] values, LogAxis axis) {
        double[] places = new double[values.length];
        for (int i = 0; i < values.length; i++) {
            places[i] = axis.place(values[i]);
        }
        return places;
    }

    /** From the top left corner until the line leaves the chart. */
    private void drawSlope(double slope, SvgCanvas canvas) {
        double first = Math.pow(10, across.firstDecade());
        double highest = Math.pow(10, up.lastDecade());
        double decades = Math.min(
                (double) across.lastDecade() - across.firstDecade(), (up.firstDecade() - up.lastDecade()) / slope);
        double[] x = {across.place(first), across.place(first * Math.pow(10, decades))};
        double[] y = {up.place(highest), up.place(highest * Math.pow(10, slope * decades))};
        canvas.line(x, y, 1, Ink.GRID.webColor);
    }

    /** Names at the lines' ends, moved down where they would overlap. */
    private void drawNames(SvgCanvas canvas) {
        List<Line> fromTop = new ArrayList<>(lines);
        fromTop.sort(Comparator.comparingDouble(line -> up.place(line.last(line.errors))));
        double free = 0;
        for (Line line : fromTop) {
            double y = Math.max(free, up.place(line.last(line.errors)) + 3);
            canvas.dot(RIGHT + 14, y - 3, 3, line.color);
            canvas.text(RIGHT + 22, y, line.name);
            free = y + LINE_HEIGHT;
        }
    }
}
