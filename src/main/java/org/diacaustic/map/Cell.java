package org.diacaustic.map;

import org.diacaustic.math.Rgb;

/** A cell of light that was read from a {@link CellStore}. Mutable, owned by one task, used again from cell to cell. */
public final class Cell {
    /** x, y and z of three vertices, in scene units: two that are equal make a line, three a point. */
    public final double[] vertices = new double[9];

    /** In W. */
    public final Rgb power = new Rgb();

    /** The object that is lit, by number. */
    public int object;

    /** The side of it: whether that of its normal. */
    public boolean front;

    /** Where the light comes from, if {@link #hasSeed} says that this is known. */
    public final CellSeed seed = new CellSeed();

    public boolean hasSeed;
}
