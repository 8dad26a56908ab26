package org.diacaustic.chart;

/** Text within HTML and SVG. */
public final class Html {
    private Html() {}

    /** The text with nothing in it that could be taken for markup, in elements and in quoted attributes. */
    public static String escape(String text) {
        return text.replace("&", "&amp;")
                .replace("<", "&lt;")
                .replace(">", "&gt;")
                .replace("\"", "&quot;");
    }
}
