package org.diacaustic.page;

import java.util.Locale;
import java.util.function.DoubleFunction;
import org.diacaustic.study.Measure;

/** What runs along an axis of a chart. */
enum PlotAxis {
    PROCESSOR(Measure.PROCESSOR_SECONDS, "processor time", "seconds of all processors together", Numbers::tick),
    CLOCK(Measure.WALL_SECONDS, "time by the clock", "seconds by the clock", Numbers::tick),
    RAYS(Measure.LIGHT_RAYS, "light rays", "light rays followed", Numbers::roundCount),
    WORK(Measure.WORK, "work", "intersection tests and nodes examined", Numbers::roundCount),
    BYTES(Measure.MAP_BYTES, "memory", "bytes of the map", Numbers::roundBytes);

    private final Measure measure;
    private final String title;
    private final String label;
    private final DoubleFunction<String> words;

    PlotAxis(Measure measure, String title, String label, DoubleFunction<String> words) {
        this.measure = measure;
        this.title = title;
        this.label = label;
        this.words = words;
    }

    Measure measure() {
        return measure;
    }

    /** For headings. */
    String title() {
        return title;
    }

    /** To stand at the axis. */
    String label() {
        return label;
    }

    /** A value of the axis. */
    String tick(double value) {
        return words.apply(value);
    }

    /** For names of files. */
    String key() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** Whether twice as many light rays cost about twice as much. */
    boolean growsWithRays() {
        return this != BYTES;
    }
}
