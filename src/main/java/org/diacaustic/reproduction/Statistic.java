package org.diacaustic.reproduction;

import java.util.Arrays;
import java.util.List;

/** A number that was counted once, or several times with different seeds, in the order of the seeds. */
record Statistic(List<Double> values) {

    /** @throws IllegalArgumentException if there is no value */
    Statistic {
        values = List.copyOf(values);
        if (values.isEmpty()) {
            throw new IllegalArgumentException("a statistic needs at least one value");
        }
    }

    static Statistic of(double... values) {
        return new Statistic(Arrays.stream(values).boxed().toList());
    }

    int count() {
        return values.size();
    }

    double mean() {
        return values.stream().mapToDouble(v -> v).sum() / count();
    }

    /** Standard deviation of a single value; 0 if there is one only. */
    double deviation() {
        double mean = mean();
        double squares =
                values.stream().mapToDouble(v -> (v - mean) * (v - mean)).sum();
        return count() > 1 ? Math.sqrt(squares / (count() - 1)) : 0;
    }
}
