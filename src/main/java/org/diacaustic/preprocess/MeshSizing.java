package org.diacaustic.preprocess;

import java.util.ArrayList;
import java.util.List;
import org.diacaustic.light.LightPoint;
import org.diacaustic.math.SampleStream;
import org.diacaustic.parallel.Workers;

/**
 * Deals out the rays of a mesh: to the beams by the light that they bring, to the points of a lamp, to base cells and to
 * quartering them where ways part. What that takes is found out by a few rays first.
 */
final class MeshSizing {
    /** The new rays that quartering a cell needs, neighbours' rays shared. */
    private static final double RAYS_A_QUARTERING = 3.5;

    /** The rays of a base cell: a corner, and one inside. */
    private static final double RAYS_A_CELL = 2;

    /** The part of the rays that is for base cells, if the others find a use. */
    private static final double BASE_SHARE = 0.45;

    /** Soft light has no sharp edges that would need as many rays. */
    private static final double SOFT_IMPORTANCE = 1.0 / 8;

    private static final int LARGEST_DEPTH = 10;
    private static final int MOST_COLUMNS = 1 << 14;

    private final ForwardPlan plan;
    private final int pass;

    MeshSizing(ForwardPlan plan, int pass) {
        this.plan = plan;
        this.pass = pass;
    }

    /**
     * The lattices of all beams; none if the workers were stopped.
     *
     * @param counters to which the rays sent in advance are added
     */
    List<MeshLattice> lattices(Workers workers, ForwardCounters counters) {
        List<Beam> beams = plan.beams();
        double[] importance = new double[beams.size()];
        overBeams(
                workers,
                counters,
                (i, pilot) -> importance[i] = importance(pilot.power(plan.rays() / beams.size()), beams.get(i)));
        double total = 0;
        for (double each : importance) {
            total += each;
        }
        if (!(total > 0)) {
            return List.of();
        }
        double raysByImportance = plan.rays() / total;
        List<List<MeshLattice>> parts = new ArrayList<>();
        beams.forEach(beam -> parts.add(List.of()));
        overBeams(workers, counters, (i, pilot) -> {
            if (importance[i] > 0) {
                parts.set(i, lattices(pilot, i, raysByImportance * importance[i]));
            }
        });
        return workers.stop().isSet()
                ? List.of()
                : parts.stream().flatMap(List::stream).toList();
    }

    private void overBeams(Workers workers, ForwardCounters counters, BeamTask task) {
        ForwardCounters[] counts = new ForwardCounters[plan.beams().size()];
        workers.run(counts.length, () -> {
            LeafTracer tracer = new LeafTracer(plan, workers.stop());
            return i -> {
                counts[i] = new ForwardCounters();
                task.run(i, new MeshPilot(plan.preProcessor(), plan.beams().get(i), tracer, counts[i]));
            };
        });
        for (ForwardCounters part : counts) {
            if (part != null) {
                counters.add(part);
            }
        }
    }

    /** By which the rays are dealt out: errors grow with the power and fall with the rays, and so their squares' sum is least. */
    private double importance(double power, Beam beam) {
        // In units that go along with the scene: a cube root turns other powers of two than those of 8 into other
        // digits.
        double landing = power * beam.typicalDepositFactor() / plan.powerUnit();
        double ofPoint = landing > 0 ? StrictMath.cbrt(landing * landing) : 0;
        return beam.pointCount() == 1 ? ofPoint : SOFT_IMPORTANCE * ofPoint;
    }

    private List<MeshLattice> lattices(MeshPilot pilot, int number, double rays) {
        Beam beam = pilot.beam();
        SampleStream random = new SampleStream();
        random.start(plan.seed(), -1 - pass, number);
        LightPoints points = new LightPoints(lightPoints(beam, rays), random);
        Size size = size(pilot, rays / points.count(), rays, random);
        List<MeshLattice> all = new ArrayList<>();
        while (points.next()) {
            LightPoint from = new LightPoint();
            beam.light().emitFrom(points.s(), points.t(), from);
            List<EmissionChart> charts = plan.preProcessor().charts(beam, from);
            double area = 0;
            for (EmissionChart chart : charts) {
                area += chart.width() * chart.height();
            }
            double step = Math.sqrt(area / size.baseCells);
            for (EmissionChart chart : charts) {
                int columns = even(chart.width() / step);
                int rows = even(chart.height() / step);
                all.add(new MeshLattice(
                        beam, from, chart, columns, rows, size.depth, 1.0 / points.count(), chart.meanDensity()));
            }
        }
        return all;
    }

    private static int even(double count) {
        return 2 * (int) Math.max(1, Math.min(MOST_COLUMNS / 2, Math.rint(0.5 * count)));
    }

    /** So many that the cells of a point, and the points of a lamp, are about equally far apart where they land. */
    private static int lightPoints(Beam beam, double rays) {
        return beam.pointCount() == 1 ? 1 : (int) Math.max(4, Math.min(1 << 16, Math.rint(Math.sqrt(rays) / 8)));
    }

    /**
     * How many base cells are to be made, and how they are quartered.
     *
     * @param rays for them
     * @param allRays of the beam
     */
    private Size size(MeshPilot pilot, double rays, double allRays, SampleStream random) {
        double baseCells = Math.max(4, rays * BASE_SHARE / RAYS_A_CELL);
        double[] mixed = pilot.mixed(baseCells, LARGEST_DEPTH, allRays, random);
        // A border that no sample has met may still run through the chart once; to be ready for it costs nothing.
        double supposed = Math.max(mixed[0], 1 / Math.sqrt(baseCells));
        double found = mixed[0];
        double raysSupposed = RAYS_A_CELL;
        double raysFound = RAYS_A_CELL;
        int depth = 0;
        while (depth < LARGEST_DEPTH && baseCells * (raysSupposed + RAYS_A_QUARTERING * supposed) <= rays) {
            raysSupposed += RAYS_A_QUARTERING * supposed;
            raysFound += RAYS_A_QUARTERING * found;
            depth++;
            // Along a border each level has at least twice as many mixed cells as that before.
            double sampled = depth < LARGEST_DEPTH ? mixed[depth] : 0;
            supposed = Math.max(sampled, 2 * supposed);
            found = Math.max(sampled, 2 * found);
        }
        return new Size(Math.max(4, rays / raysFound), depth);
    }

    private interface BeamTask {
        void run(int number, MeshPilot pilot);
    }

    private record Size(double baseCells, int depth) {}
}
