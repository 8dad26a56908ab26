package org.diacaustic.preprocess;

/**
 * The size of a map in texels.
 *
 * @param columns around, or along the first edge
 * @param rows from pole to pole, or along the second edge
 */
public record ChartSize(int columns, int rows) {

    /** @throws IllegalArgumentException unless both are at least 1 */
    public ChartSize {
        if (columns < 1 || rows < 1) {
            throw new IllegalArgumentException("a map needs at least 1 x 1 texels, but has " + columns + " x " + rows);
        }
    }
}
