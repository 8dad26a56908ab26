package org.diacaustic.reproduction;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import org.diacaustic.image.LinearImage;

/**
 * What an experiment gave.
 *
 * @param picture of the first seed
 */
record Outcome(Experiment experiment, Map<Quantity, Statistic> counts, LinearImage picture) {

    /** @param runs one for each seed, in order; the first has a picture */
    static Outcome of(Experiment experiment, List<Measurement> runs) {
        Map<Quantity, List<Double>> values = new EnumMap<>(Quantity.class);
        for (Measurement run : runs) {
            run.counts()
                    .forEach((quantity, value) -> values.computeIfAbsent(quantity, key -> new ArrayList<>())
                            .add(value));
        }
        Map<Quantity, Statistic> counts = new EnumMap<>(Quantity.class);
        values.forEach((quantity, list) -> counts.put(quantity, new Statistic(list)));
        return new Outcome(experiment, counts, runs.get(0).picture().orElseThrow());
    }

    /** @throws IllegalStateException if that was not counted */
    Statistic statistic(Quantity quantity) {
        Statistic statistic = counts.get(quantity);
        if (statistic == null) {
            throw new IllegalStateException(experiment + " has not counted " + quantity);
        }
        return statistic;
    }

    /** The mean over the seeds. */
    double mean(Quantity quantity) {
        return statistic(quantity).mean();
    }
}
