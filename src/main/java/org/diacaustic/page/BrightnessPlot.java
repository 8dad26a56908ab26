package org.diacaustic.page;

import java.util.List;
import org.diacaustic.chart.Lettering;
import org.diacaustic.chart.Lettering.Anchor;
import org.diacaustic.chart.Mark;
import org.diacaustic.chart.SvgCanvas;

/** Mean differences of brightness as dots around zero, each with the interval that holds the true one. */
final class BrightnessPlot {
    private static final double LETTER = 12.5;
    private static final double ROW = 22;
    private static final double TOP = 34;

    private final List<Brightness> rows;
    private final int width;
    private final double left;
    private final double reach;

    private BrightnessPlot(List<Brightness> rows, int width) {
        this.rows = rows;
        this.width = width;
        Lettering names = Lettering.of(LETTER, Palette.TEXT);
        left = 12
                + rows.stream()
                        .mapToDouble(row -> names.width(row.name()))
                        .max()
                        .orElse(0);
        double farthest = rows.stream()
                .mapToDouble(row -> Math.max(
                        Math.abs(row.difference()),
                        Math.max(
                                Math.abs(row.interval().low()),
                                Math.abs(row.interval().high()))))
                .filter(Double::isFinite)
                .max()
                .orElse(0);
        reach = Math.max(2 * Brightness.TOLERANCE, 1.08 * farthest);
    }

    static Chart chart(List<Brightness> rows) {
        return new Chart(
                "brightness",
                "too dark, too bright",
                new BrightnessPlot(rows, 860).draw(),
                new BrightnessPlot(rows, 400).draw());
    }

    private double right() {
        return width - 62;
    }

    private double x(double difference) {
        return (left + right()) / 2 + difference / reach * (right() - left) / 2;
    }

    private SvgCanvas draw() {
        int height = (int) (TOP + rows.size() * ROW + 26);
        SvgCanvas canvas = new SvgCanvas(width, height, "mean difference of brightness to the reference");
        canvas.fill(0, 0, width, height, Palette.PAPER);
        double bottom = TOP + rows.size() * ROW;
        double tolerance = Brightness.TOLERANCE;
        canvas.fill(x(-tolerance), TOP - 8, x(tolerance) - x(-tolerance), bottom - TOP + 8, Palette.RULE);
        canvas.line(new double[] {x(0), x(0)}, new double[] {TOP - 8, bottom}, 1, Palette.MUTED);
        Lettering muted = Lettering.of(LETTER, Palette.MUTED);
        canvas.text(x(0), TOP - 14, "0", muted.at(Anchor.MIDDLE));
        canvas.text(left, TOP - 14, "← too dark", muted);
        canvas.text(right(), TOP - 14, "too bright →", muted.at(Anchor.END));
        canvas.text(x(0), bottom + 16, "grey: within 1 %", muted.at(Anchor.MIDDLE));
        for (int i = 0; i < rows.size(); i++) {
            row(canvas, rows.get(i), TOP + (i + 0.5) * ROW);
        }
        return canvas;
    }

    private void row(SvgCanvas canvas, Brightness row, double y) {
        String color = row.isWrong() ? Palette.WRONG : Palette.TEXT;
        Lettering letters = Lettering.of(LETTER, color);
        Lettering name = row.isWrong() ? letters.bold() : letters;
        double foot = y + 0.35 * LETTER;
        canvas.text(left - 10, foot, row.name(), name.at(Anchor.END));
        if (!Double.isFinite(row.difference())) {
            return;
        }
        canvas.beginGroup("dot", row.words());
        if (Double.isFinite(row.interval().low())) {
            double[] ends = {x(row.interval().low()), x(row.interval().high())};
            canvas.line(ends, new double[] {y, y}, 2, color);
        }
        canvas.mark(Mark.CIRCLE, x(row.difference()), y, 4, color, row.isWrong() ? color : Palette.PAPER);
        canvas.endGroup();
        canvas.text(width - 4.0, foot, Numbers.signedPercent(row.difference()), name.at(Anchor.END));
    }
}
