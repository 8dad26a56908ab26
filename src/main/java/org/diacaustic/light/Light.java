package org.diacaustic.light;

import org.diacaustic.math.Color;
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

    /** How this light sends out light rays; {@link Spread#NONE} if it knows only direct light. */
    default Spread spread() {
        return Spread.NONE;
    }

    /**
     * Chooses a point that sends out light rays. All choices together are the light: each sends what the whole light would
     * if it were only there.
     *
     * @param s first coordinate of the choice, uniform in 0..1; not used by a light that is a point
     * @param t second coordinate
     */
    default void emitFrom(double s, double t, LightPoint point) {
        throw new UnsupportedOperationException("this light sends out no light rays");
    }

    /**
     * Sets what the point sends into a unit direction: intensity in W·sr⁻¹, or, if the rays are parallel, irradiance
     * across them in W·m⁻².
     */
    default void emit(LightPoint point, double dx, double dy, double dz, Rgb intensity) {
        throw new UnsupportedOperationException("this light sends out no light rays");
    }

    /**
     * All that this light sends out, in W: the integral of {@link #emit} over all directions, for the mean of its points.
     *
     * @throws UnsupportedOperationException if its rays are parallel, and so without end side by side, or it sends none
     */
    default Color flux() {
        throw new UnsupportedOperationException("this light has no flux of a finite size");
    }

    /**
     * What a flux is multiplied by where it lands, after a path of this length: d²·f(d), so that a light whose falloff f is
     * not that of nature lights through glass as it does directly. 1 in nature.
     */
    default double depositFactor(double distance) {
        return 1;
    }

    /** How light rays leave a light. */
    enum Spread {
        /** Not at all: the light has no part in forward passes. */
        NONE,
        /** From a point, into all directions. */
        FROM_POINT,
        /** Side by side, in one direction, from infinitely far away. */
        PARALLEL
    }
}
