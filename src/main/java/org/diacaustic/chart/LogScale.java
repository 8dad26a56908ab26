package org.diacaustic.chart;

import java.util.ArrayList;
import java.util.List;

/**
 * A logarithmic axis from any positive number to a larger one.
 *
 * @param start where on the drawing the least value lies, {@code end} where the largest one does
 */
public record LogScale(double least, double largest, double start, double end) {
    /** With more decades than this, only powers of ten are ticks. */
    private static final double DECADES_WITH_STEPS = 2.2;

    private static final int MOST_TICKS = 7;

    public LogScale {
        if (!(least > 0 && largest > least && largest < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException("no logarithmic axis runs from " + least + " to " + largest);
        }
    }

    public double place(double value) {
        return start + (end - start) * Math.log(value / least) / Math.log(largest / least);
    }

    public boolean contains(double value) {
        return value >= least && value <= largest;
    }

    private double decades() {
        return Math.log10(largest / least);
    }

    /** Round values to be written at the axis: powers of ten, and on short axes 2 and 5 times those. */
    public List<Double> ticks() {
        double[] steps = decades() > DECADES_WITH_STEPS ? new double[] {1} : new double[] {1, 2, 5};
        int every = (int) Math.max(1, Math.ceil(decades() / MOST_TICKS));
        List<Double> ticks = new ArrayList<>();
        for (int power = (int) Math.floor(Math.log10(least)); power <= Math.log10(largest); power++) {
            if (Math.floorMod(power, every) == 0) {
                for (double step : steps) {
                    // Parsed, so that 0.001 is the number that is written so.
                    double tick = Double.parseDouble(step + "e" + power);
                    if (contains(tick)) {
                        ticks.add(tick);
                    }
                }
            }
        }
        return ticks;
    }
}
