package org.diacaustic.preprocess;

import org.diacaustic.map.Chart;
import org.diacaustic.map.TexelGrid;
import org.diacaustic.math.Vector3;

/**
 * What of a convex polygon lies in each texel of its planar chart, exactly: the polygon is cut into the strips of the
 * rows, and each strip at the columns [Sutherland and Hodgman 1974].
 */
final class PolygonAreas {
    private final int columns;
    private final double texelArea;
    private Outline polygon;
    private final Outline strip;
    private final Outline cell;
    private final Outline spare;

    private PolygonAreas(Vector3[] corners, TexelGrid grid) {
        Chart chart = grid.chart();
        int most = corners.length + 4;
        this.columns = grid.columns();
        this.texelArea = chart.spread(1.0 / columns, 0, 1.0 / grid.rows());
        this.polygon = new Outline(most);
        this.strip = new Outline(most);
        this.cell = new Outline(most);
        this.spare = new Outline(most);
        for (Vector3 corner : corners) {
            polygon.add(
                    chart.u(corner.x(), corner.y(), corner.z()) * columns,
                    chart.v(corner.x(), corner.y(), corner.z()) * grid.rows());
        }
    }

    /** Areas in squared scene units, by texel. */
    static double[] of(Vector3[] corners, TexelGrid grid) {
        PolygonAreas areas = new PolygonAreas(corners, grid);
        double[] all = new double[grid.size()];
        for (int row = 0; row < grid.rows(); row++) {
            areas.fillRow(row, all);
        }
        return all;
    }

    private void fillRow(int row, double[] areas) {
        polygon.cut(1, row, 1, spare);
        spare.cut(1, row + 1.0, -1, strip);
        for (int column = 0; column < columns; column++) {
            strip.cut(0, column, 1, spare);
            spare.cut(0, column + 1.0, -1, cell);
            areas[row * columns + column] = cell.area() * texelArea;
        }
    }

    /** Corners in order around, in texels. */
    private static final class Outline {
        private final double[][] at;
        private int count;

        Outline(int most) {
            this.at = new double[2][most];
        }

        void add(double u, double v) {
            at[0][count] = u;
            at[1][count] = v;
            count++;
        }

        /** Sets {@code out} to what lies on one side of a line: above the limit for the sign 1, below for −1. */
        void cut(int axis, double limit, int sign, Outline out) {
            out.count = 0;
            for (int i = 0; i < count; i++) {
                int next = i + 1 == count ? 0 : i + 1;
                double from = sign * (at[axis][i] - limit);
                double to = sign * (at[axis][next] - limit);
                if (from >= 0) {
                    out.add(at[0][i], at[1][i]);
                }
                if (from > 0 && to < 0 || from < 0 && to > 0) {
                    double part = from / (from - to);
                    double u = at[0][i] + part * (at[0][next] - at[0][i]);
                    double v = at[1][i] + part * (at[1][next] - at[1][i]);
                    out.add(axis == 0 ? limit : u, axis == 1 ? limit : v);
                }
            }
        }

        /** Half the sum of the cross products of neighbouring corners, taken from the first. */
        double area() {
            double twice = 0;
            for (int i = 1; i + 1 < count; i++) {
                twice += (at[0][i] - at[0][0]) * (at[1][i + 1] - at[1][0])
                        - (at[1][i] - at[1][0]) * (at[0][i + 1] - at[0][0]);
            }
            return Math.abs(twice) / 2;
        }
    }
}
