package org.diacaustic.preprocess;

import org.diacaustic.light.LightPoint;
import org.diacaustic.math.SampleStream;

/**
 * What one task of a pre-processor sends rays with. Owned by one task:
 *
 * <pre>{@code
 * chart.aim(p, q, emitter.ray());
 * emitter.shoot(1.0 / rays);
 * }</pre>
 */
public final class LightEmitter {
    private final LightTracer tracer;
    private final Beam beam;
    private final long streams;
    private final LightRay ray = new LightRay();
    private final LightPoint point = new LightPoint();
    private final SampleStream random = new SampleStream();

    LightEmitter(LightTracer tracer, Beam beam, long streams) {
        this.tracer = tracer;
        this.beam = beam;
        this.streams = streams;
    }

    /** Random numbers that belong to a number, of a ray say: the same whichever task asks. */
    public SampleStream random(long number) {
        random.start(tracer.plan().seed(), streams, number);
        return random;
    }

    /** The ray to aim before {@link #shoot}. */
    public LightRay ray() {
        return ray;
    }

    /** Chooses a point of the light; valid until the next call. */
    public LightPoint point(double s, double t) {
        beam.light().emitFrom(s, t, point);
        return point;
    }

    /**
     * Sends the ray out with the flux of its part of light space, and stores where that lands after being mirrored or
     * refracted. The point of {@link #point} must be the one that the ray was aimed from.
     *
     * @param share the part of {@link LightRay#measure} that the ray stands for
     * @return the number of photons stored
     */
    public int shoot(double share) {
        return tracer.shoot(beam, point, ray, share, true);
    }

    /** Whether the pass is to end, and rays come to nothing from now on: who sends very many in one task asks for it. */
    public boolean isStopped() {
        return tracer.isStopped();
    }

    /** As {@link #shoot}, but only looks: nothing is stored, and the ray does not count as light sent out. */
    public int probe() {
        return tracer.shoot(beam, point, ray, 1, false);
    }
}
