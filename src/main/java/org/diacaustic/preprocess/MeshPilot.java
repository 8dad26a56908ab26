package org.diacaustic.preprocess;

import java.util.List;
import org.diacaustic.light.LightPoint;
import org.diacaustic.math.Rgb;
import org.diacaustic.math.SampleStream;

/** Looks with a few rays into a beam, before it is cut into cells, to find what that will take. Owned by one task. */
final class MeshPilot {
    /** Cells along each side that are looked at for their power, for enough rays. */
    private static final int SIDE = 16;

    /** Cells that are looked at to see how often they will be quartered, for enough rays. */
    private static final int CELLS = 512;

    /** The part of a beam's rays that may go in advance. */
    private static final double SHARE = 1.0 / 16;

    private final Beam beam;
    private final LeafTracer tracer;
    private double tornPower;
    private double allPower;
    private final LeafTable leaves = new LeafTable();
    private final LightPoint middle = new LightPoint();
    private final LightRay ray = new LightRay();
    private final Rgb power = new Rgb();
    private final List<EmissionChart> charts;

    /** @param counters to which the rays are added */
    MeshPilot(PreProcessor preProcessor, Beam beam, LeafTracer tracer, ForwardCounters counters) {
        this.beam = beam;
        this.tracer = tracer;
        beam.light().emitFrom(0.5, 0.5, middle);
        this.charts = preProcessor.charts(beam, middle);
        tracer.startTask(leaves, counters);
    }

    /** About the power, in W, that the beam brings to diffuse surfaces, from the middle of its light. */
    double power(long rays) {
        int side = (int) Math.max(4, Math.min(SIDE, Math.sqrt(rays * SHARE)));
        double sum = 0;
        for (EmissionChart chart : charts) {
            leaves.clear();
            for (int i = 0; i < side * side; i++) {
                int row = i / side;
                int column = i % side;
                chart.aim((column + 0.5) / side, (row + 0.5) / side, ray);
                int number = tracer.trace(beam, middle, ray, 1);
                sum += ray.measure * leaves.booked(number, LeafTracer.STORED);
            }
        }
        return sum / (side * side);
    }

    /**
     * How many cells are mixed on each level, for one base cell: those of the base, their quarters, and so on.
     *
     * @param baseCells of all charts together
     */
    double[] mixed(double baseCells, int levels, double rays, SampleStream random) {
        double area = 0;
        for (EmissionChart chart : charts) {
            area += chart.width() * chart.height();
        }
        double step = Math.sqrt(area / baseCells);
        double samples = Math.max(16, Math.min(CELLS, rays * SHARE / 8));
        double[] mixed = new double[levels];
        int looked = 0;
        for (EmissionChart chart : charts) {
            double part = chart.width() * chart.height() / area;
            for (int i = 0; i < Math.ceil(samples * part); i++) {
                double width = Math.min(1, step / chart.width());
                double height = Math.min(1, step / chart.height());
                leaves.clear();
                look(
                        chart,
                        random.nextDouble() * (1 - width),
                        random.nextDouble() * (1 - height),
                        width,
                        height,
                        mixed);
                looked++;
            }
        }
        for (int i = 0; i < levels; i++) {
            mixed[i] /= looked;
        }
        return mixed;
    }

    /** The part of the power whose cells would be points after so many quarterings. */
    double tornPart(double baseCells, int levels, double rays, SampleStream random) {
        tornPower = 0;
        allPower = 0;
        mixed(baseCells, levels, rays, random);
        return allPower > 0 ? tornPower / allPower : 0;
    }

    /** Adds up what power in a cell comes from all of its corners, and what does not. */
    private void weigh(int p, int q, int r, int s, double measure) {
        int[] corners = {p, q, r, s};
        for (int corner : corners) {
            for (int leaf = leaves.firstLeaf(corner); leaf < leaves.endLeaf(corner); leaf++) {
                power.set(0, 0, 0);
                leaves.addPower(leaf, measure, power);
                allPower += power.sum();
                boolean isShared = leaves.alike(leaf, p) >= 0
                        && leaves.alike(leaf, q) >= 0
                        && leaves.alike(leaf, r) >= 0
                        && leaves.alike(leaf, s) >= 0;
                tornPower += isShared ? 0 : power.sum();
            }
        }
    }

    /** Counts a base cell if it is mixed, and follows one of its quarters, which stands for all, to the next level. */
    private void look(EmissionChart chart, double p, double q, double width, double height, double[] mixed) {
        SampleStream random = new SampleStream();
        random.start(Double.doubleToLongBits(p), Double.doubleToLongBits(q), 0);
        double left = p;
        double top = q;
        double size = 1;
        double stands = 1;
        for (int level = 0; level < mixed.length; level++) {
            double right = left + width * size;
            double bottom = top + height * size;
            int inside = trace(chart, 0.5 * (left + right), 0.5 * (top + bottom));
            int corner = trace(chart, left, top);
            int second = trace(chart, right, top);
            int third = trace(chart, right, bottom);
            int fourth = trace(chart, left, bottom);
            double worthwhile = MeshPatch.worthwhile(mixed.length - level);
            boolean agrees = leaves.agree(corner, second, third, fourth, inside, worthwhile);
            if (agrees || level == mixed.length - 1) {
                weigh(corner, second, third, fourth, size * size * stands * chart.density(left, top));
            }
            if (agrees) {
                return;
            }
            mixed[level] += stands;
            size /= 2;
            stands *= 4;
            left += random.nextDouble() < 0.5 ? 0 : width * size;
            top += random.nextDouble() < 0.5 ? 0 : height * size;
        }
    }

    private int trace(EmissionChart chart, double p, double q) {
        chart.aim(p, q, ray);
        return tracer.trace(beam, middle, ray, 1);
    }

    /** The beam that is looked into. */
    Beam beam() {
        return beam;
    }
}
