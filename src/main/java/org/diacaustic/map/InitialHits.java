package org.diacaustic.map;

import java.util.List;

/**
 * The second map of the thesis' objects [Thesis 4.4]: it lets only the first few primary light rays that strike a cell of
 * an object go on, so that almost equal rays cannot crowd an ambient map. It discards power and depends on the order of
 * the rays: it is here to repeat the thesis, and runs on one thread.
 */
public final class InitialHits {
    private final TexelGrid[] grids;
    private final int[][] admitted;
    private final int raysPerCell;

    /**
     * @param grids of the objects in the order of the scene's list; null for those that admit every ray
     * @param raysPerCell at least 1
     */
    public InitialHits(List<TexelGrid> grids, int raysPerCell) {
        if (raysPerCell < 1) {
            throw new IllegalArgumentException(
                    "a cell of an initial-hit map must admit at least 1 ray, but admits " + raysPerCell);
        }
        this.grids = grids.toArray(TexelGrid[]::new);
        this.admitted = new int[this.grids.length][];
        this.raysPerCell = raysPerCell;
        for (int i = 0; i < admitted.length; i++) {
            admitted[i] = this.grids[i] == null ? null : new int[this.grids[i].size()];
        }
    }

    /** Whether a primary ray that strikes an object at the point goes on; if so, its cell has one ray more. */
    public boolean admit(int object, double x, double y, double z) {
        TexelGrid grid = grids[object];
        if (grid == null) {
            return true;
        }
        int cell = grid.texel(x, y, z);
        if (admitted[object][cell] == raysPerCell) {
            return false;
        }
        admitted[object][cell]++;
        return true;
    }
}
