package org.diacaustic.material;

/** What travels along a path: refraction scales radiance by the square of the index ratio, but not power. */
public enum TransportMode {
    /** From the eye: radiance, W·m⁻²·sr⁻¹. */
    RADIANCE,
    /** From a light: power, W. */
    FLUX
}
