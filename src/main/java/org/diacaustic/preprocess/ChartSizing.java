package org.diacaustic.preprocess;

/** Says how fine the map of each object is. */
@FunctionalInterface
public interface ChartSizing {

    /** The size for an object, by its number in the scene's list. */
    ChartSize of(int object);

    /** The same for all objects, as in the thesis [Thesis 4.4]. */
    static ChartSizing equal(int columns, int rows) {
        ChartSize size = new ChartSize(columns, rows);
        return object -> size;
    }
}
