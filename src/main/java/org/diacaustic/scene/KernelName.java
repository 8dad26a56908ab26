package org.diacaustic.scene;

/** How a photon counts by its distance from where it is looked for. */
public enum KernelName {
    /** Alike at any distance. */
    CONSTANT,
    /** Falling linearly to 0 at the radius. */
    CONE,
    /** Falling with the square of the distance to 0 at the radius. */
    EPANECHNIKOV
}
