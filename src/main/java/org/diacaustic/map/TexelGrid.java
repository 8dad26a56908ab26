package org.diacaustic.map;

/**
 * A chart cut into columns × rows texels, numbered row by row from the origin of u and v. What borders on what is
 * known here: around the seam, and straight over the poles of a chart that goes around.
 */
public final class TexelGrid {
    /** The number of no texel. */
    static final int NONE = -1;

    private final Chart chart;
    private final int columns;
    private final int rows;

    /**
     * @param columns along u; even if the chart goes around, so that every texel has one straight over the pole
     * @param rows along v
     * @throws IllegalArgumentException if there are none, too many for an array, or odd columns that go around
     */
    public TexelGrid(Chart chart, int columns, int rows) {
        if (columns < 1 || rows < 1 || (long) columns * rows > Integer.MAX_VALUE / 4) {
            throw new IllegalArgumentException("a map needs at least 1 x 1 texels and at most " + Integer.MAX_VALUE / 4
                    + " altogether, but has " + columns + " x " + rows);
        }
        if (chart.goesAround() && columns % 2 != 0) {
            throw new IllegalArgumentException(
                    "a map that goes around needs an even number of columns, but has " + columns);
        }
        this.chart = chart;
        this.columns = columns;
        this.rows = rows;
    }

    public Chart chart() {
        return chart;
    }

    public int columns() {
        return columns;
    }

    public int rows() {
        return rows;
    }

    /** The number of texels. */
    public int size() {
        return columns * rows;
    }

    /** The texel that a point belongs to; points beyond the map belong to its border. */
    public int texel(double x, double y, double z) {
        int column = within((int) Math.floor(chart.u(x, y, z) * columns), columns);
        int row = within((int) Math.floor(chart.v(x, y, z) * rows), rows);
        return row * columns + column;
    }

    /** The texel in a column and row that may lie beyond the border, or {@link #NONE} if nothing goes on there. */
    int beyondBorder(int column, int row) {
        if (!chart.goesAround()) {
            return column < 0 || column >= columns || row < 0 || row >= rows ? NONE : row * columns + column;
        }
        int inside = row < 0 ? -1 - row : row >= rows ? 2 * rows - 1 - row : row;
        if (inside < 0 || inside >= rows) {
            return NONE;
        }
        int turned = inside == row ? column : column + columns / 2;
        return inside * columns + Math.floorMod(turned, columns);
    }

    /** The texel in a column and row that may lie one beyond the border: the one at the border if nothing goes on there. */
    int atBorder(int column, int row) {
        return chart.goesAround() ? beyondBorder(column, row) : within(row, rows) * columns + within(column, columns);
    }

    private static int within(int index, int count) {
        return Math.max(0, Math.min(count - 1, index));
    }
}
