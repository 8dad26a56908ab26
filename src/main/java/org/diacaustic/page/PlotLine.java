package org.diacaustic.page;

import java.util.List;
import org.diacaustic.study.Interval;

/**
 * A line of a chart.
 *
 * @param name that stands at its end
 * @param dots from left to right; those that a logarithmic chart cannot show are left out
 */
record PlotLine(String name, Palette.Style style, List<Dot> dots) {

    PlotLine {
        dots = dots.stream().filter(Dot::isDrawable).toList();
    }

    /**
     * A point of a line.
     *
     * @param band where single runs lie, {@code interval} where the true mean may lie; drawn where they are known
     * @param isCertain otherwise it is drawn hollow
     * @param words all that is known about it
     */
    record Dot(double x, double y, Interval band, Interval interval, boolean isCertain, String words) {
        Dot(double x, double y, String words) {
            this(x, y, Interval.UNKNOWN, Interval.UNKNOWN, true, words);
        }

        private boolean isDrawable() {
            return isDrawable(x) && isDrawable(y);
        }

        private static boolean isDrawable(double value) {
            return value > 0 && value < Double.POSITIVE_INFINITY;
        }

        boolean hasBand() {
            return isDrawable(band.low()) && isDrawable(band.high());
        }

        boolean hasInterval() {
            // The lower end may lie below zero, where no logarithm goes.
            return Double.isFinite(interval.low()) && isDrawable(interval.high());
        }
    }

    Dot last() {
        return dots.get(dots.size() - 1);
    }
}
