package org.diacaustic.preprocess;

import java.util.List;
import org.diacaustic.light.LightPoint;

/**
 * What a few rays found of a beam before it is cut into cells.
 *
 * @param beam that was looked into
 * @param power that its light brings to diffuse surfaces, about, in W
 * @param cells that were looked at
 * @param mixed cells from whose corners light went different ways
 * @param growth how many times more of them there are when all are quartered: 2 along borders, 4 if ways part everywhere
 */
record MeshPilot(Beam beam, double power, double cells, double mixed, double growth) {
    private static final int SIDE = 32;
    private static final int LEAST_SIDE = 8;

    /** The part of light that decides. */
    private static final double STRONG = 0x1p-6;

    /** The cells along each side that are worth it for a beam of so many rays: no more than a sixteenth of them. */
    static int side(long rays) {
        int side = SIDE;
        while (side > LEAST_SIDE && side * side > rays / 16) {
            side /= 2;
        }
        return side;
    }

    /** Looks into a beam, from the middle of its light. */
    static MeshPilot of(PreProcessor preProcessor, Beam beam, LeafTracer tracer, int side, ForwardCounters counters) {
        LightPoint middle = new LightPoint();
        beam.light().emitFrom(0.5, 0.5, middle);
        double power = 0;
        double cells = 0;
        double mixed = 0;
        double mixedTwice = 0;
        LeafTable leaves = new LeafTable();
        LightRay ray = new LightRay();
        List<EmissionChart> charts = preProcessor.charts(beam, middle);
        for (EmissionChart chart : charts) {
            leaves.clear();
            tracer.startTask(leaves, counters);
            for (int row = 0; row <= side; row++) {
                for (int column = 0; column <= side; column++) {
                    chart.aim((double) column / side, (double) row / side, ray);
                    int number = tracer.trace(beam, middle, ray);
                    power += ray.measure * leaves.booked(number, LeafTracer.STORED);
                }
            }
            cells += side * side;
            mixed += mixed(leaves, side, 1);
            mixedTwice += mixed(leaves, side, 2);
        }
        double growth = mixedTwice == 0 ? 2 : Math.max(1.5, Math.min(4, mixed / mixedTwice));
        return new MeshPilot(beam, power / ((side + 1) * (side + 1)), cells, mixed, growth);
    }

    private static int mixed(LeafTable leaves, int side, int step) {
        int count = 0;
        for (int row = 0; row < side; row += step) {
            for (int column = 0; column < side; column += step) {
                int p = row * (side + 1) + column;
                int r = p + step * (side + 1);
                boolean agrees = leaves.agree(p, p + step, STRONG)
                        && leaves.agree(p + step, r + step, STRONG)
                        && leaves.agree(r + step, r, STRONG);
                count += agrees ? 0 : 1;
            }
        }
        return count;
    }

    /** How many of so many cells will be mixed. */
    double mixedAt(double baseCells) {
        double halvings = 0.5 * StrictMath.log(baseCells / cells) / StrictMath.log(2);
        double estimate = mixed * StrictMath.pow(growth, halvings);
        return Math.min(baseCells, estimate);
    }

    /** By which the rays are dealt out: errors grow with the power and fall with the rays, so their squares' sum is least. */
    double importance() {
        return power > 0 ? StrictMath.cbrt(power * power) : 0;
    }
}
