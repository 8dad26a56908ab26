package org.diacaustic.chart;

import java.util.Locale;

/** The colours of charts; the page chooses its own for each by name. */
public enum Ink {
    PAPER(1, 1, 1, "#ffffff"),
    GRID(0.78, 0.78, 0.78, "#e5e5e5"),
    TEXT(0.02, 0.02, 0.03, "#26262f"),
    INDIVIDUAL(0.02, 0.16, 0.45, "#266fb3"),
    GLOBAL(0.72, 0.20, 0.02, "#dc7c26");

    /** Linear light. */
    public final double red;

    public final double green;
    public final double blue;
    /** The same where drawings are shown without the page. */
    public final String webColor;

    Ink(double red, double green, double blue, String webColor) {
        this.red = red;
        this.green = green;
        this.blue = blue;
        this.webColor = webColor;
    }

    public String key() {
        return name().toLowerCase(Locale.ROOT);
    }
}
