package org.diacaustic.study;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.diacaustic.image.LinearImage;

/**
 * What an experiment gave.
 *
 * @param picture of the first seed
 */
record Outcome(Experiment experiment, Map<Quantity, Statistic> counts, LinearImage picture) {

    static Outcome of(Experiment experiment, List<Measurement> runs) {
        Map<Quantity, List<Double>> values = new EnumMap<>(Quantity.class);
        for (Measurement run : runs) {
            run.counts()
                    .forEach((quantity, value) -> values.computeIfAbsent(quantity, key -> new ArrayList<>())
                            .add(value));
        }
        Map<Quantity, Statistic> counts = new EnumMap<>(Quantity.class);
        values.forEach((quantity, list) -> counts.put(quantity, Statistic.of(list)));
        return new Outcome(experiment, counts, runs.get(0).picture());
    }

    Optional<Statistic> find(Quantity quantity) {
        return Optional.ofNullable(counts.get(quantity));
    }

    /** @throws IllegalStateException if that was not counted */
    double mean(Quantity quantity) {
        return find(quantity)
                .orElseThrow(() -> new IllegalStateException(experiment + " has not counted " + quantity))
                .mean();
    }
}
