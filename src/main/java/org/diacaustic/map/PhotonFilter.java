package org.diacaustic.map;

/** Which photons count where irradiance is asked for. The search asks before a photon takes any place in it. */
public enum PhotonFilter {
    /**
     * Those whose surface faces as the asked one does, within 67.5°: half way between neighbouring facets of a coarse
     * round object, 45° apart, and the walls of a room, 90° apart. So light comes neither through a thin sheet nor round
     * a corner [Thesis 4.8], and none is lost on a sphere whose radius is more than 0.9 times that of the gather.
     */
    TWO_SIDED_NORMAL(0.3826834323650898),

    /** All, as in the thesis: light on one side of a thin sheet is seen on both. */
    NONE(Double.NaN);

    private final double cosine;

    PhotonFilter(double cosine) {
        this.cosine = cosine;
    }

    /** The cosine of the largest angle between two normals that face alike; not a number if any do. */
    public double cosine() {
        return cosine;
    }
}
