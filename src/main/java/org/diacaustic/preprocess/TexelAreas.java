package org.diacaustic.preprocess;

import java.util.Arrays;
import org.diacaustic.map.Chart;
import org.diacaustic.map.TexelGrid;
import org.diacaustic.math.Ray;
import org.diacaustic.parallel.Workers;
import org.diacaustic.shape.Hit;
import org.diacaustic.shape.Shape;

/**
 * The true area of the surface behind every texel, by quadrature through the shape: lines of the chart, and at every crossing
 * the cross-section that the line stands for ÷ |cosine to the normal|. Texels that differ from their neighbours, as
 * at an edge, get more lines. Where the lines only graze the surface they count for less, down to nothing, and lines
 * along the axes make up for it. It tends to the area as the lines get denser, whatever the shape.
 */
final class TexelAreas {
    /** Lines on each side of a texel that is looked at closely. */
    private static final int CLOSE = 8;

    /** Maps of no more texels than this are looked at closely everywhere. */
    private static final int SMALL = 1 << 13;

    /** Texels whose neighbour has that many times more or less, as their lines tell, are looked at closely. */
    private static final double UNEVEN = 1.125;

    /** The cosine below which a line of the chart grazes. */
    private static final double GRAZING = 0.25;

    private static final int AXIS_LINES = 256;
    private static final int FEW_AXIS_LINES = 32;

    private final Shape shape;
    private final TexelGrid grid;
    private final Chart chart;
    private final Workers workers;
    private final double[] areas;

    private TexelAreas(Shape shape, TexelGrid grid, Workers workers) {
        this.shape = shape;
        this.grid = grid;
        this.chart = grid.chart();
        this.workers = workers;
        this.areas = new double[grid.size()];
    }

    /** Areas in squared scene units, by texel. */
    static double[] of(Shape shape, TexelGrid grid, Workers workers) {
        TexelAreas all = new TexelAreas(shape, grid, workers);
        boolean[] close = new boolean[grid.size()];
        if (grid.size() <= SMALL) {
            Arrays.fill(close, true);
        } else {
            all.measure(new boolean[grid.size()], false);
            all.markUneven(close);
        }
        all.measure(close, true);
        if (all.isGrazed()) {
            all.addGrazed();
        }
        return all.areas;
    }

    /** Measures the texels that are marked, closely, or those that are not, by one line each. */
    private void measure(boolean[] close, boolean marked) {
        workers.run(grid.rows(), () -> {
            Crossings line = new Crossings();
            return row -> {
                for (int column = 0; column < grid.columns(); column++) {
                    int texel = row * grid.columns() + column;
                    if (close[texel] == marked) {
                        areas[texel] = texelArea(column, row, marked ? CLOSE : 1, line);
                    }
                }
            };
        });
    }

    private double texelArea(int column, int row, int across, Crossings line) {
        double width = 1.0 / (grid.columns() * across);
        double height = 1.0 / (grid.rows() * across);
        double sum = 0;
        for (int i = row * across; i < (row + 1) * across; i++) {
            double sections = 0;
            for (int k = column * across; k < (column + 1) * across; k++) {
                chart.aim((k + within(i, across)) * width, (i + within(k, across)) * height, line.ray);
                sections += sections(line);
            }
            sum += sections * chart.spread(width, i * height, (i + 1) * height);
        }
        return sum;
    }

    /** Where in its part of the texel a line runs; not in straight rows, for edges like to run along those. */
    private static double within(int number, int across) {
        double sheared = (number + 0.5) * AxisLines.SHEAR;
        return across == 1 ? 0.5 : sheared - Math.floor(sheared);
    }

    /** The surface that a line crosses and does not graze, per spread. */
    private double sections(Crossings line) {
        if (!chart.goesAround()) {
            line.startBefore(shape.bounds());
        }
        double sum = 0;
        while (line.next(shape)) {
            double cosine = Math.abs(line.cosine());
            double section = chart.sectionPerSpread(line.hit.x, line.hit.y, line.hit.z);
            sum += cosine < GRAZING ? section * cosine / (GRAZING * GRAZING) : section / cosine;
        }
        return sum;
    }

    private void markUneven(boolean[] close) {
        for (int row = 0; row < grid.rows(); row++) {
            for (int column = 0; column < grid.columns(); column++) {
                int texel = row * grid.columns() + column;
                mark(texel, row, row * grid.columns() + (column + 1) % grid.columns(), row, close);
                if (row + 1 < grid.rows()) {
                    mark(texel, row, texel + grid.columns(), row + 1, close);
                }
            }
        }
    }

    private void mark(int texel, int row, int neighbour, int neighbourRow, boolean[] close) {
        double own = areas[texel] / spread(row);
        double other = areas[neighbour] / spread(neighbourRow);
        if (own > UNEVEN * other || other > UNEVEN * own) {
            close[texel] = true;
            close[neighbour] = true;
        }
    }

    private double spread(int row) {
        return chart.spread(1.0 / grid.columns(), (double) row / grid.rows(), (row + 1.0) / grid.rows());
    }

    /** Whether any part of the surface that is not tiny is grazed. */
    private boolean isGrazed() {
        boolean[] found = new boolean[1];
        Ray own = new Ray();
        AxisLines.visit(shape, FEW_AXIS_LINES, (line, area) -> found[0] |= cosine(line.hit, own) < GRAZING);
        return found[0];
    }

    /** Adds what {@link #sections} leaves of grazed surfaces to the texels that they belong to. */
    private void addGrazed() {
        Ray own = new Ray();
        AxisLines.visit(shape, AXIS_LINES, (line, area) -> {
            Hit hit = line.hit;
            double part = cosine(hit, own) / GRAZING;
            if (part < 1) {
                areas[grid.texel(hit.x, hit.y, hit.z)] += area * (1 - part * part);
            }
        });
    }

    /** Of the chart's own line at a point to the normal there, without its sign. */
    private double cosine(Hit hit, Ray own) {
        chart.aim(chart.u(hit.x, hit.y, hit.z), chart.v(hit.x, hit.y, hit.z), own);
        return Math.abs(own.directionX * hit.normalX + own.directionY * hit.normalY + own.directionZ * hit.normalZ);
    }
}
