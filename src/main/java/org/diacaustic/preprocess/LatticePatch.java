package org.diacaustic.preprocess;

/**
 * Some base cells of a lattice: what one task makes.
 *
 * @param chart the number of the lattice in its pass
 * @param column of the first cell, even, as {@code row}
 * @param columns even, as {@code rows}
 */
record LatticePatch(MeshLattice lattice, int chart, int column, int row, int columns, int rows) {}
