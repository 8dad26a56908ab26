package org.diacaustic.preprocess;

import org.diacaustic.math.SampleStream;
import org.diacaustic.parallel.StopSignal;

/**
 * Whether a caustic mesh suits a scene: how much of the light is torn apart so finely that its cells would be points, which
 * photons do as well.
 */
public final class MeshProspect {
    /** More of the light than this in points, and there is nothing that cells could bring. */
    private static final double MOST_TORN = 1.0 / 3;

    /** How often cells are quartered before light counts as torn. */
    private static final int LEVELS = 3;

    private MeshProspect() {}

    /** The part of the power that would come as points, about: 0 to 1. */
    public static double tornPart(ForwardPlan plan) {
        StopSignal never = new StopSignal();
        ForwardCounters counters = new ForwardCounters();
        LeafTracer tracer = new LeafTracer(plan, never);
        double torn = 0;
        double total = 0;
        SampleStream random = new SampleStream();
        for (Beam beam : plan.beams()) {
            random.start(plan.seed(), beam.number(), 0);
            MeshPilot pilot = new MeshPilot(plan.preProcessor(), beam, tracer, counters);
            double power = pilot.power(beam.rays());
            if (power > 0) {
                torn += power * pilot.tornPart(beam.rays() / 4.0, LEVELS, beam.rays(), random);
                total += power;
            }
        }
        return total > 0 ? torn / total : 0;
    }

    /** Whether so much is torn that photons are the better choice. */
    public static boolean isTorn(double tornPart) {
        return tornPart > MOST_TORN;
    }
}
