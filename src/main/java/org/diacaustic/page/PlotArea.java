package org.diacaustic.page;

import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleFunction;
import org.diacaustic.chart.Lettering;
import org.diacaustic.chart.Lettering.Anchor;
import org.diacaustic.chart.LogScale;
import org.diacaustic.chart.SvgCanvas;

/** The part of a chart between its axes, and what stands around it. */
final class PlotArea {
    /** From the axes' end to the names of lines: room for their marks. */
    static final double LABEL_GAP = 34;

    private static final double LONGEST_TICK_LETTERS = 5;

    /** A name takes no more of the axis. */
    private static final double NAME_SHARE = 0.5;

    /** Places of a label that are tried along a line. */
    private static final int FLOOR_PLACES = 16;

    private final SvgCanvas canvas;
    private final PlotSize size;
    private final double letter;
    private final double left;
    private final double right;
    private final double top;
    private final double bottom;
    private final Axis xAxis;
    private final Axis yAxis;
    private final LogScale x;
    private final LogScale y;

    /**
     * What an axis is of.
     *
     * @param label with the unit
     * @param tick the words of a value
     */
    record Axis(String label, DoubleFunction<String> tick, PlotRange range) {}

    /** @param labelWidth what names to the right of the axes take */
    PlotArea(SvgCanvas canvas, PlotSize size, Axis xAxis, Axis yAxis, double labelWidth) {
        this.canvas = canvas;
        this.size = size;
        letter = size.letter();
        left = Lettering.of(letter, Palette.MUTED).width("x") * LONGEST_TICK_LETTERS + 14;
        right = size.width() - labelWidth - 4;
        top = 2.6 * letter;
        bottom = size.height() - 3.4 * letter;
        this.xAxis = xAxis;
        this.yAxis = yAxis;
        x = new LogScale(xAxis.range.least(), xAxis.range.largest(), left, right);
        y = new LogScale(yAxis.range.least(), yAxis.range.largest(), bottom, top);
    }

    LogScale x() {
        return x;
    }

    LogScale y() {
        return y;
    }

    /** Where a value lies upwards, or the end of the axis that it lies beyond. */
    double placeWithin(double value) {
        return y.place(Math.max(y.least(), Math.min(y.largest(), value)));
    }

    double left() {
        return left;
    }

    double right() {
        return right;
    }

    double top() {
        return top;
    }

    double bottom() {
        return bottom;
    }

    double letter() {
        return letter;
    }

    private Lettering muted(Anchor anchor) {
        return Lettering.of(letter, Palette.MUTED).at(anchor);
    }

    void axes() {
        double written = Double.NEGATIVE_INFINITY;
        for (double tick : x.ticks()) {
            double place = x.place(tick);
            canvas.line(new double[] {place, place}, new double[] {top, bottom}, 1, Palette.RULE);
            double half = muted(Anchor.MIDDLE).width(xAxis.tick.apply(tick)) / 2;
            if (place - half > written) {
                canvas.text(place, bottom + 1.25 * letter, xAxis.tick.apply(tick), muted(Anchor.MIDDLE));
                written = place + half + letter / 2;
            }
        }
        for (double tick : y.ticks()) {
            horizontal(tick, 1, Palette.RULE);
            canvas.text(left - 6, y.place(tick) + 0.35 * letter, yAxis.tick.apply(tick), muted(Anchor.END));
        }
        canvas.text(4, 1.2 * letter, yAxis.label, muted(Anchor.START));
        String label = xAxis.label + " →";
        double end = Math.max(right, muted(Anchor.END).width(label) + 4);
        canvas.text(end, size.height() - 0.7 * letter, label, muted(Anchor.END));
    }

    void horizontal(double value, double width, String color) {
        double place = y.place(value);
        canvas.line(new double[] {left, right}, new double[] {place, place}, width, color);
    }

    void floor(double value) {
        double place = y.place(value);
        canvas.dashes(new double[] {left, right}, new double[] {place, place}, 1.2, Palette.MUTED, 5);
    }

    /**
     * Names what {@link #floor} drew, below or above it, where least is drawn.
     *
     * @param shortName if there is no room for the other
     */
    void floorLabel(String name, String shortName, double value, FreeSpace space) {
        double place = y.place(value);
        boolean isRoomy = muted(Anchor.START).width(name) < NAME_SHARE * (right - left);
        String label = isRoomy ? name : shortName;
        double width = muted(Anchor.START).width(label) + 8;
        List<FreeSpace.Box> places = new ArrayList<>();
        for (int i = 0; i <= FLOOR_PLACES; i++) {
            double start = left + (right - left - width) * i / FLOOR_PLACES;
            if (place + 1.5 * letter < bottom) {
                places.add(new FreeSpace.Box(start, place + 1, width, 1.3 * letter));
            }
            places.add(new FreeSpace.Box(start, place - 1 - 1.3 * letter, width, 1.3 * letter));
        }
        FreeSpace.Box box = space.emptiest(places);
        canvas.textOver(box.left() + 4, box.top() + letter, label, muted(Anchor.START), Palette.PAPER);
    }

    /** From the last dot of a line to its name. */
    void leader(PlotLine.Dot dot, double labelPlace, String color) {
        double[] xs = {x.place(dot.x()), right + 6, right + LABEL_GAP - 18};
        double[] ys = {y.place(dot.y()), y.place(dot.y()), labelPlace};
        canvas.dashes(xs, ys, 0.8, color, 2);
    }

    void lineLabel(PlotLine line, double place) {
        double start = right + LABEL_GAP;
        canvas.mark(
                line.style().mark(),
                start - 10,
                place,
                0.3 * letter,
                line.style().color(),
                line.style().color());
        canvas.text(start, place + 0.35 * letter, line.name(), Lettering.of(letter, Palette.TEXT));
    }

    void levelLabel(String name, double value, double place) {
        double start = right + LABEL_GAP;
        double[] xs = {right, right + 6, start - 4};
        double[] ys = {y.place(value), y.place(value), place};
        canvas.line(xs, ys, 0.8, Palette.MUTED);
        canvas.text(start, place + 0.35 * letter, name, muted(Anchor.START));
    }
}
