package org.diacaustic.study;

/** What a study measures of one picture. Errors are relative to the mean of the reference over the pixels that count. */
public enum Measure {
    RMS_ERROR("rRMSE", "root mean square error"),
    /** As {@link #RMS_ERROR}, with the noise of the reference still in it. */
    MEASURED_RMS_ERROR("measuredRRMSE", "root mean square error as measured"),
    ABSOLUTE_ERROR("relMAE", "mean absolute error"),
    RELATIVE_SQUARE_ERROR("relMSE", "mean relative square error"),
    TRIMMED_SQUARE_ERROR("relMSE99.9", "mean relative square error of all but 0.1 %"),
    WORST_BLOCK("worstBlock", "worst error of 8 × 8 pixels"),
    /**
     * Mean of the signed difference, relative to the mean of the light that techniques bring, that which comes over specular
     * surfaces: positive if they bring too much, −1 if nothing.
     */
    BRIGHTNESS("bias", "mean difference"),

    /** All light rays that were followed, with all that became of them. */
    LIGHT_RAYS("lightRays", "light rays"),
    /** Of light rays and eye rays, against objects and volumes. */
    INTERSECTION_TESTS("intersectionTests", "intersection tests"),
    /** Of photon trees, texels and trees of cells. */
    NODES_EXAMINED("nodesExamined", "nodes examined"),
    /** The two before, together. */
    WORK("work", "tests and nodes"),
    /** Photons or cells kept. */
    STORED("stored", "photons or cells"),
    /** Of the largest map that there was. */
    MAP_BYTES("mapBytes", "bytes of the map"),

    WALL_SECONDS("wallSeconds", "seconds by the clock"),
    /** Of all threads, with compiling and cleaning up. */
    PROCESSOR_SECONDS("cpuSeconds", "seconds of processors"),
    /** Parts of {@link #WALL_SECONDS}; what is missing went into planning. */
    FORWARD_SECONDS("forwardSeconds", "following light"),
    BUILD_SECONDS("buildSeconds", "making the map"),
    GATHER_SECONDS("gatherSeconds", "asking the map"),
    EYE_SECONDS("eyeSeconds", "the rest of the eye pass");

    private final String key;
    private final String title;

    Measure(String key, String title) {
        this.key = key;
        this.title = title;
    }

    /** Its name in JSON and CSV. */
    public String key() {
        return key;
    }

    /** Its name in text. */
    public String title() {
        return title;
    }

    /** Whether it is the same in every study with the same seed. */
    public boolean isRepeatable() {
        return compareTo(WALL_SECONDS) < 0;
    }
}
