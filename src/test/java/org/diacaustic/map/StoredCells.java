package org.diacaustic.map;

import org.diacaustic.math.Rgb;

/** Looks into a store of cells, for tests of what fills it. */
public final class StoredCells {
    private StoredCells() {}

    /** The power of all cells, in W. */
    public static Rgb power(CellStore store) {
        double red = 0;
        double green = 0;
        double blue = 0;
        for (int cell = 0; cell < store.size(); cell++) {
            CellChunk chunk = store.chunkOf(cell);
            int i = 9 * (cell & CellChunk.SIZE - 1) + 6;
            red += chunk.numbers[i];
            green += chunk.numbers[i + 1];
            blue += chunk.numbers[i + 2];
        }
        return new Rgb().set(red, green, blue).scale(store.powerUnit());
    }

    /** Two stores have the same, if they hold the same cells in the same order. */
    public static long bits(CellStore store) {
        long hash = store.size();
        for (int cell = 0; cell < store.size(); cell++) {
            CellChunk chunk = store.chunkOf(cell);
            int place = cell & CellChunk.SIZE - 1;
            for (int i = 0; i < 3; i++) {
                hash = 31 * hash + Double.doubleToLongBits(chunk.vertices[3 * place + i]);
            }
            for (int i = 0; i < 9; i++) {
                hash = 31 * hash + Float.floatToIntBits(chunk.numbers[9 * place + i]);
            }
            for (int i = 0; i < 2; i++) {
                hash = 31 * hash + chunk.tags[2 * place + i];
            }
        }
        return hash;
    }
}
