package org.diacaustic.map;

import org.diacaustic.math.Ray;
import org.diacaustic.math.Vector3;

/**
 * How the points of a surface are brought to the unit square of its map [Thesis 2.4]: along parallel lines or along
 * the lines from a point. All points of one such line have the same u and v; {@link #aim} gives the line, so whoever knows
 * the surface can measure what area of it a part of the map stands for.
 */
public sealed interface Chart permits PlanarChart, SphericalChart {

    /**
     * A parallelogram is the map; points off it are projected along its normal.
     *
     * @param origin the point of u = v = 0
     * @param sideU from the origin to u = 1, in scene units
     * @param sideV from the origin to v = 1, in scene units
     * @throws IllegalArgumentException if the sides are parallel, zero or not finite
     */
    static Chart planar(Vector3 origin, Vector3 sideU, Vector3 sideV) {
        return new PlanarChart(origin, sideU, sideV);
    }

    /**
     * The directions from a point are the map [Thesis 2.4, Eq. 4]: v = 0 at the south pole, 1 at the north; u runs once
     * around, from the equator vector towards pole × equator.
     *
     * @param pole the direction of v = 1
     * @param equator the direction of u = 0; its part along the pole is left out
     * @throws IllegalArgumentException if pole and equator are parallel, zero or not finite
     */
    static Chart spherical(Vector3 centre, Vector3 pole, Vector3 equator) {
        return new SphericalChart(centre, pole, equator);
    }

    /** In 0..1 for the points of the surface that the chart was made for. */
    double u(double x, double y, double z);

    /** In 0..1 for the points of the surface that the chart was made for. */
    double v(double x, double y, double z);

    /** Whether u = 1 is u = 0 again, and the map goes on beyond v = 0 and v = 1 at half a turn from there. */
    boolean goesAround();

    /** Sets the ray along the line of all points with this u and v; its direction has length 1. */
    void aim(double u, double v, Ray ray);

    /**
     * How far the lines of a part of the map spread: their cross-section in squared scene units if they are parallel, their
     * solid angle in sr if they come from a point.
     *
     * @param width in u
     * @param lowV one border in v
     * @param highV the other
     */
    double spread(double width, double lowV, double highV);

    /** The cross-section of lines at the point, ÷ how far they spread. */
    double sectionPerSpread(double x, double y, double z);
}
