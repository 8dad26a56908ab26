package org.diacaustic.render;

import org.diacaustic.light.Light;
import org.diacaustic.material.Material;
import org.diacaustic.material.Medium;
import org.diacaustic.material.ScatterRules;
import org.diacaustic.material.Scattering;
import org.diacaustic.material.Surface;
import org.diacaustic.material.TransportMode;
import org.diacaustic.math.Ray;
import org.diacaustic.math.Rgb;
import org.diacaustic.math.SampleStream;
import org.diacaustic.parallel.StopSignal;
import org.diacaustic.scene.MediumStack;
import org.diacaustic.scene.SceneIndex;
import org.diacaustic.shape.Hit;

/**
 * Follows eye rays: I = A + Σ(D + S) + R + T at every hit [Thesis 1.3]. Owned by one task, used again for every ray;
 * after its arrays have grown to the depth of the scene it allocates nothing.
 */
final class EyeTracer {
    /** More surfaces than this in one place are not told apart. */
    private static final int MOST_TOUCHING = 8;

    private final RenderPlan plan;
    private final SceneIndex scene;
    private final ScatterRules rules;
    private final int maxDepth;
    private final double minimumThroughput;
    private final boolean looksAtListOnly;
    private final Light[] visibleLights;
    private final DirectLight directLight;
    private final PendingRays pending;
    private final Counters counters = new Counters();
    private final SampleStream random = new SampleStream();

    private final Ray ray = new Ray();
    private final Ray probe = new Ray();
    private Hit hit = new Hit();
    private Hit touching = new Hit();
    private final Surface surface = new Surface();
    private final Scattering scattering = new Scattering();
    private final MediumStack media;
    private int depth;
    private double back;
    private int passed;
    private final Rgb throughput = new Rgb();
    private final Rgb carried = new Rgb();
    private final Rgb glow = new Rgb();
    private final Rgb radiance = new Rgb();

    EyeTracer(RenderPlan plan) {
        this.plan = plan;
        this.scene = plan.index();
        this.rules = plan.settings().scatterRules();
        this.maxDepth = plan.settings().maxDepth();
        this.minimumThroughput = plan.settings().minimumThroughput();
        this.looksAtListOnly = plan.settings().usesListOrder();
        this.visibleLights = plan.visibleLights();
        this.pending = new PendingRays(scene);
        this.media = new MediumStack(scene);
        this.directLight = new DirectLight(plan, counters, random);
    }

    /** The ray to aim before {@link #trace}. */
    Ray ray() {
        return ray;
    }

    /** The random numbers of the sample; started by the caller. */
    SampleStream random() {
        return random;
    }

    /** Forgets what the last task taught about blockers, so that counters do not depend on the order of tasks. */
    void startTask() {
        directLight.startTask();
    }

    /** What was counted since the tracer was made. */
    Counters counters() {
        counters.intersectionTests = ray.tests + probe.tests + directLight.tests();
        return counters;
    }

    /**
     * The radiance that arrives along the aimed ray, valid until the next call; only a part of it if the signal is set
     * meanwhile, for between mirrors a ray may go on for long.
     */
    Rgb trace(StopSignal stop) {
        counters.eyeRays++;
        radiance.set(0, 0, 0);
        pending.clear();
        PendingRay first = pending.push();
        first.start(ray);
        first.throughput.set(1, 1, 1);
        first.media.copyFrom(plan.mediaAtEye());
        while (!pending.isEmpty() && !stop.isSet()) {
            follow(pending.pop());
        }
        return radiance;
    }

    private void follow(PendingRay next) {
        next.copyTo(ray);
        throughput.set(next.throughput);
        media.copyFrom(next.media);
        back = next.back;
        passed = next.passed;
        depth = next.depth;
        int object = scene.nearest(ray, next.object, next.primitive);
        boolean seesLight = seesLight();
        if (object != SceneIndex.NONE && !seesLight) {
            arrive(object);
            return;
        }
        absorb(media.current());
        if (!seesLight) {
            glow.set(plan.scene().background());
        }
        radiance.addProduct(throughput, glow);
    }

    /** Whether a light that can be seen lies before everything else; sets its radiance. */
    private boolean seesLight() {
        boolean seen = false;
        ray.leaving = Ray.FREE;
        for (Light light : visibleLights) {
            seen |= light.emitsAlong(ray, glow);
        }
        return seen;
    }

    /** Takes what a medium absorbs on the way that the ray has come. */
    private void absorb(Medium medium) {
        if (medium.absorbs()) {
            double distance = Math.max(0, ray.tMax - back);
            throughput.multiply(
                    Medium.transmittance(medium.absorption().red(), distance),
                    Medium.transmittance(medium.absorption().green(), distance),
                    Medium.transmittance(medium.absorption().blue(), distance));
        }
    }

