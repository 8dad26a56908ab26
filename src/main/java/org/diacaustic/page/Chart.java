package org.diacaustic.page;

import org.diacaustic.chart.SvgCanvas;

/**
 * A drawing of a study.
 *
 * @param name of its file, without ending
 * @param caption what it shows, in a line; may be empty
 * @param wide as large as a screen
 * @param small for narrow screens, and to stand beside others
 */
record Chart(String name, String caption, SvgCanvas wide, SvgCanvas small) {

    /** A drawing that has one size only. */
    Chart(String name, String caption, SvgCanvas only) {
        this(name, caption, only, only);
    }
}
