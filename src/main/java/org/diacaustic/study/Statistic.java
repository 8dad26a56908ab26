package org.diacaustic.study;

import java.util.List;

/**
 * A number that was counted once, or several times with different seeds.
 *
 * @param deviation standard deviation of a single count; 0 if there is one only
 * @param count how many times
 */
record Statistic(double mean, double deviation, int count) {

    static Statistic of(List<Double> values) {
        int count = values.size();
        double mean = values.stream().mapToDouble(v -> v).sum() / count;
        double squares =
                values.stream().mapToDouble(v -> (v - mean) * (v - mean)).sum();
        return new Statistic(mean, count > 1 ? Math.sqrt(squares / (count - 1)) : 0, count);
    }

    /** How far this lies from a published number, relative to that. */
    double differenceFrom(double published) {
        return published == mean ? 0 : (mean - published) / Math.abs(published);
    }

    /** How far a published number lies from the mean, in standard deviations; not a number if there is no spread. */
    double deviationsTo(double published) {
        return deviation > 0 ? (published - mean) / deviation : Double.NaN;
    }
}
