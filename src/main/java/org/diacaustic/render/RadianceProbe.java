package org.diacaustic.render;

import org.diacaustic.math.Color;
import org.diacaustic.math.Vector3;
import org.diacaustic.parallel.StopSignal;
import org.diacaustic.scene.Camera;

/**
 * Asks for the radiance that arrives at the eye along single rays: what the samples of a picture ask, before it is rounded to the
 * picture's single precision. What a map of light brings is left out. Owned by one task.
 */
public final class RadianceProbe {
    private final Camera camera;
    private final EyeTracer tracer;
    private final StopSignal never = new StopSignal();

    /** @param plan of the scene; the rays start where its camera is */
    public RadianceProbe(RenderPlan plan) {
        this.camera = plan.scene().camera();
        this.tracer = new EyeTracer(plan, Illumination.NONE);
    }

    /**
     * The radiance in W·m⁻²·sr⁻¹.
     *
     * @param direction in which the eye looks, of any length but 0
     * @param number of the random choices of light samples: rays with different numbers are independent
     */
    public Color along(Vector3 direction, long number) {
        tracer.startPixel(0, number);
        tracer.ray().set(camera.from(), direction.normalized());
        return tracer.trace(never).toColor();
    }

    /**
     * The same through a point of the picture, and the middle of the lens.
     *
     * @param x from 0 at the left edge of the picture to its width at the right
     * @param y from 0 at the top edge to its height at the bottom
     */
    public Color through(double x, double y) {
        tracer.startPixel(0, 0);
        camera.aim(x, y, 0, 0, tracer.ray());
        return tracer.trace(never).toColor();
    }

    /** What was counted for all rays so far. */
    public Counters counters() {
        return tracer.counters();
    }
}
