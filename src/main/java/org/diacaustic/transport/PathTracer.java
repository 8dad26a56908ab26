package org.diacaustic.transport;

import org.diacaustic.material.Material;
import org.diacaustic.material.Medium;
import org.diacaustic.material.Scattering;
import org.diacaustic.material.Surface;
import org.diacaustic.math.Ray;
import org.diacaustic.math.Rgb;
import org.diacaustic.parallel.StopSignal;
import org.diacaustic.scene.MediumStack;
import org.diacaustic.scene.SceneIndex;
import org.diacaustic.shape.Hit;

/**
 * Follows a ray through a scene and over every surface that mirrors or refracts it, with all the branches that gives:
 * what is common to light traced from the eye and from the lights. What a path finds is the business of the subclass. Owned
 * by one task, used again for every path; after its arrays have grown to the depth of the scene it allocates nothing.
 */
public abstract class PathTracer {
    /** More surfaces than this in one place are not told apart. */
    private static final int MOST_TOUCHING = 8;

    private static final int MIRRORED = 1;
    private static final int REFRACTED = 2;

    /** The ray to aim before {@link #followAll}; then the one that is being followed, shortened to where it ends. */
    protected final Ray ray = new Ray();

    /** Where the ray arrived. */
    protected Hit hit = new Hit();

    /** What the material is like there. */
    protected final Surface surface = new Surface();

    /** Where the light goes from there. */
    protected final Scattering scattering = new Scattering();

    /** The media on the side from which the ray arrived. */
    protected final MediumStack media;

    /** The fraction of what started that arrives. */
    protected final Rgb throughput = new Rgb();

    /** How often the path was mirrored or refracted so far. */
    protected int depth;

    /** How long the path is so far, in scene units. */
    protected double pathLength;

    /**
     * Which way the path came: a number that two paths share if they met the same smooth pieces of the same sides of the same
     * objects in the same order, and were mirrored and refracted alike; others share it with a chance of 2⁻⁶⁴.
     */
    protected long signature;

    private final SceneIndex scene;
    private final PathRules rules;
    private final PendingRays pending;
    private final Ray probe = new Ray();
    private final Rgb carried = new Rgb();
    private Hit touching = new Hit();
    private double back;
    private int passed;

    protected PathTracer(SceneIndex scene, PathRules rules) {
        this.scene = scene;
        this.rules = rules;
        this.pending = new PendingRays(scene);
        this.media = new MediumStack(scene);
    }

    /** Tests of a ray against a primitive or a bounding volume, made so far. */
    protected final long tests() {
        return ray.tests + probe.tests;
    }

    /** Follows the ray, which the caller has aimed, and all that comes of it, until the signal is set. */
    protected final void followAll(MediumStack mediaAtStart, StopSignal stop) {
        pending.clear();
        PendingRay first = pending.push();
        first.start(ray);
        first.throughput.set(1, 1, 1);
        first.media.copyFrom(mediaAtStart);
        while (!pending.isEmpty() && !stop.isSet()) {
            follow(pending.pop());
        }
    }

    /**
     * Is asked when the nearest surface on the ray is known: whether something that is no surface lies before it, and the
     * path ends there. May shorten the ray.
     */
    protected boolean endsBeforeSurface() {
        return false;
    }

    /** The path ended without a surface; {@link #throughput} is what arrives there. */
    protected abstract void end();

    /**
     * The path arrived at a surface, which is evaluated.
     *
     * @param side 1 if the ray came from where the outward normal points, −1 from behind
     * @return whether the path goes on from here
     */
    protected abstract boolean arrive(int object, int side);

    /**
     * The path went through a boundary that another medium's priority makes invisible: it does not turn, nor become weaker.
     * {@link #pathLength} is where.
     */
    protected void passes(int object) {}

    /** A medium is going to take its part of the {@link #throughput} over a length of the path, in scene units. */
    protected void absorbs(Medium medium, double length) {}

