package org.diacaustic.map;

/**
 * How much a photon counts at a distance d from the middle of a disc of radius r. Each kernel is normalised over the
 * disc: the mean of its weights is 1, so dividing by πr² gives irradiance.
 */
public enum Kernel {
    /** All photons count alike. */
    CONSTANT,
    /** 3(1 − d/r), the cone of slope 1 [Jensen 1996]. */
    CONE,
    /** 2(1 − d²/r²), whose error is the least for smooth light [Silverman 1986, 4.2]. */
    EPANECHNIKOV;

    /**
     * The weight of a photon.
     *
     * @param ratioSquared d²/r², from 0 to 1
     */
    public double weight(double ratioSquared) {
        return switch (this) {
            case CONSTANT -> 1;
            case CONE -> 3 * (1 - Math.sqrt(ratioSquared));
            case EPANECHNIKOV -> 2 * (1 - ratioSquared);
        };
    }
}
