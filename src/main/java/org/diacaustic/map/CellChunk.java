package org.diacaustic.map;

/** Room for a few cells of light. The numbers of a cell lie in a row, as cells are read one here and one there. */
final class CellChunk {
    static final int BITS = 8;

    /** The number of cells that fit. */
    static final int SIZE = 1 << BITS;

    /** The memory that a chunk takes, without seeds. */
    static final long BYTES = SIZE * (3L * Double.BYTES + 9L * Float.BYTES + 2L * Integer.BYTES);

    /** The first vertex of each cell: x, y and z, as offsets from the origin of the store, in scene units. */
    final double[] vertices = new double[3 * SIZE];

    /** Of each cell: second vertex − first, third − first, in scene units; red, green and blue power, in units of power. */
    final float[] numbers = new float[9 * SIZE];

    /** Of each cell: the packed normal, and the receiver, which is object · 2 + front. */
    final int[] tags = new int[2 * SIZE];

    /** Null if they are not kept. */
    final CellSeeds seeds;

    CellChunk(boolean keepsSeeds) {
        seeds = keepsSeeds ? new CellSeeds(SIZE) : null;
    }

    /** Copies cells from another chunk, which keeps what this one does. */
    void copy(CellChunk from, int fromPlace, int place, int count) {
        System.arraycopy(from.vertices, 3 * fromPlace, vertices, 3 * place, 3 * count);
        System.arraycopy(from.numbers, 9 * fromPlace, numbers, 9 * place, 9 * count);
        System.arraycopy(from.tags, 2 * fromPlace, tags, 2 * place, 2 * count);
        if (seeds != null) {
            seeds.copy(from.seeds, fromPlace, place, count);
        }
    }
}
