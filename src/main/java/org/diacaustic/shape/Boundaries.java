package org.diacaustic.shape;

/** Where a line goes into something closed and out of it, one boundary after the other. Mutable, owned by one task. */
abstract class Boundaries {
    /** Where the next boundary is, in lengths of the line's direction; positive infinity if there is none. */
    double t;

    /** Whether the line goes in there. */
    boolean entering;

    /** How far boundaries of other things may be found from this one, in t, that are in one place with it. */
    double error;

    /** Whether the line is inside up to the next boundary. */
    boolean inside;

    /** Goes on to the boundary after the next. */
    abstract void advance();

    final boolean isAtEnd() {
        return t == Double.POSITIVE_INFINITY;
    }
}
