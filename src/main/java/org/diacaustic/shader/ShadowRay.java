package org.diacaustic.shader;

import java.util.Arrays;
import org.diacaustic.light.LightSample;
import org.diacaustic.math.Dielectric;
import org.diacaustic.math.Ray;
import org.diacaustic.scene.MediumStack;
import org.diacaustic.scene.SceneIndex;
import org.diacaustic.shape.Hit;

/**
 * The straight line from a lit point to a light, with what a shading model needs to follow it. Mutable, owned by one
 * task.
 *
 * <p>It starts at the lit point, because there it is known exactly which primitive must be left out; shading models
 * that care put what it crosses into the order in which the light meets it.
 */
public final class ShadowRay {
    private static final int NO_BLOCKER = SceneIndex.NONE;

    final SceneIndex scene;
    final Ray ray = new Ray();
    final MediumStack media;
    final AnyBlocker anyBlocker = new AnyBlocker(this);
    final Dielectric dielectric = new Dielectric();
    final CrossingCollector collector = new CrossingCollector(this);

    private int fromObject;
    private int fromPrimitive;
    private double touchingDistance;
    private int light;
    private final int[] lastBlocker;
    private final boolean remembersBlockers;

    /**
     * @param lights how many lights the scene has
     * @param remembersBlockers whether the object that last stopped a light's ray is asked first [Thesis 3.2.1]
     */
    public ShadowRay(SceneIndex scene, int lights, boolean remembersBlockers) {
        this.scene = scene;
        this.media = new MediumStack(scene);
        this.lastBlocker = new int[lights];
        this.remembersBlockers = remembersBlockers;
        forgetBlockers();
    }

    /** Forgets which objects stopped light last: at the start of each task, so that counters depend on nothing else. */
    public void forgetBlockers() {
        Arrays.fill(lastBlocker, NO_BLOCKER);
    }

    /**
     * Aims from a hit at a light.
     *
     * @param around the media on the lit side of the hit
     */
    public void aim(int lightNumber, Hit from, int object, LightSample sample, MediumStack around) {
        light = lightNumber;
        fromObject = object;
        fromPrimitive = from.primitive;
        ray.set(from.x, from.y, from.z, sample.directionX, sample.directionY, sample.directionZ);
        ray.tMax = sample.distance;
        ray.departureError = from.pointError;
        touchingDistance = from.touchingDistance(
                sample.directionX * from.normalX + sample.directionY * from.normalY + sample.directionZ * from.normalZ);
        media.copyFrom(around);
    }

    /** The objects that may lie on the line. */
    public SceneIndex scene() {
        return scene;
    }

    /** The line itself: from the lit point in unit steps to the light at {@code tMax}, which may be infinite. */
    public Ray ray() {
        return ray;
    }

    /** The media at the lit point; a shading model may change them as it follows the line. */
    public MediumStack media() {
        return media;
    }

    /** How far before the lit point, along the line, transparent surfaces may be that touch the lit one. */
    double touchingDistance() {
        return touchingDistance;
    }

    /** The tests made so far. */
    public long tests() {
        return ray.tests + collector.tests();
    }

    /** Lets the visitor look at everything that may lie on the line; returns whether it stopped. */
    public boolean visit(SceneIndex.Visitor visitor) {
        return scene.visit(ray, fromObject, fromPrimitive, visitor);
    }

    /** Asks the object that was last remembered to stop this light, if there is one. */
    public boolean isStoppedByLastBlocker() {
        int blocker = lastBlocker[light];
        if (!remembersBlockers || blocker == NO_BLOCKER) {
            return false;
        }
        ray.leaving = blocker == fromObject ? fromPrimitive : Ray.FREE;
        double length = ray.tMax;
        boolean stopped = scene.object(blocker).shape().occludes(ray);
        ray.tMax = length;
        return stopped;
    }

    /** Notes the object that stopped the light, so that it is asked first for the next point. */
    public void remember(int blocker) {
        lastBlocker[light] = blocker;
    }
}
