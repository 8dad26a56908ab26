package org.diacaustic.page;

import java.util.ArrayList;
import java.util.List;
import org.diacaustic.chart.Lettering;
import org.diacaustic.chart.SvgCanvas;

/** Two short lines from one point, as steep as 1/√N and as 1/N, where they are least in the way. */
final class SlopeGuides {
    /** Of the axes, how much they take at most. */
    private static final double WIDTH_SHARE = 0.14;

    private static final double HEIGHT_SHARE = 0.3;

    /** Places along each axis that are tried. */
    private static final int PLACES = 12;

    private static final double MARGIN = 8;

    private final PlotArea area;
    private final double width;
    private final double height;

    SlopeGuides(PlotArea area) {
        this.area = area;
        double unitX = (area.right() - area.left())
                / Math.log(area.x().largest() / area.x().least());
        double unitY = (area.bottom() - area.top())
                / Math.log(area.y().largest() / area.y().least());
        double length = Math.min(
                WIDTH_SHARE * (area.right() - area.left()) / unitX,
                HEIGHT_SHARE * (area.bottom() - area.top()) / unitY);
        width = length * unitX;
        height = length * unitY;
    }

    void draw(SvgCanvas canvas, FreeSpace space) {
        FreeSpace.Box box = space.emptiest(places());
        double left = box.left() + MARGIN;
        double top = box.top() + MARGIN;
        Lettering small = Lettering.of(0.85 * area.letter(), Palette.MUTED);
        for (double power : new double[] {0.5, 1}) {
            double end = top + power * height;
            canvas.line(new double[] {left, left + width}, new double[] {top, end}, 1.2, Palette.BEHIND);
            canvas.text(left + width + 3, end + 0.3 * area.letter(), power == 1 ? "1/N" : "1/√N", small);
        }
    }

    /** From the lower left on, where most charts are empty. */
    private List<FreeSpace.Box> places() {
        double boxWidth = width + 2.6 * area.letter() + 2 * MARGIN;
        double boxHeight = height + 2 * MARGIN;
        List<FreeSpace.Box> places = new ArrayList<>();
        for (int i = 0; i <= PLACES; i++) {
            for (int j = PLACES; j >= 0; j--) {
                double left = area.left() + (area.right() - area.left() - boxWidth) * i / PLACES;
                double top = area.top() + (area.bottom() - area.top() - boxHeight) * j / PLACES;
                places.add(new FreeSpace.Box(left, top, boxWidth, boxHeight));
            }
        }
        return places;
    }
}
