package org.diacaustic.chart;

/**
 * How text is written.
 *
 * @param size of the letters, in units of the drawing
 * @param anchor which part of the text lies at its place
 */
public record Lettering(double size, String color, Anchor anchor, boolean isBold) {
    /** About how wide a letter is, for each unit of its size; text of a chart is mostly narrower. */
    private static final double LETTER_WIDTH = 0.53;

    /** The part of a text that lies at its place. */
    public enum Anchor {
        START("start"),
        MIDDLE("middle"),
        END("end");

        private final String key;

        Anchor(String key) {
            this.key = key;
        }
    }

    /** Plain letters that begin at their place. */
    public static Lettering of(double size, String color) {
        return new Lettering(size, color, Anchor.START, false);
    }

    public Lettering at(Anchor other) {
        return new Lettering(size, color, other, isBold);
    }

    public Lettering bold() {
        return new Lettering(size, color, anchor, true);
    }

    /** About how wide the text comes out, in units of the drawing. */
    public double width(String text) {
        return LETTER_WIDTH * size * text.length();
    }

    String attributes() {
        String place = anchor == Anchor.START ? "" : " text-anchor=\"" + anchor.key + "\"";
        return isBold ? place + " font-weight=\"bold\"" : place;
    }
}