    /**
     * Is asked about every continuation that could be followed: whether it is. May change what it carries.
     *
     * @param path its {@link #signature}
     * @param fraction of what started that it carries
     * @param largest of its colours
     */
    protected boolean survives(long path, Rgb fraction, double largest) {
        return true;
    }

    /** A continuation that carries this fraction of what started is not followed. */
    protected abstract void cut(Rgb fraction);

    /** The path came to what is not a number, and ends. */
    protected abstract void spoiled();

    /** A mirrored or a refracted ray is going to be followed. */
    protected void goesOn(boolean refracted) {}

    private void follow(PendingRay next) {
        next.copyTo(ray);
        throughput.set(next.throughput);
        media.copyFrom(next.media);
        back = next.back;
        passed = next.passed;
        depth = next.depth;
        pathLength = next.pathLength;
        signature = next.signature;
        int object = scene.nearest(ray, next.object, next.primitive);
        boolean endsBefore = endsBeforeSurface();
        double length = Math.max(0, ray.tMax - back);
        pathLength += length;
        if (object != SceneIndex.NONE && !endsBefore) {
            meet(object, length);
        } else {
            absorb(media.current(), length);
            end();
        }
    }

    /** Takes what a medium absorbs on the way that the ray has come. */
    private void absorb(Medium medium, double length) {
        if (medium.absorbs()) {
            absorbs(medium, length);
            throughput.multiply(
                    Medium.transmittance(medium.absorption().red(), length),
                    Medium.transmittance(medium.absorption().green(), length),
                    Medium.transmittance(medium.absorption().blue(), length));
        }
    }

    private void meet(int found, double length) {
        hit.take(ray);
        scene.object(found).shape().complete(ray, hit);
        int object = leavesFirst(found) ? media.dominantObject() : found;
        int side = side(object);
        if (scene.isOpaque(object)) {
            absorb(media.current(), length);
            scatter(object, side, 1, 1);
            return;
        }
        boolean isTouching = hit.t <= 2 * ray.departureError;
        passed = isTouching ? passed : 0;
        if (isTouching && !media.canCross(object, side > 0)) {
            absorb(media.current(), length);
            // Between surfaces in one place a ray could go to and fro without getting on: then it leaves them all.
            goStraightOn(object, passed < MOST_TOUCHING ? 0 : -2 * ray.departureError);
            return;
        }
        media.lookAt(object, side > 0);
        absorb(media.near(), length);
        if (media.isVisible()) {
            scatter(object, side, media.near().indexOfRefraction(), media.far().indexOfRefraction());
        } else {
            passes(object);
            media.cross(object, side > 0);
            goStraightOn(object, hit.touchingDistance(alongNormal(hit)));
        }
    }

    private void scatter(int object, int side, double nNear, double nFar) {
        Material material = scene.object(object).material();
        if (material.needsMap()) {
            scene.object(object).shape().inverseMap(hit);
        }
        material.evaluate(hit, surface);
        scattering.evaluate(rules.scattering(), rules.mode(), ray, hit, surface, side, nNear, nFar);
        if (arrive(object, side)) {
            goOn(object, side);
        }
    }

    /**
     * Whether the ray is inside a closed object whose surface touches the one it has found, and so leaves that object
     * first: between surfaces that touch there is always a gap without width, whichever of them rounding puts in front.
     * If so, the hit becomes that on the object's own surface.
     */
    private boolean leavesFirst(int found) {
        int inside = media.dominantObject();
        boolean isLeaving = scene.object(found).shape().isClosed() && alongNormal(hit) > 0;
        if (inside == SceneIndex.NONE
                || inside == found
                || (isLeaving && !scene.isOpaque(found))
                || rules.asksListOnly()) {
            return false;
        }
        double reach = hit.touchingDistance(alongNormal(hit));
        probe.set(
                hit.x - reach * ray.directionX,
                hit.y - reach * ray.directionY,
                hit.z - reach * ray.directionZ,
                ray.directionX,
                ray.directionY,
                ray.directionZ);
        probe.tMax = 2 * reach;
        if (!scene.object(inside).shape().intersect(probe)) {
            return false;
        }
        touching.take(probe);
        scene.object(inside).shape().complete(probe, touching);
        if (!(alongNormal(touching) > 0)) {
            return false;
        }
        touching.t = hit.t;
        Hit outer = hit;
        hit = touching;
        touching = outer;
        return true;
    }

