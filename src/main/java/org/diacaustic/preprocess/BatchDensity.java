package org.diacaustic.preprocess;

import java.util.Arrays;

/**
 * How densely batches lie at a place of the unit square on which a window's light rays are laid out: each batch is uniform on
 * a square about its centre, as far as that is inside.
 */
final class BatchDensity {
    private final double half;
    private final double[] centres;
    private final int cells;
    /** Where the centres of each cell begin in {@link #byCell}. */
    private final int[] begin;

    private final int[] byCell;

    private BatchDensity(double half, double[] centres) {
        this.half = half;
        this.centres = centres;
        this.cells = (int) Math.max(1, Math.min(1024, Math.floor(1 / half)));
        int count = centres.length / 2;
        this.begin = new int[cells * cells + 1];
        for (int i = 0; i < count; i++) {
            begin[cell(i) + 1]++;
        }
        for (int i = 0; i < cells * cells; i++) {
            begin[i + 1] += begin[i];
        }
        this.byCell = new int[count];
        int[] next = Arrays.copyOf(begin, cells * cells);
        for (int i = 0; i < count; i++) {
            byCell[next[cell(i)]++] = i;
        }
    }

    /**
     * @param places pairs of coordinates in the square
     * @param chosen which of them are centres of batches
     * @param half half the side of a batch, at most 0.5
     */
    static BatchDensity around(double[] places, boolean[] chosen, double half) {
        double[] centres = new double[places.length];
        int count = 0;
        for (int i = 0; i < chosen.length; i++) {
            if (chosen[i]) {
                centres[count++] = places[2 * i];
                centres[count++] = places[2 * i + 1];
            }
        }
        return new BatchDensity(half, Arrays.copyOf(centres, count));
    }

    int count() {
        return centres.length / 2;
    }

    private int cell(int centre) {
        return line(centres[2 * centre + 1]) * cells + line(centres[2 * centre]);
    }

    private int line(double coordinate) {
        return (int) Math.min(cells - 1, coordinate * cells);
    }

    /** A place of a batch from a uniform number. */
    double spreadP(int batch, double uniform) {
        return spread(centres[2 * batch], uniform);
    }

    double spreadQ(int batch, double uniform) {
        return spread(centres[2 * batch + 1], uniform);
    }

    private double spread(double centre, double uniform) {
        return Math.max(0, centre - half) + uniform * width(centre);
    }

    private double width(double centre) {
        return Math.min(1, centre + half) - Math.max(0, centre - half);
    }

    /** The sum of the probability densities of all batches at a place. */
    double at(double p, double q) {
        // A place that a batch has spread to must not lie outside of it by rounding.
        double reach = half * (1 + 0x1p-40);
        double sum = 0;
        for (int row = Math.max(0, line(q) - 1); row <= Math.min(cells - 1, line(q) + 1); row++) {
            for (int column = Math.max(0, line(p) - 1); column <= Math.min(cells - 1, line(p) + 1); column++) {
                int cell = row * cells + column;
                for (int i = begin[cell]; i < begin[cell + 1]; i++) {
                    double x = centres[2 * byCell[i]];
                    double y = centres[2 * byCell[i] + 1];
                    if (Math.abs(p - x) <= reach && Math.abs(q - y) <= reach) {
                        sum += 1 / (width(x) * width(y));
                    }
                }
            }
        }
        return sum;
    }
}
