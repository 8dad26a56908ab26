package org.diacaustic.preprocess;

import org.diacaustic.map.Chart;
import org.diacaustic.math.Ray;
import org.diacaustic.math.SampleStream;
import org.diacaustic.shape.Hit;

/**
 * Evenly spread lines through a surface: one of a chart's lines in each of columns × rows parts over which these lines spread
 * equally. Around a point the rows are zones of equal height, so that they crowd at the poles no more than elsewhere.
 * Immutable.
 */
final class LineLattice {
    /** Another irrational than that of {@link AxisLines}, so that no diagonal runs along a row of lines either. */
    private static final double SHEAR_U = Math.sqrt(2) - 1;

    private final Chart chart;
    private final int columns;
    private final int rows;
    private final boolean isSheared;
    private final double shiftU;
    private final double shiftV;
    private final double spreadOfLine;

    /** @param random for a common shift of all lines; null aligns the lattice left, in straight rows [Thesis 4.6] */
    LineLattice(Chart chart, int columns, int rows, SampleStream random) {
        this.chart = chart;
        this.columns = columns;
        this.rows = rows;
        this.isSheared = random != null;
        this.shiftU = random == null ? 0 : random.nextDouble();
        this.shiftV = random == null ? 0 : random.nextDouble();
        this.spreadOfLine = chart.spread(1, 0, 1) / columns / rows;
    }

    long size() {
        return (long) columns * rows;
    }

    /** Sets the ray along line i of the lattice, rows one after the other. */
    void aim(long i, Ray ray) {
        long column = i % columns;
        long row = i / columns;
        double share = (row + within(shiftV, column, AxisLines.SHEAR)) / rows;
        double v = chart.goesAround() ? StrictMath.acos(1 - 2 * share) / Math.PI : share;
        chart.aim((column + within(shiftU, row, SHEAR_U)) / columns, v, ray);
    }

    /** Where in its part the line lies. Not in straight rows, for edges, and the zones at the poles, run along those. */
    private double within(double shift, long across, double shear) {
        double sheared = isSheared ? shift + across * shear : shift;
        return sheared - Math.floor(sheared);
    }

    /** Whether the lines begin in the midst of the surface, at the point that they all come from. */
    boolean startsInside() {
        return chart.goesAround();
    }

    /**
     * How many lines cross a unit of the surface's area at a crossing, averaged over all shifts.
     *
     * @param cosine of the line to the surface's normal
     */
    double density(Hit at, double cosine) {
        return Math.abs(cosine) / (chart.sectionPerSpread(at.x, at.y, at.z) * spreadOfLine);
    }

    /** As {@link #density(Hit, double)} where a line of another lattice crosses; the ray is overwritten. */
    double density(Hit at, Ray own) {
        chart.aim(chart.u(at.x, at.y, at.z), chart.v(at.x, at.y, at.z), own);
        return density(at, own.directionX * at.normalX + own.directionY * at.normalY + own.directionZ * at.normalZ);
    }
}
