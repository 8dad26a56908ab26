package org.diacaustic.study;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * What whole processes take that start for one picture, by the clock.
 *
 * @param start seconds of a process that does nothing but start
 * @param budget of the pictures
 * @param renders seconds of a process that renders the picture and writes it, by name of technique; only of those that
 *     {@code render} can do
 */
public record ColdTimes(double start, Budget budget, Map<String, Double> renders) {

    public ColdTimes {
        renders = Collections.unmodifiableMap(new LinkedHashMap<>(renders));
    }
}
