package org.diacaustic.preprocess;

/**
 * A part of the light space of one light point, laid out on the unit square: every point of the square is a light ray.
 * Immutable.
 */
public abstract class EmissionChart {

    /**
     * Sets origin and direction of the ray at (p, q), and how much of light space a unit of the square's area stands for
     * there.
     *
     * @param p from 0 to 1
     * @param q from 0 to 1
     */
    public abstract void aim(double p, double q, LightRay ray);

    /** The extent along p, in units common to the charts of one light point: lattices have the same step everywhere. */
    public abstract double width();

    /** The extent along q, in the same units. */
    public abstract double height();
}
