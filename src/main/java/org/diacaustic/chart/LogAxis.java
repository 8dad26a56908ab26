package org.diacaustic.chart;

import java.util.List;

/**
 * A logarithmic axis of whole decades.
 *
 * @param start where on the drawing the first decade begins, {@code end} where the last one ends
 */
public record LogAxis(int firstDecade, int lastDecade, double start, double end) {

    /** The axis that has room for all values, which are positive. */
    public static LogAxis of(List<double[]> values, double start, double end) {
        double least = Double.POSITIVE_INFINITY;
        double largest = 0;
        for (double[] some : values) {
            for (double value : some) {
                least = Math.min(least, value);
                largest = Math.max(largest, value);
            }
        }
        int first = (int) Math.floor(Math.log10(least));
        return new LogAxis(first, Math.max(first + 1, (int) Math.ceil(Math.log10(largest))), start, end);
    }

    public double place(double value) {
        return start + (end - start) * (Math.log10(value) - firstDecade) / (lastDecade - firstDecade);
    }
}
