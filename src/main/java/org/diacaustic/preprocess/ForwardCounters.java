package org.diacaustic.preprocess;

/** What a forward pass did, counted as the thesis counts it [Thesis 5.2]. Mutable; each task has its own. */
public final class ForwardCounters {
    long primaryRays;
    long secondaryRays;
    long primaryHits;
    long hits;
    long stored;
    long intersectionTests;
    long cells;
    long nonFinite;

    void add(ForwardCounters other) {
        primaryRays += other.primaryRays;
        secondaryRays += other.secondaryRays;
        primaryHits += other.primaryHits;
        hits += other.hits;
        stored += other.stored;
        intersectionTests += other.intersectionTests;
        cells += other.cells;
        nonFinite += other.nonFinite;
    }

    /** Rays that pre-processors chose. */
    public long primaryRays() {
        return primaryRays;
    }

    /** All rays followed: those that were chosen and what was mirrored or refracted of them. */
    public long lightRays() {
        return primaryRays + secondaryRays;
    }

    /** Chosen rays that met an object. */
    public long primaryHits() {
        return primaryHits;
    }

    /** Rays that met an object. */
    public long objectIntersections() {
        return hits;
    }

    /** Photons stored. */
    public long stored() {
        return stored;
    }

    /** Cells of light, points included, that were made. */
    public long cells() {
        return cells;
    }

    /** Tests of a ray against a primitive or a bounding volume. */
    public long intersectionTests() {
        return intersectionTests;
    }

    /** Paths that ended, and photons that were left out, for what is infinite or not a number: 0 unless something is wrong. */
    public long nonFinite() {
        return nonFinite;
    }
}
