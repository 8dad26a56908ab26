package org.diacaustic.page;

/**
 * Something that a study shows.
 *
 * @param kind what it is about
 * @param text a sentence with its numbers, or a few
 */
public record Finding(Kind kind, String text) {

    /** What findings are about, the most important first. */
    public enum Kind {
        /** A technique is right nowhere: its brightness is off, whatever the budget. */
        WRONG,
        /** Which technique has the least error in a time. */
        WINNER,
        /** How many times less time the best technique takes to the same error. */
        FASTER,
        /** A technique that more rays help no more. */
        STUCK,
        /** What the shading models miss. */
        SHADING,
        /** A technique that cannot render the scene. */
        REFUSED,
        /** What to know of the numbers. */
        NOTE
    }
}
