package org.diacaustic.study;

import java.util.Locale;

/** The colours of charts; the page chooses its own for each by name. */
enum Ink {
    PAPER(1, 1, 1),
    GRID(0.78, 0.78, 0.78),
    TEXT(0.02, 0.02, 0.03),
    INDIVIDUAL(0.02, 0.16, 0.45),
    GLOBAL(0.72, 0.20, 0.02);

    final double red;
    final double green;
    final double blue;

    /** Linear light. */
    Ink(double red, double green, double blue) {
        this.red = red;
        this.green = green;
        this.blue = blue;
    }

    String key() {
        return name().toLowerCase(Locale.ROOT);
    }
}
