package org.diacaustic.preprocess;

/**
 * A part of the light space of one light point, laid out on the unit square: every point of the square is a light ray.
 * Immutable.
 */
public abstract class EmissionChart {
    private static final int SAMPLES = 8;

    /**
     * Sets origin and direction of the ray at (p, q), and how much of light space a unit of the square's area stands for
     * there.
     *
     * @param p from 0 to 1
     * @param q from 0 to 1
     */
    public abstract void aim(double p, double q, LightRay ray);

    /** How much of light space a unit of the square's area stands for at (p, q): what {@link #aim} sets as measure. */
    public abstract double density(double p, double q);

    /** About the mean of {@link #density}. */
    final double meanDensity() {
        double sum = 0;
        for (int i = 0; i < SAMPLES * SAMPLES; i++) {
            int row = i / SAMPLES;
            int column = i % SAMPLES;
            sum += density((column + 0.5) / SAMPLES, (row + 0.5) / SAMPLES);
        }
        return sum / (SAMPLES * SAMPLES);
    }

    /** How much of light space lies in a triangle of the square, without error where the density is quadratic in it. */
    final double measure(double p0, double q0, double p1, double q1, double p2, double q2) {
        double area = 0.5 * Math.abs((p1 - p0) * (q2 - q0) - (p2 - p0) * (q1 - q0));
        double mean = density(0.5 * (p0 + p1), 0.5 * (q0 + q1))
                + density(0.5 * (p1 + p2), 0.5 * (q1 + q2))
                + density(0.5 * (p2 + p0), 0.5 * (q2 + q0));
        return area * mean / 3;
    }

    /** The extent along p, in units common to the charts of one light point: lattices have the same step everywhere. */
    public abstract double width();

    /** The extent along q, in the same units. */
    public abstract double height();
}
