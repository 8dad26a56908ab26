package org.diacaustic.preprocess;

import org.diacaustic.light.LightPoint;
import org.diacaustic.map.CellSeed;

/**
 * The base cells of a caustic mesh on one chart of one light point, and how far they may be cut. Rays are named by places
 * on a grid that is finer than any cell: whole numbers, so that neighbouring cells name the rays that they share alike.
 *
 * @param beam whose window the chart covers
 * @param point of the beam's light
 * @param chart the part of light space that is cut into cells
 * @param columns base cells along p, even
 * @param rows base cells along q, even
 * @param depth how often a base cell may be halved
 * @param pointShare the part of the light that the point stands for
 * @param meanDensity of light space on the chart
 */
record MeshLattice(
        Beam beam,
        LightPoint point,
        EmissionChart chart,
        int columns,
        int rows,
        int depth,
        double pointShare,
        double meanDensity) {

    /** Places of the grid along the side of a base cell. */
    int cellSize() {
        return 1 << depth;
    }

    /** How much of light space lies in a triangle of the chart, for the light's share of this point. */
    double measure(CellSeed corners) {
        return pointShare * chart.measure(corners.p0, corners.q0, corners.p1, corners.q1, corners.p2, corners.q2);
    }

    /** Where on the chart a place is. */
    double p(double x) {
        return x / ((double) columns * cellSize());
    }

    double q(double y) {
        return y / ((double) rows * cellSize());
    }
}
