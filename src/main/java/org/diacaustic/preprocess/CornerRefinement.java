package org.diacaustic.preprocess;

import java.util.List;

/**
 * The thesis' way to refine: where at least two of four neighbouring rays were stored, the quadrangle between them is cut, and
 * the new corners are sent out too [Thesis 4.7.1; THESIS-NOTES identity 10]. Every ray is stored.
 */
final class CornerRefinement {
    private static final int STORED_CORNERS = 2;

    private final Beam beam;
    private final ForwardPass pass;
    private final int split;
    private final int depth;

    CornerRefinement(Beam beam, ForwardPass pass) {
        this.beam = beam;
        this.pass = pass;
        this.split = beam.settings().split();
        this.depth = beam.settings().splitDepth();
    }

    void run(List<Lattices.PointLattices> all) {
        for (Lattices.PointLattices point : all) {
            for (Lattice lattice : point.lattices()) {
                boolean[] stored = CellRefinement.cells(lattice.size());
                pass.shootRays(lattice.size(), (i, emitter) -> {
                    emitter.point(point.s(), point.t());
                    lattice.aim(i, emitter.ray());
                    stored[(int) i] = emitter.shoot(1) > 0;
                });
                pass.shootTasks(lattice.rows - 1, (row, emitter) -> {
                    emitter.point(point.s(), point.t());
                    Quadrangles quadrangles = new Quadrangles(lattice, emitter);
                    for (int column = 0; column + 1 < lattice.columns; column++) {
                        int i = row * lattice.columns + column;
                        int below = i + lattice.columns;
                        quadrangles.refine(
                                column, row, 1, depth, stored[i], stored[i + 1], stored[below], stored[below + 1]);
                    }
                });
            }
        }
    }

    /** Cuts quadrangles of a lattice into ever smaller ones. */
    private final class Quadrangles {
        private final Lattice lattice;
        private final LightEmitter emitter;

        Quadrangles(Lattice lattice, LightEmitter emitter) {
            this.lattice = lattice;
            this.emitter = emitter;
        }

        /** Position and size in steps of the lattice; then the four corners, whether they were stored. */
        void refine(double column, double row, double size, int levels, boolean a, boolean b, boolean c, boolean d) {
            int corners = (a ? 1 : 0) + (b ? 1 : 0) + (c ? 1 : 0) + (d ? 1 : 0);
            if (corners < STORED_CORNERS || levels == 0) {
                return;
            }
            double step = size / split;
            boolean[][] stored = new boolean[split + 1][split + 1];
            stored[0][0] = a;
            stored[0][split] = b;
            stored[split][0] = c;
            stored[split][split] = d;
            for (int j = 0; j <= split; j++) {
                for (int i = 0; i <= split; i++) {
                    if (i % split != 0 || j % split != 0) {
                        stored[j][i] = shoot(column + i * step, row + j * step);
                    }
                }
            }
            for (int j = 0; j < split; j++) {
                for (int i = 0; i < split; i++) {
                    refine(
                            column + i * step,
                            row + j * step,
                            step,
                            levels - 1,
                            stored[j][i],
                            stored[j][i + 1],
                            stored[j + 1][i],
                            stored[j + 1][i + 1]);
                }
            }
        }

        private boolean shoot(double column, double row) {
            lattice.chart.aim(
                    (column + lattice.shiftP) / lattice.columns, (row + lattice.shiftQ) / lattice.rows, emitter.ray());
            return emitter.shoot(1) > 0;
        }
    }
}
