package org.diacaustic.scene;

/** How irradiance is found from photons. */
public enum EstimatorName {
    /** What the plan finds best. */
    AUTO,
    /** Their sum over the number that is expected within reach: the thesis' way, for rays without weights [Thesis 4.5]. */
    EXPECTED_COUNT,
    /** Their power over the area within a fixed reach. */
    DENSITY,
    /** The power of the nearest ones over the area that they take [Jensen 1996]. */
    NEAREST,
    /** As {@link #DENSITY}, with a reach that shrinks from pass to pass [Knaus and Zwicker 2011]. */
    PROGRESSIVE;

    /** The name in scene files and on the command line. */
    public String label() {
        return name().toLowerCase(java.util.Locale.ROOT).replace('_', '-');
    }
}
