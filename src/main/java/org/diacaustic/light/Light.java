package org.diacaustic.light;

import org.diacaustic.math.Ray;
import org.diacaustic.math.Rgb;

/**
 * A source of light. Implementations are immutable and shared by threads; what changes is in the {@link LightSample} of
 * the caller.
 */
public interface Light {

    /**
     * Takes one of the points that stand for this light, as seen from (x, y, z).
     *
     * @param s first coordinate of the choice, uniform in 0..1; not used by a light that is a point
     * @param t second coordinate
     * @return whether any light can come from there: false behind a spot, or exactly at the light
     */
    boolean sample(double x, double y, double z, double s, double t, LightSample sample);

    /** How many points stand for this light in direct lighting; each carries its share. 1 for a point. */
    default int sampleCount() {
        return 1;
    }

    /**
     * The exponent of the highlight that this light makes on reflecting surfaces: the thesis stores it with the light,
     * because it stands for the light's size [Thesis 2.1]. 0 makes no highlight.
     */
    default double highlightExponent() {
        return 0;
    }

    /** Whether the light has an extent that can be seen; see {@link #emitsAlong}. */
    default boolean isVisible() {
        return false;
    }

    /**
     * For a light that {@link #isVisible}: if the ray meets it at 0 &lt; t &lt; {@code ray.tMax}, shortens
     * {@code ray.tMax}, sets the radiance that leaves it against the ray and returns true.
     */
    default boolean emitsAlong(Ray ray, Rgb radiance) {
        return false;
    }
}
