package org.diacaustic.map;

import org.diacaustic.math.Rgb;

/**
 * Light rays between those that bound a cell: what a {@link CausticMesh} needs to find the one that lands exactly at a point.
 * Owned by one task.
 */
public interface LightPaths {

    /** Goes to a cell, whose seed is known: rays are named by places in it from now on. */
    void enter(CellSeed cell);

    /**
     * Follows the light ray at a place of the cell along the cell's way. Rays change smoothly with the place.
     *
     * @param s the weight of the cell's second corner: its corners are at (0, 0), (1, 0) and (0, 1)
     * @param t the weight of its third corner
     * @param at set to where the ray lands
     * @param power set to what lands for a unit of area of (s, t), in W
     * @return whether the ray came that way; if not, nothing is set
     */
    boolean follow(double s, double t, SurfacePoint at, Rgb power);
}
