package org.diacaustic.study;

import java.util.Map;
import org.diacaustic.image.LinearImage;

/** What one run of an experiment counted, and its picture. */
record Measurement(Map<Quantity, Double> counts, LinearImage picture) {

    Measurement {
        counts = Map.copyOf(counts);
    }
}
