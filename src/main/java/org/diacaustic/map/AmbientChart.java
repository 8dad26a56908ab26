package org.diacaustic.map;

import java.util.Objects;

/**
 * The map of one object, still without light: its texels, and the true area of the surface that each stands for. A texel
 * that has less than an eighth of the area of its largest neighbour is joined to that one: a map that is
 * cut off by the edge of its surface would else have slivers, on which a single photon looks like a flash. Immutable.
 */
public final class AmbientChart {
    private final int object;
    private final TexelGrid grid;
    private final JoinedTexels texels;

    /**
     * @param object the number of the object in the scene's list
     * @param areas of the surface by texel, in squared scene units
     * @throws IllegalArgumentException if their number is not that of the texels, one is negative or not finite, or all are
     *     zero
     */
    public AmbientChart(int object, TexelGrid grid, double[] areas) {
        Objects.requireNonNull(grid, "grid");
        if (object < 0) {
            throw new IllegalArgumentException("an object's number must be at least 0, but is " + object);
        }
        if (areas.length != grid.size()) {
            throw new IllegalArgumentException(
                    "a map of " + grid.size() + " texels needs an area for each, but has " + areas.length);
        }
        boolean any = false;
        for (double area : areas) {
            if (!(area >= 0 && area < Double.POSITIVE_INFINITY)) {
                throw new IllegalArgumentException(
                        "areas of texels must be finite and not negative, but one is " + area);
            }
            any |= area > 0;
        }
        if (!any) {
            throw new IllegalArgumentException("a map needs a texel with an area, but has none");
        }
        this.object = object;
        this.grid = grid;
        this.texels = JoinedTexels.joinSlivers(grid, areas);
    }

    public int object() {
        return object;
    }

    public TexelGrid grid() {
        return grid;
    }

    /** The area of the surface that a texel stands for, with all that is joined to it, in squared scene units. */
    public double area(int texel) {
        return texels.area(texels.keeper(texel));
    }

    JoinedTexels texels() {
        return texels;
    }
}
