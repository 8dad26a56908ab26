package org.diacaustic.map;

import org.diacaustic.index.PointTree;

/**
 * Finds the k nearest photons that a filter accepts. Candidates are collected, and whenever there is no room left the k
 * nearest of them are selected, which shrinks the ball that is searched. Working storage of one task; nothing is allocated by
 * a search.
 */
public final class NearestPhotons {
    private final PhotonSearch search;
    private final double lengthUnit;
    private final int count;

    /** Squared distance (its bits, in the upper half; it is not negative) and place of each candidate. */
    private final long[] candidates;

    private int found;

    /** @param count k, at least 1 */
    public NearestPhotons(PhotonTree tree, PhotonFilter filter, int count) {
        this.search = new PhotonSearch(tree, filter);
        this.lengthUnit = tree.lengthUnit();
        this.count = Math.min(count, tree.size() + 1);
        this.candidates = new long[this.count + this.count / 2 + PointTree.LARGEST_LEAF];
    }

    /**
     * Finds the photons nearest to a point whose numbers are finite.
     *
     * @param maximumRadius of a closed ball, in scene units; may be 0 or infinite
     * @return whether there are k within it. If so, they are the candidates 0 to k − 1, the last of which is the farthest;
     *     if not, all that there are have been found
     */
    public boolean find(SurfacePoint at, double maximumRadius) {
        search.start(at, maximumRadius);
        found = 0;
        for (int next = search.next(); next >= 0; next = search.next()) {
            for (int i = 0; i < next; i++) {
                candidates[found++] =
                        (long) Float.floatToRawIntBits(search.distancesSquared[i]) << 32 | search.photons[i];
            }
            if (found > candidates.length - search.photons.length) {
                keepNearest();
                search.shrink(distanceSquaredInUnits(count - 1));
            }
        }
        if (found < count) {
            return false;
        }
        keepNearest();
        return true;
    }

    private void keepNearest() {
        LongSelection.select(candidates, found, count - 1);
        found = count;
    }

    /** The number of photons found, at most k. */
    public int found() {
        return found;
    }

    /** The place in the tree's order of photon i of those found. */
    public int photon(int i) {
        return (int) candidates[i];
    }

    /** Its squared distance, in scene units squared: that of positions in single precision. */
    public double distanceSquared(int i) {
        return distanceSquaredInUnits(i) * lengthUnit * lengthUnit;
    }

    /** Its squared distance, in units of length. */
    float distanceSquaredInUnits(int i) {
        return Float.intBitsToFloat((int) (candidates[i] >>> 32));
    }

    long examined() {
        return search.examined();
    }
}
