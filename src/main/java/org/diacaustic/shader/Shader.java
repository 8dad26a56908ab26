package org.diacaustic.shader;

import org.diacaustic.math.Rgb;

/**
 * A shading model: says how much of a light's irradiance arrives along the straight line to it. Implementations are
 * immutable and shared by threads; what changes is in the {@link ShadowRay}.
 */
public interface Shader {

    /** The name in settings and on the command line. */
    String name();

    /**
     * Sets the fraction per colour that arrives.
     *
     * @return whether any light arrives
     */
    boolean transmit(ShadowRay shadow, Rgb transmittance);
}
