package org.diacaustic.trial;

import java.util.Arrays;

/**
 * Independent results of one experiment.
 *
 * @param mean of them
 * @param deviation the standard deviation of one
 * @param size how many there are
 */
record Sample(double mean, double deviation, int size) {
    static Sample of(double... values) {
        double mean = Arrays.stream(values).average().orElse(Double.NaN);
        double squares = Arrays.stream(values)
                .map(value -> (value - mean) * (value - mean))
                .sum();
        return new Sample(mean, Math.sqrt(squares / (values.length - 1)), values.length);
    }

    /** The standard error of the mean. */
    double error() {
        return deviation / Math.sqrt(size);
    }
}
