package org.diacaustic.chart;

/** What a chart is drawn on. Coordinates run right and down from the top left corner. */
public interface Canvas {
    void fill(double x, double y, double width, double height, Ink ink);

    void outline(double x, double y, double width, double height, Ink ink);

    /** One line of text, its left end at x and its foot at y. */
    void text(double x, double y, String text);

    /** As {@link #text}, with its middle at x. */
    void textAround(double x, double y, String text);
}