    /** The side that the ray arrives on; if it runs along the surface, it comes from where it is. */
    private int side(int object) {
        double along = alongNormal(hit);
        return along < 0 || (along == 0 && media.canCross(object, true)) ? 1 : -1;
    }

    private double alongNormal(Hit at) {
        return ray.directionX * at.normalX + ray.directionY * at.normalY + ray.directionZ * at.normalZ;
    }

    /**
     * Leaves the same ray for later, beyond a surface that means nothing to it. The error of its start stays as wide as
     * it was, so that what was passed just now is known for it.
     */
    private void goStraightOn(int object, double before) {
        PendingRay next = pending.push();
        next.leave(hit, object, ray.directionX, ray.directionY, ray.directionZ, before);
        next.pass(ray.departureError, passed);
        next.depth = depth;
        next.pathLength = pathLength;
        next.signature = signature;
        next.throughput.set(throughput);
        next.media.copyFrom(media);
    }

    /** Leaves the mirrored and the refracted ray for later, unless they carry too little. */
    private void goOn(int object, int side) {
        long path = signed(object, side, MIRRORED);
        if (carries(scattering.reflectance, scattering.reflectedX, rules.followsReflections(), path)) {
            goesOn(false);
            PendingRay mirrored = pending.push();
            mirrored.leave(hit, object, scattering.reflectedX, scattering.reflectedY, scattering.reflectedZ, 0);
            pass(mirrored, path);
        }
        path = signed(object, side, REFRACTED);
        if (carries(scattering.transmittance, scattering.transmittedX, true, path)) {
            goesOn(true);
            double x = scattering.transmittedX;
            double y = scattering.transmittedY;
            double z = scattering.transmittedZ;
            double cosine = x * hit.normalX + y * hit.normalY + z * hit.normalZ;
            PendingRay refracted = pending.push();
            // A little before the surface, so that what touches it on the other side is met.
            refracted.leave(hit, object, x, y, z, hit.touchingDistance(cosine));
            pass(refracted, path);
            refracted.media.cross(object, side > 0);
        }
    }

    private void pass(PendingRay next, long path) {
        next.depth = depth + 1;
        next.pathLength = pathLength;
        next.signature = path;
        next.throughput.set(carried);
        next.media.copyFrom(media);
    }

    /**
     * Sets what a continuation carries, and says whether it is followed. One that carries or points to what is not a
     * number ends here.
     */
    private boolean carries(Rgb fraction, double directionX, boolean isWanted, long path) {
        carried.set(throughput).multiply(fraction);
        double largest = carried.largest();
        if (Double.isNaN(largest) || (largest > 0 && Double.isNaN(directionX))) {
            spoiled();
            return false;
        }
        if (!(largest > 0)) {
            return false;
        }
        boolean isFollowed = isWanted && largest >= rules.minimumThroughput() && depth < rules.maxDepth();
        if (!isFollowed) {
            cut(carried);
        }
        return isFollowed && survives(path, carried, largest);
    }

    /** The signature of the path with its end on a side of an object. */
    protected final long signatureAt(int object, int side) {
        return mixed(signature, (long) object << 1 | (side > 0 ? 1 : 0));
    }

    private long signed(int object, int side, int event) {
        int piece = scene.object(object).shape().piece(hit);
        return mixed(signature, ((long) piece << 31 | object) << 3 | (side > 0 ? 4 : 0) | event);
    }

    private static long mixed(long path, long step) {
        long mixed = (path + step + 1) * 0x9E3779B97F4A7C15L;
        mixed = (mixed ^ mixed >>> 32) * 0xD6E8FEB86659FD93L;
        return mixed ^ mixed >>> 32;
    }
}
