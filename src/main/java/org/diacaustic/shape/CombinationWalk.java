package org.diacaustic.shape;

/**
 * Goes along a line through two closed things at once, from boundary to boundary of what is made of them. Mutable, owned by
 * one task.
 */
final class CombinationWalk<B extends Boundaries> {
    private final B first;
    private final B second;
    private B nearer;
    private B farther;
    private boolean touches;

    CombinationWalk(B first, B second) {
        this.first = first;
        this.second = second;
    }

    B first() {
        return first;
    }

    B second() {
        return second;
    }

    /**
     * Whose boundary {@link #seek} has found: of two in one place that which is better known where it is, so that the other is
     * no farther off than its own error, in whatever direction.
     */
    B met() {
        return touches && farther.error < nearer.error ? farther : nearer;
    }

    /** Whether the line is inside the combination up to the next boundary of either. */
    boolean isInside(Combination.Kind kind) {
        return kind.holds(first.inside, second.inside);
    }

    /** Goes on to the next boundary of the combination before the limit, without crossing it; false if there is none. */
    boolean seek(Combination.Kind kind, double limit) {
        while (true) {
            boolean secondIsNearer = second.t < first.t;
            nearer = secondIsNearer ? second : first;
            farther = secondIsNearer ? first : second;
            if (!(nearer.t < limit)) {
                return false;
            }
            touches = farther.t - nearer.t <= nearer.error + farther.error && !farther.isAtEnd();
            boolean nearerAfter = nearer.entering;
            boolean fartherAfter = touches ? farther.entering : farther.inside;
            boolean after = kind.holds(
                    secondIsNearer ? fartherAfter : nearerAfter, secondIsNearer ? nearerAfter : fartherAfter);
            if (after != isInside(kind)) {
                return true;
            }
            cross();
        }
    }

    /** Crosses what {@link #seek} has found: boundaries in one place at once. */
    void cross() {
        nearer.advance();
        if (touches) {
            farther.advance();
        }
    }
}
