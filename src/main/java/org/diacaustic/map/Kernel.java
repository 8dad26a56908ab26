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
    EPANECHNIKOV,
    /**
     * α(1 − (1 − exp(−β d²/2r²)) ÷ (1 − exp(−β))), β = 1.953: the Gaussian filter of [Jensen 1996]. The published α of 0.918
     * makes all light 0.53 of what it is [García et al. 2014]; here it is the 1.728 that the mean weight of 1 asks for.
     */
    GAUSSIAN;

    private static final double BETA = 1.953;

    /** 1 − exp(−β). */
    private static final double FALL = -StrictMath.expm1(-BETA);

    /** What makes the mean over the disc 1: that of exp(−βs/2), s from 0 to 1, is (1 − exp(−β/2)) ÷ (β/2). */
    private static final double ALPHA = 1 / (1 - (1 + StrictMath.expm1(-BETA / 2) / (BETA / 2)) / FALL);

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
            case GAUSSIAN -> ALPHA * (1 + StrictMath.expm1(-0.5 * BETA * ratioSquared) / FALL);
        };
    }
}
