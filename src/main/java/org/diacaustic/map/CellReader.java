package org.diacaustic.map;

/** Reads cells of a store one by one. Working storage of one task. */
final class CellReader {
    private final CellStore store;
    private final double inverseUnit;

    /** Three vertices: x, y and z of each, in units of length from the origin of the store. */
    private final double[] vertices = new double[9];

    private CellChunk chunk;
    private int place;

    /** @param lengthUnit a power of two, in units of the store */
    CellReader(CellStore store, double lengthUnit) {
        this.store = store;
        this.inverseUnit = 1 / lengthUnit;
    }

    void read(int cell) {
        chunk = store.chunkOf(cell);
        place = cell & CellChunk.SIZE - 1;
        for (int axis = 0; axis < 3; axis++) {
            double first = chunk.vertices[3 * place + axis];
            vertices[axis] = first * inverseUnit;
            vertices[3 + axis] = (first + chunk.numbers[9 * place + axis]) * inverseUnit;
            vertices[6 + axis] = (first + chunk.numbers[9 * place + 3 + axis]) * inverseUnit;
        }
    }

    /** The smallest of a coordinate: 0 is x, 1 is y, 2 is z. */
    double smallest(int axis) {
        return Math.min(vertices[axis], Math.min(vertices[3 + axis], vertices[6 + axis]));
    }

    double largest(int axis) {
        return Math.max(vertices[axis], Math.max(vertices[3 + axis], vertices[6 + axis]));
    }

    double middle(int axis) {
        return 0.5 * (smallest(axis) + largest(axis));
    }

    /** The longest side of the box. */
    double extent() {
        return Math.max(largest(0) - smallest(0), Math.max(largest(1) - smallest(1), largest(2) - smallest(2)));
    }

    /** The largest of all coordinates, without sign. */
    double farthest() {
        double farthest = 0;
        for (double coordinate : vertices) {
            farthest = Math.max(farthest, Math.abs(coordinate));
        }
        return farthest;
    }

    /** Writes the cell as a {@link CausticMesh} keeps it, with vertices as offsets from a point. */
    void write(double x, double y, double z, float[] numbers, int number, int[] tags, int tag) {
        for (int i = 0; i < 9; i += 3) {
            numbers[number + i] = (float) (vertices[i] - x);
            numbers[number + i + 1] = (float) (vertices[i + 1] - y);
            numbers[number + i + 2] = (float) (vertices[i + 2] - z);
        }
        System.arraycopy(chunk.numbers, 9 * place + 6, numbers, number + 9, 3);
        tags[tag] = chunk.tags[2 * place];
        tags[tag + 1] = chunk.tags[2 * place + 1];
    }

    /** Writes the seed of the cell, if seeds are kept. */
    void writeSeed(CellSeeds seeds, int cell) {
        if (seeds != null) {
            seeds.copy(chunk.seeds, place, cell, 1);
        }
    }
}
