package org.diacaustic.render;

/** What a render did, counted as the thesis counts it [Thesis 5.2]. Mutable; each task has its own, summed at the end. */
public final class Counters {
    long eyeRays;
    long shadowRays;
    long reflectionRays;
    long refractionRays;
    long cutRays;
    long intersectionTests;
    /** Those of them that were made for shadow rays. */
    long shadowTests;

    long nodesExamined;
    long photonsUsed;
    long nonFiniteSamples;
    /** The first pixel, in reading order, of a sample that was not finite; the largest long if there is none. */
    long firstNonFinitePixel = Long.MAX_VALUE;

    void add(Counters other) {
        eyeRays += other.eyeRays;
        shadowRays += other.shadowRays;
        reflectionRays += other.reflectionRays;
        refractionRays += other.refractionRays;
        cutRays += other.cutRays;
        intersectionTests += other.intersectionTests;
        shadowTests += other.shadowTests;
        nodesExamined += other.nodesExamined;
        photonsUsed += other.photonsUsed;
        nonFiniteSamples += other.nonFiniteSamples;
        firstNonFinitePixel = Math.min(firstNonFinitePixel, other.firstNonFinitePixel);
    }

    /** Adds what another render of the same picture did for {@link OtherLight}. */
    void addOtherLight(Counters other) {
        shadowRays += other.shadowRays;
        shadowTests += other.shadowTests;
        intersectionTests += other.shadowTests;
        // A sample that was left out there may be left out here as well.
        nonFiniteSamples = Math.max(nonFiniteSamples, other.nonFiniteSamples);
        firstNonFinitePixel = Math.min(firstNonFinitePixel, other.firstNonFinitePixel);
    }

    /** Rays through the picture, lens and supersampling included. */
    public long eyeRays() {
        return eyeRays;
    }

    /** Straight lines to lights that were followed. */
    public long shadowRays() {
        return shadowRays;
    }

    public long reflectionRays() {
        return reflectionRays;
    }

    public long refractionRays() {
        return refractionRays;
    }

    /** Mirrored and refracted rays not followed, because they carried too little or came after too many bounces. */
    public long cutRays() {
        return cutRays;
    }

    /** Tests of a ray against a primitive or a bounding volume. */
    public long intersectionTests() {
        return intersectionTests;
    }

    /** Nodes of the illumination map looked at [Thesis 5.2]. */
    public long nodesExamined() {
        return nodesExamined;
    }

    /** Photons that counted in lookups of the illumination map. */
    public long photonsUsed() {
        return photonsUsed;
    }

    /** Samples that were infinite or not a number: left out of the picture, and 0 unless something is wrong. */
    public long nonFiniteSamples() {
        return nonFiniteSamples;
    }
}