    private void arrive(int found) {
        hit.take(ray);
        scene.object(found).shape().complete(ray, hit);
        int object = leavesFirst(found) ? media.dominantObject() : found;
        int side = alongNormal(hit) < 0 ? 1 : -1;
        if (scene.isOpaque(object)) {
            absorb(media.current());
            shade(object, side, 1, 1);
            return;
        }
        boolean isTouching = hit.t <= 2 * ray.departureError;
        passed = isTouching ? passed : 0;
        if (isTouching && !media.canCross(object, side > 0)) {
            absorb(media.current());
            // Between surfaces in one place a ray could go to and fro without getting on: then it leaves them all.
            goStraightOn(object, passed < MOST_TOUCHING ? 0 : -2 * ray.departureError);
            return;
        }
        media.lookAt(object, side > 0);
        absorb(media.near());
        if (media.isVisible()) {
            shade(object, side, media.near().indexOfRefraction(), media.far().indexOfRefraction());
        } else {
            media.cross(object, side > 0);
            goStraightOn(object, hit.touchingDistance(alongNormal(hit)));
        }
    }

    /** Adds A and Σ(D + S) of the hit, and leaves R and T for later. */
    private void shade(int object, int side, double nNear, double nFar) {
        Material material = scene.object(object).material();
        if (material.needsMap()) {
            scene.object(object).shape().inverseMap(hit);
        }
        material.evaluate(hit, surface);
        scattering.evaluate(rules, TransportMode.RADIANCE, ray, hit, surface, side, nNear, nFar);
        addAmbient();
        directLight.add(object, side, hit, surface, scattering, media, throughput, radiance);
        goOn(object, side);
    }

    /**
     * Whether the ray is inside a closed object whose surface touches the one it has found, and so leaves that object
     * first: between surfaces that touch there is always a gap without width, whichever of them rounding puts in front.
     * If so, the hit becomes that on the object's own surface.
     */
    private boolean leavesFirst(int found) {
        int inside = media.dominantObject();
        boolean isLeaving = scene.object(found).shape().isClosed() && alongNormal(hit) > 0;
        if (inside == SceneIndex.NONE || inside == found || (isLeaving && !scene.isOpaque(found)) || looksAtListOnly) {
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
        next.throughput.set(throughput);
        next.media.copyFrom(media);
    }

    private void addAmbient() {
        double share = plan.diffuseFactor();
        radiance.add(
                throughput.red * surface.diffuse.red * surface.ambient.red * share,
                throughput.green * surface.diffuse.green * surface.ambient.green * share,
                throughput.blue * surface.diffuse.blue * surface.ambient.blue * share);
    }

    /** Leaves the mirrored and the refracted ray for later, unless they carry too little. */
    private void goOn(int object, int side) {
        if (carries(scattering.reflectance, scattering.reflectedX)) {
            counters.reflectionRays++;
            PendingRay mirrored = pending.push();
            mirrored.leave(hit, object, scattering.reflectedX, scattering.reflectedY, scattering.reflectedZ, 0);
            mirrored.depth = depth + 1;
            mirrored.throughput.set(carried);
            mirrored.media.copyFrom(media);
        }
        if (carries(scattering.transmittance, scattering.transmittedX)) {
            counters.refractionRays++;
            double x = scattering.transmittedX;
            double y = scattering.transmittedY;
            double z = scattering.transmittedZ;
            double cosine = x * hit.normalX + y * hit.normalY + z * hit.normalZ;
            PendingRay refracted = pending.push();
            // A little before the surface, so that what touches it on the other side is met.
            refracted.leave(hit, object, x, y, z, hit.touchingDistance(cosine));
            refracted.depth = depth + 1;
            refracted.throughput.set(carried);
            refracted.media.copyFrom(media);
            refracted.media.cross(object, side > 0);
        }
    }

    /**
     * Sets what a continuation carries, and says whether it is worth following. One that carries or points to what is
     * not a number ends here and spoils the sample, so that it is counted.
     */
    private boolean carries(Rgb fraction, double directionX) {
        carried.set(throughput).multiply(fraction);
        double largest = carried.largest();
        if (Double.isNaN(largest) || (largest > 0 && Double.isNaN(directionX))) {
            radiance.set(Double.NaN, Double.NaN, Double.NaN);
            return false;
        }
        boolean isFollowed = largest >= minimumThroughput && depth < maxDepth;
        if (largest > 0 && !isFollowed) {
            counters.cutRays++;
        }
        return largest > 0 && isFollowed;
    }
}
