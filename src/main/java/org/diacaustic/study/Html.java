package org.diacaustic.study;

/** Text within HTML and SVG. */
final class Html {
    private Html() {}

    /** The text with nothing in it that could be taken for markup, in elements and in quoted attributes. */
    static String escape(String text) {
        return text.replace("&", "&amp;")
                .replace("<", "&lt;")
                .replace(">", "&gt;")
                .replace("\"", "&quot;");
    }
}
