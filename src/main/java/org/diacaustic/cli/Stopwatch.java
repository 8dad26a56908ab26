package org.diacaustic.cli;

import java.util.LinkedHashMap;
import java.util.Map;

/** Wall-clock seconds of the parts of a command, by the monotonic clock. */
final class Stopwatch {
    private final long start = System.nanoTime();
    private final Map<String, Double> laps = new LinkedHashMap<>();
    private long last = start;

    /** Ends a part. */
    void lap(String part) {
        long now = System.nanoTime();
        laps.put(part, (now - last) * 1e-9);
        last = now;
    }

    /** The seconds of a part; 0 if it did not run. */
    double seconds(String part) {
        return laps.getOrDefault(part, 0.0);
    }

    /** The seconds since the stopwatch was made. */
    double total() {
        return (System.nanoTime() - start) * 1e-9;
    }
}
