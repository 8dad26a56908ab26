package org.diacaustic.page;

/**
 * How large a chart is, in units of its drawing.
 *
 * @param letter size of letters
 */
record PlotSize(int width, int height, double letter) {
    /** For a screen that all look at. */
    static final PlotSize WIDE = new PlotSize(1080, 520, 13.5);

    /** Half as wide. */
    static final PlotSize MEDIUM = new PlotSize(620, 400, 13);

    /** For a telephone. */
    static final PlotSize SMALL = new PlotSize(400, 430, 12);

    /** One of many. */
    static final PlotSize PANEL = new PlotSize(380, 270, 12);
}
