package org.diacaustic.map;

/**
 * Which light rays bound a triangle of light, and which way they came: what it takes to follow others between them. The
 * corners are in the order of the triangle's vertices. Mutable, owned by one task.
 */
public final class CellSeed {
    /** The number of the chart on which the rays are laid out; negative if this is not known. */
    public int chart;

    /** The signature of the way from the light to the receiver. */
    public long path;

    /** Where on the unit square of the chart the corners are. */
    public double p0;

    public double q0;
    public double p1;
    public double q1;
    public double p2;
    public double q2;
}
