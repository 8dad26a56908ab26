package org.diacaustic.map;

/** How the power in a texel becomes light that shades. */
public enum AmbientCalibration {
    /** Power ÷ area: irradiance, in W·m⁻². */
    DENSITY,

    /**
     * Power ÷ the number of photons that a texel is expected to have, as the thesis weighs the volume of interest of its
     * photon map [Thesis 4.5]: the mean power of a photon if that many have come, in W. It knows no areas.
     */
    EXPECTED_COUNT
}
