package org.diacaustic.shape;

/** The ends of stretches of a line that are known. */
final class ListedBoundaries extends Boundaries {
    private final double[] ends;
    private int next;

    /** @param ends of stretches with a length, apart from each other and in order: beginning and end in turn */
    ListedBoundaries(double[] ends) {
        this.ends = ends;
        boolean startsInside = ends.length > 0 && ends[0] == Double.NEGATIVE_INFINITY;
        next = startsInside ? 1 : 0;
        inside = startsInside;
        seek();
    }

    private void seek() {
        t = next < ends.length ? ends[next] : Double.POSITIVE_INFINITY;
        entering = next % 2 == 0;
    }

    @Override
    void advance() {
        inside = entering;
        next++;
        seek();
    }
}
