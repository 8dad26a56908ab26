package org.diacaustic.preprocess;

import org.diacaustic.material.Medium;
import org.diacaustic.math.Ray;
import org.diacaustic.math.Rgb;
import org.diacaustic.parallel.StopSignal;
import org.diacaustic.scene.SceneIndex;
import org.diacaustic.transport.PathRules;
import org.diacaustic.transport.PathTracer;

/**
 * Follows light rays from a light, over what mirrors and refracts them. What they light before that is direct light, which is
 * not the forward pass' business [Thesis 4.1]. A ray counts only if it belongs to the window that it was sent into, so that
 * windows which overlap send nothing twice.
 */
abstract class LightPathTracer extends PathTracer {
    private final SceneIndex index;
    private final StopSignal stop;
    private final Ray upstream = new Ray();
    private Beam beam;
    private LightRay primary;

    /** What media took of the ray before its first surface. */
    private final Rgb takenBefore = new Rgb();

    private final Rgb taken = new Rgb();

    /** The first object whose invisible boundary the ray passed before it was mirrored or refracted, or none. */
    private int passedFirst;

    /** Whether it passed that where it was aimed. */
    private boolean isPassedOnTarget;

    LightPathTracer(SceneIndex index, PathRules rules, StopSignal stop) {
        super(index, rules);
        this.index = index;
        this.stop = stop;
    }

    /** Whether rays come to nothing from now on. */
    final boolean isStopped() {
        return stop.isSet();
    }

    /** The beam of the ray that is being followed. */
    final Beam beam() {
        return beam;
    }

    /** Follows a ray and all that comes of it. */
    final void follow(Beam from, LightRay aimed) {
        beam = from;
        primary = aimed;
        passedFirst = SceneIndex.NONE;
        takenBefore.set(0, 0, 0);
        if (comesThroughEndless()) {
            return;
        }
        ray.set(
                primary.originX,
                primary.originY,
                primary.originZ,
                primary.directionX,
                primary.directionY,
                primary.directionZ);
        followAll(beam.mediaAtLight(), stop);
    }

    /** Whether parallel rays, which come from beyond all bounds, meet something without bounds before they start. */
    private boolean comesThroughEndless() {
        for (int object : beam.endlessObjects()) {
            upstream.set(
                    primary.originX,
                    primary.originY,
                    primary.originZ,
                    -primary.directionX,
                    -primary.directionY,
                    -primary.directionZ);
            if (index.object(object).shape().occludes(upstream)) {
                return true;
            }
        }
        return false;
    }

    /**
     * The ray that counts has met its first surface, or, if there is none, nothing at all.
     *
     * @param lost the fractions of its flux that media took on the way there
     */
    protected abstract void starts(Rgb lost);

    /** It met a surface that neither mirrors nor refracts first, which is lit directly. */
    protected abstract void staysDirect();

    /**
     * It met its first mirroring or refracting surface.
     *
     * @return whether it goes on from there
     */
    protected abstract boolean enters(int object);

    /** It met a surface after being mirrored or refracted. */
    protected abstract void lands(int object, int side);

    /** Media took these fractions of the ray's flux on the way between surfaces. */
    protected void takes(Rgb lost) {}

    /** What was met was met; called before anything else is said of it. */
    protected void meets() {}

    /** What of the path does not land here goes on, or is lost. */
    protected abstract void keepsRest();

    /** The path leaves the scene. */
    protected abstract void escapes();

    /** Before the first surface it is not known whether the ray counts: {@link #starts} makes up for it. */
    @Override
    protected final void absorbs(Medium medium, double length) {
        taken.set(throughput)
                .multiply(
                        Medium.absorbed(medium.absorption().red(), length),
                        Medium.absorbed(medium.absorption().green(), length),
                        Medium.absorbed(medium.absorption().blue(), length));
        if (depth > 0) {
            takes(taken);
        } else {
            takenBefore.add(taken);
        }
    }

    @Override
    protected final boolean arrive(int object, int side) {
        meets();
        if (depth > 0) {
            lands(object, side);
            return true;
        }
        boolean isFirst = passedFirst == SceneIndex.NONE;
        if (isFirst ? !isOnTarget(object) : !isPassedOnTarget) {
            // Another ray sends this light: the one at what is met first.
            return false;
        }
        if (isFirst && !isSpecular()) {
            starts(takenBefore);
            staysDirect();
            return false;
        }
        if (!beam.window().owns(isFirst ? object : passedFirst)) {
            // The window of that object sends this light.
            return false;
        }
        starts(takenBefore);
        if (!enters(object)) {
            return false;
        }
        if (isFirst) {
            keepsRest();
        } else {
            lands(object, side);
        }
        return true;
    }

    /** Shadow rays end at boundaries that light does not see: who meets one first sends what goes through it. */
    @Override
    protected final void passes(int object) {
        if (depth == 0 && passedFirst == SceneIndex.NONE) {
            passedFirst = object;
            isPassedOnTarget = isOnTarget(object);
        }
    }

    private boolean isOnTarget(int object) {
        return primary.targetObject == SceneIndex.NONE
                || (primary.targetObject == object
                        && Math.abs(pathLength - primary.targetDistance) <= primary.targetError);
    }

    private boolean isSpecular() {
        return !scattering.reflectance.isBlack()
                || !scattering.transmittance.isBlack()
                || !surface.transparency.isBlack();
    }

    @Override
    protected final void end() {
        if (depth == 0) {
            if (primary.targetObject != SceneIndex.NONE) {
                // It went by the very edge of what it was aimed at: by rounding only.
                return;
            }
            starts(takenBefore);
        }
        escapes();
    }
}
