package org.diacaustic.page;

import java.util.List;
import org.diacaustic.chart.Mark;

/**
 * The colours of a study's charts, which the colour-blind can tell apart [Okabe and Ito 2008]. They stand in the drawings; {@code
 * study.css} puts others in their place where the page is dark.
 */
final class Palette {
    static final String PAPER = "#ffffff";
    static final String TEXT = "#1b1d22";
    static final String MUTED = "#5c6370";
    static final String RULE = "#e3e5ea";
    static final String BEHIND = "#b4b9c4";
    static final String WRONG = "#c2220f";

    /** Yellow is too light for lines on paper, and is darker here. */
    static final List<String> LINES =
            List.of("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#3a3d45", "#8a7a00", "#8b8f98");

    private Palette() {}

    /** Colour and mark of a line. */
    record Style(String color, Mark mark) {}

    /** The style of a line by its number; more than nine begin again with another mark. */
    static Style style(int number) {
        int round = number / LINES.size();
        Mark[] marks = Mark.values();
        return new Style(LINES.get(number % LINES.size()), marks[(number + round) % marks.length]);
    }
}
