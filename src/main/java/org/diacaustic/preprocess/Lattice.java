package org.diacaustic.preprocess;

/** A regular lattice of rays on a chart: one in each of columns × rows equal parts of the square. */
final class Lattice {
    final EmissionChart chart;
    final int columns;
    final int rows;
    final double shiftP;
    final double shiftQ;

    /**
     * @param shiftP where the ray lies in its part along p, 0..1: 0 aligns the lattice left [Thesis 4.6]
     * @param shiftQ the same along q
     */
    Lattice(EmissionChart chart, int columns, int rows, double shiftP, double shiftQ) {
        this.chart = chart;
        this.columns = columns;
        this.rows = rows;
        this.shiftP = shiftP;
        this.shiftQ = shiftQ;
    }

    long size() {
        return (long) columns * rows;
    }

    /** The part of the chart that one ray stands for. */
    double share() {
        return 1.0 / columns / rows;
    }

    /** Aims at point i of the lattice, rows one after the other. */
    void aim(long i, LightRay ray) {
        aim(i, shiftP, shiftQ, ray);
    }

    /** Aims at a place in the part of point i. */
    void aim(long i, double withinP, double withinQ, LightRay ray) {
        long row = i / columns;
        long column = i - row * columns;
        chart.aim((column + withinP) / columns, (row + withinQ) / rows, ray);
    }
}
