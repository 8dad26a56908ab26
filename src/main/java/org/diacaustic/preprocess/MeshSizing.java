package org.diacaustic.preprocess;

import java.util.ArrayList;
import java.util.List;
import org.diacaustic.light.LightPoint;
import org.diacaustic.math.SampleStream;
import org.diacaustic.parallel.Workers;
import org.diacaustic.transport.PathRules;

/**
 * Deals out the rays of a mesh: to the beams by the light that they bring, to the points of a lamp, to base cells and to cutting
 * them where ways part. What that takes is found out by a few rays first.
 */
final class MeshSizing {
    /** Light that carries a smaller fraction of its ray's flux is not followed. */
    private static final double LEAST_THROUGHPUT = 0x1p-11;

    /** The rays of a cut triangle's edges, for one cell that is still mixed. */
    private static final double RAYS_A_CUT = 8.5;

    /** The new rays that quartering a cell needs, neighbours' rays shared. */
    private static final double RAYS_A_QUARTERING = 3.5;

    /** The rays of a base cell: a corner, and one inside. */
    private static final double RAYS_A_CELL = 2;

    /** The part of the rays that is for base cells. */
    private static final double BASE_SHARE = 0.5;

    private static final int LARGEST_DEPTH = 6;
    private static final int MOST_COLUMNS = 1 << 14;

    private final ForwardPlan plan;
    private final ForwardCounters counters;

    private MeshSizing(ForwardPlan plan, ForwardCounters counters) {
        this.plan = plan;
        this.counters = counters;
    }

    /** How paths are followed that make a mesh. */
    static PathRules rules(ForwardPlan plan) {
        PathRules given = plan.rules();
        return new PathRules(
                given.scattering(),
                given.mode(),
                given.maxDepth(),
                plan.rouletteThroughput() > 0 ? LEAST_THROUGHPUT : 0,
                given.followsReflections(),
                given.asksListOnly());
    }

    /** The lattices of all beams. */
    static List<MeshLattice> lattices(ForwardPlan plan, int pass, Workers workers, ForwardCounters counters) {
        return new MeshSizing(plan, counters).lattices(pass, workers);
    }

    private List<MeshLattice> lattices(int pass, Workers workers) {
        List<Beam> beams = plan.beams();
        MeshPilot[] pilots = new MeshPilot[beams.size()];
        int side = MeshPilot.side(plan.rays() / Math.max(1, beams.size()));
        ForwardCounters[] counts = new ForwardCounters[beams.size()];
        workers.run(beams.size(), () -> {
            LeafTracer tracer = new LeafTracer(plan, rules(plan), workers.stop());
            return i -> {
                counts[i] = new ForwardCounters();
                pilots[i] = MeshPilot.of(plan.preProcessor(), beams.get(i), tracer, side, counts[i]);
            };
        });
        if (workers.stop().isSet()) {
            return List.of();
        }
        double total = 0;
        for (int i = 0; i < pilots.length; i++) {
            counters.add(counts[i]);
            total += pilots[i].importance();
        }
        List<MeshLattice> all = new ArrayList<>();
        for (int i = 0; i < pilots.length; i++) {
            double rays = total > 0 ? plan.rays() * pilots[i].importance() / total : 0;
            SampleStream random = new SampleStream();
            random.start(plan.seed(), -1 - pass, i);
            addLattices(pilots[i], rays, random, all);
        }
        return all;
    }

    private void addLattices(MeshPilot pilot, double rays, SampleStream random, List<MeshLattice> all) {
        if (pilot.importance() == 0) {
            return;
        }
        Beam beam = pilot.beam();
        LightPoints points = new LightPoints(lightPoints(beam, rays), random);
        double perPoint = rays / points.count();
        while (points.next()) {
            LightPoint from = new LightPoint();
            beam.light().emitFrom(points.s(), points.t(), from);
            List<EmissionChart> charts = plan.preProcessor().charts(beam, from);
            double area = 0;
            for (EmissionChart chart : charts) {
                area += chart.width() * chart.height();
            }
            Size size = size(pilot, perPoint);
            double step = Math.sqrt(area / size.baseCells);
            for (EmissionChart chart : charts) {
                all.add(new MeshLattice(
                        beam,
                        from,
                        chart,
                        even(chart.width() / step),
                        even(chart.height() / step),
                        size.depth,
                        size.cuts,
                        1.0 / points.count()));
            }
        }
    }

    private static int even(double count) {
        return 2 * (int) Math.max(1, Math.min(MOST_COLUMNS / 2, Math.rint(0.5 * count)));
    }

    /** So many that the cells of a point, and the points of a lamp, are about equally far apart where they land. */
    private static int lightPoints(Beam beam, double rays) {
        return beam.pointCount() == 1 ? 1 : (int) Math.max(4, Math.min(1 << 16, Math.rint(Math.sqrt(rays) / 4)));
    }

    /** How many base cells are to be made of so many rays, and how they are cut. */
    private Size size(MeshPilot pilot, double rays) {
        double baseCells = Math.max(4, rays * BASE_SHARE / RAYS_A_CELL);
        double mixed = pilot.mixedAt(baseCells);
        double left = rays * (1 - BASE_SHARE);
        int depth = 0;
        while (depth < LARGEST_DEPTH && cutting(pilot, mixed, depth + 1) <= left) {
            depth++;
        }
        boolean cuts = cutting(pilot, mixed, depth) <= 2 * left;
        double needed = baseCells * RAYS_A_CELL + (cuts ? cutting(pilot, mixed, depth) : 0);
        return new Size(Math.max(4, baseCells * rays / needed), depth, cuts);
    }

    /** The rays for quartering so many mixed cells so often, and cutting what is left. */
    private static double cutting(MeshPilot pilot, double mixed, int depth) {
        double rays = 0;
        double cells = mixed;
        for (int i = 0; i < depth; i++) {
            rays += RAYS_A_QUARTERING * cells;
            cells *= pilot.growth();
        }
        return rays + RAYS_A_CUT * cells;
    }

    private record Size(double baseCells, int depth, boolean cuts) {}
}
