package org.diacaustic.map;

/** Seeds of cells, by number: 60 bytes each, in primitive arrays. */
final class CellSeeds {
    /** The memory of one. */
    static final long BYTES = 6L * Double.BYTES + Long.BYTES + Integer.BYTES;

    private static final int PLACES = 6;

    private final int[] charts;
    private final long[] paths;
    private final double[] places;

    CellSeeds(int size) {
        charts = new int[size];
        paths = new long[size];
        places = new double[PLACES * size];
    }

    void write(int cell, CellSeed seed) {
        charts[cell] = seed.chart;
        paths[cell] = seed.path;
        int i = PLACES * cell;
        places[i] = seed.p0;
        places[i + 1] = seed.q0;
        places[i + 2] = seed.p1;
        places[i + 3] = seed.q1;
        places[i + 4] = seed.p2;
        places[i + 5] = seed.q2;
    }

    /** Notes that a cell has none. */
    void writeNone(int cell) {
        charts[cell] = -1;
    }

    /** Sets the seed of a cell; false if it has none. */
    boolean read(int cell, CellSeed out) {
        out.chart = charts[cell];
        out.path = paths[cell];
        int i = PLACES * cell;
        out.p0 = places[i];
        out.q0 = places[i + 1];
        out.p1 = places[i + 2];
        out.q1 = places[i + 3];
        out.p2 = places[i + 4];
        out.q2 = places[i + 5];
        return out.chart >= 0;
    }

    /** Copies seeds from others. */
    void copy(CellSeeds from, int fromCell, int cell, int count) {
        System.arraycopy(from.charts, fromCell, charts, cell, count);
        System.arraycopy(from.paths, fromCell, paths, cell, count);
        System.arraycopy(from.places, PLACES * fromCell, places, PLACES * cell, PLACES * count);
    }
}
