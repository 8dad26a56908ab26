package org.diacaustic.reproduction;

import java.util.Map;
import java.util.Optional;
import org.diacaustic.image.LinearImage;

/** What one run of an experiment counted, and its picture, if one was asked for. */
record Measurement(Map<Quantity, Double> counts, Optional<LinearImage> picture) {

    Measurement {
        counts = Map.copyOf(counts);
    }
}
