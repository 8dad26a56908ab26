package org.diacaustic.page;

import java.util.ArrayList;
import java.util.List;
import org.diacaustic.chart.LabelColumn;
import org.diacaustic.chart.Lettering;
import org.diacaustic.chart.SvgCanvas;

/** A chart of lines between logarithmic axes. Names stand at the ends of lines. */
final class LogPlot {
    private static final double BAND_OPACITY = 0.13;

    private final String title;
    private final PlotArea.Axis x;
    private final PlotArea.Axis y;
    private final List<PlotLine> lines = new ArrayList<>();
    private final List<PlotLine> behind = new ArrayList<>();
    private final List<Level> levels = new ArrayList<>();
    private double floor;
    private String floorLabel = "";
    private String shortFloorLabel = "";
    private boolean hasGuides;

    /** A horizontal line. */
    private record Level(String name, double value) {}

    /** @param title what the chart shows, for those who do not see it */
    LogPlot(String title, PlotArea.Axis x, PlotArea.Axis y) {
        this.title = title;
        this.x = x;
        this.y = y;
    }

    /** Draws a line; one without dots is left out. */
    LogPlot line(PlotLine line) {
        if (!line.dots().isEmpty()) {
            lines.add(line);
        }
        return this;
    }

    /** Draws a line grey, without a name, behind the others. */
    LogPlot behind(PlotLine line) {
        if (!line.dots().isEmpty()) {
            behind.add(line);
        }
        return this;
    }

    /** Draws a thin horizontal line with its name. */
    LogPlot level(String name, double value) {
        levels.add(new Level(name, value));
        return this;
    }

    /** Draws a dashed line under which nothing is certain, if it is within the axis. */
    LogPlot floor(String label, String shortLabel, double value) {
        floorLabel = label;
        shortFloorLabel = shortLabel;
        floor = value;
        return this;
    }

    /** Shows how steep 1/√N and 1/N are. */
    LogPlot guides() {
        hasGuides = true;
        return this;
    }

    SvgCanvas draw(PlotSize size) {
        SvgCanvas canvas = new SvgCanvas(size.width(), size.height(), title);
        canvas.fill(0, 0, size.width(), size.height(), Palette.PAPER);
        PlotArea area = new PlotArea(canvas, size, x, y, labelWidth(size));
        area.axes();
        if (area.y().contains(floor)) {
            area.floor(floor);
        }
        behind.forEach(line -> path(canvas, area, line, 3, Palette.BEHIND));
        List<Level> seen =
                levels.stream().filter(level -> area.y().contains(level.value)).toList();
        seen.forEach(level -> area.horizontal(level.value, 1, Palette.MUTED));
        FreeSpace space = space(area, seen);
        if (hasGuides) {
            new SlopeGuides(area).draw(canvas, space);
        }
        double[] places = labelPlaces(area, seen);
        for (int i = 0; i < lines.size(); i++) {
            draw(canvas, area, lines.get(i), places[i]);
        }
        for (int i = 0; i < seen.size(); i++) {
            area.levelLabel(seen.get(i).name, seen.get(i).value, places[lines.size() + i]);
        }
        if (area.y().contains(floor)) {
            area.floorLabel(floorLabel, shortFloorLabel, floor, space);
        }
        return canvas;
    }

    private FreeSpace space(PlotArea area, List<Level> seen) {
        List<PlotLine> all = new ArrayList<>(lines);
        all.addAll(behind);
        List<Double> levelPlaces = new ArrayList<>();
        seen.forEach(level -> levelPlaces.add(area.y().place(level.value)));
        if (area.y().contains(floor)) {
            levelPlaces.add(area.y().place(floor));
        }
        return new FreeSpace(area, all, levelPlaces);
    }

    private double labelWidth(PlotSize size) {
        Lettering lettering = Lettering.of(size.letter(), Palette.TEXT);
        double widest = 0;
        for (PlotLine line : lines) {
            widest = Math.max(widest, lettering.width(line.name()));
        }
        for (Level level : levels) {
            widest = Math.max(widest, lettering.width(level.name));
        }
        return widest + PlotArea.LABEL_GAP;
    }

    private double[] labelPlaces(PlotArea area, List<Level> seen) {
        double[] wished = new double[lines.size() + seen.size()];
        for (int i = 0; i < lines.size(); i++) {
            wished[i] = area.y().place(lines.get(i).last().y());
        }
        for (int i = 0; i < seen.size(); i++) {
            wished[lines.size() + i] = area.y().place(seen.get(i).value);
        }
        return LabelColumn.spread(wished, 1.25 * area.letter(), area.top(), area.bottom());
    }

    private static void draw(SvgCanvas canvas, PlotArea area, PlotLine line, double labelPlace) {
        String color = line.style().color();
        canvas.beginGroup("line", line.name());
        band(canvas, area, line);
        area.leader(line.last(), labelPlace, color);
        path(canvas, area, line, 2, color);
        for (PlotLine.Dot dot : line.dots()) {
            double x = area.x().place(dot.x());
            if (dot.hasInterval()) {
                double[] ends = {
                    area.placeWithin(dot.interval().low()),
                    area.placeWithin(dot.interval().high())
                };
                canvas.line(new double[] {x, x}, ends, 1.2, color);
            }
            canvas.beginGroup("dot", line.name() + ": " + dot.words());
            String within = dot.isCertain() ? color : Palette.PAPER;
            canvas.mark(line.style().mark(), x, area.y().place(dot.y()), 0.28 * area.letter(), color, within);
            canvas.endGroup();
        }
        area.lineLabel(line, labelPlace);
        canvas.endGroup();
    }

    private static void path(SvgCanvas canvas, PlotArea area, PlotLine line, double width, String color) {
        double[] x =
                line.dots().stream().mapToDouble(dot -> area.x().place(dot.x())).toArray();
        double[] y =
                line.dots().stream().mapToDouble(dot -> area.y().place(dot.y())).toArray();
        canvas.line(x, y, width, color);
    }

    /** Where single runs lie, along the upper ends to the right and along the lower ones back. */
    private static void band(SvgCanvas canvas, PlotArea area, PlotLine line) {
        List<PlotLine.Dot> dots =
                line.dots().stream().filter(PlotLine.Dot::hasBand).toList();
        int count = dots.size();
        double[] x = new double[2 * count];
        double[] y = new double[2 * count];
        for (int i = 0; i < count; i++) {
            PlotLine.Dot dot = dots.get(i);
            x[i] = area.x().place(dot.x());
            x[2 * count - 1 - i] = x[i];
            y[i] = area.y().place(dot.band().high());
            y[2 * count - 1 - i] = area.y().place(dot.band().low());
        }
        if (count > 1) {
            canvas.area(x, y, line.style().color(), BAND_OPACITY);
        }
    }
}
