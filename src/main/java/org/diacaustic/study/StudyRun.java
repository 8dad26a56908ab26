package org.diacaustic.study;

import java.util.EnumMap;
import java.util.Map;

/**
 * One picture made by a technique.
 *
 * @param seed of all its random choices
 * @param values what was measured of it; not a number where nothing could be
 */
public record StudyRun(long seed, Map<Measure, Double> values) {

    public StudyRun {
        values = new EnumMap<>(values);
    }

    /** Not a number if it was not measured. */
    public double get(Measure measure) {
        return values.getOrDefault(measure, Double.NaN);
    }
}
