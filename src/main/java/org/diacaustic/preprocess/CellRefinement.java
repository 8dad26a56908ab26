package org.diacaustic.preprocess;

import java.util.Arrays;
import org.diacaustic.math.SampleStream;

/**
 * Refinement that stays right on average: one ray looks into every cell; cells in which it found something, and their
 * neighbours, are cut and looked into again; then every cell that is left, large or small, is lit by a ray of its own that
 * stands for all of it. Rays that look are not stored, so what they found decides only where cells are small.
 */
final class CellRefinement {
    /** Parts along the side of a cell, at most: their number is still a number of cells. */
    private static final int MOST_PARTS = 1 << 15;

    private final Beam beam;
    private final ForwardPass pass;
    private final Lattices.PointLattices point;
    private final double pointShare;

    /** @param pointShare the part of the light that the point stands for */
    CellRefinement(Beam beam, ForwardPass pass, Lattices.PointLattices point, double pointShare) {
        this.beam = beam;
        this.pass = pass;
        this.point = point;
        this.pointShare = pointShare;
    }

    /** @param rays to spend on the point, about, if the settings do not say how to cut */
    void run(long rays) {
        int split = beam.settings().split();
        int depth = beam.settings().splitDepth();
        boolean isSized = beam.settings().latticeSize() > 0;
        long firstLevel = point.lattices().stream().mapToLong(Lattice::size).sum();
        for (Lattice lattice : point.lattices()) {
            Lattice level = lattice;
            boolean[] wanted = cells(level.size());
            Arrays.fill(wanted, true);
            long spent = 0;
            for (int i = 0; i < depth; i++) {
                boolean[] found = look(level, wanted);
                spent += count(wanted);
                boolean[] kept = wanted;
                wanted = widened(found, kept, level.columns, level.rows);
                boolean[] coarse = difference(kept, wanted);
                light(level, coarse);
                spent += count(coarse);
                int parts = split;
                if (i == depth - 1 && !isSized && count(wanted) > 0) {
                    double share = (double) lattice.size() / firstLevel;
                    double perCell = Math.sqrt(Math.max(1, (rays * share - spent) / count(wanted)));
                    parts = (int) Math.min(MOST_PARTS, Math.rint(perCell));
                }
                wanted = cut(wanted, level, parts);
                level = finer(level, parts);
            }
            light(level, wanted);
        }
    }

    private static Lattice finer(Lattice level, int parts) {
        return new Lattice(level.chart, level.columns * parts, level.rows * parts, level.shiftP, level.shiftQ);
    }

    /** Sends a ray into every wanted cell that is not stored, and says which found something. */
    private boolean[] look(Lattice level, boolean[] wanted) {
        boolean[] found = new boolean[wanted.length];
        pass.shootRays(level.size(), (i, emitter) -> {
            if (wanted[(int) i]) {
                emitter.point(point.s(), point.t());
                level.aim(i, emitter.ray());
                found[(int) i] = emitter.probe() > 0;
            }
        });
        return found;
    }

    /** Sends a ray into every wanted cell, at a place of its own, that stands for the cell. */
    private void light(Lattice level, boolean[] wanted) {
        double share = pointShare * level.share();
        pass.shootRays(level.size(), (i, emitter) -> {
            if (wanted[(int) i]) {
                SampleStream random = emitter.random(i);
                emitter.point(point.s(), point.t());
                level.aim(i, random.nextDouble(), random.nextDouble(), emitter.ray());
                emitter.shoot(share);
            }
        });
    }

    /** The cells that were looked into and have found something, or whose neighbours have. */
    private static boolean[] widened(boolean[] found, boolean[] lookedInto, int columns, int rows) {
        boolean[] wide = new boolean[found.length];
        for (int i = 0; i < found.length; i++) {
            if (found[i]) {
                int column = i % columns;
                int row = i / columns;
                for (int y = Math.max(0, row - 1); y <= Math.min(rows - 1, row + 1); y++) {
                    for (int x = Math.max(0, column - 1); x <= Math.min(columns - 1, column + 1); x++) {
                        wide[y * columns + x] |= lookedInto[y * columns + x];
                    }
                }
            }
        }
        return wide;
    }

    private static boolean[] difference(boolean[] all, boolean[] without) {
        boolean[] rest = all.clone();
        for (int i = 0; i < rest.length; i++) {
            rest[i] &= !without[i];
        }
        return rest;
    }

    private static boolean[] cut(boolean[] wanted, Lattice level, int parts) {
        boolean[] finer = cells((long) wanted.length * parts * parts);
        int columns = level.columns * parts;
        for (int i = 0; i < finer.length; i++) {
            finer[i] = wanted[i / columns / parts * level.columns + i % columns / parts];
        }
        return finer;
    }

    /** @throws ForwardPlanException if they are too many for an array */
    static boolean[] cells(long count) {
        if (count > Integer.MAX_VALUE - 8) {
            throw new ForwardPlanException(
                    "preprocessor '" + AdaptivePreProcessor.NAME + "' would cut its lattice into " + count
                            + " cells, which are too many; give fewer rays, or a smaller lattice-size, split or split-depth");
        }
        return new boolean[(int) count];
    }

    private static long count(boolean[] cells) {
        long count = 0;
        for (boolean cell : cells) {
            count += cell ? 1 : 0;
        }
        return count;
    }
}
