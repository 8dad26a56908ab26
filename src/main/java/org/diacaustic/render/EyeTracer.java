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
import org.diacaustic.scene.MediumStack;
import org.diacaustic.scene.SceneIndex;
import org.diacaustic.shape.Hit;
import org.diacaustic.shape.Shape;

/**
 * Follows eye rays: I = A + Σ(D + S) + R + T at every hit [Thesis 1.3]. Owned by one task, used again for every ray;
 * after its arrays have grown to the depth of the scene it allocates nothing.
 */
final class EyeTracer {
    private final RenderPlan plan;
    private final SceneIndex scene;
    private final ScatterRules rules;
    private final int maxDepth;
    private final double minimumThroughput;
    private final Light[] visibleLights;
    private final DirectLight directLight;
    private final PendingRays pending;
    private final Counters counters = new Counters();
    private final SampleStream random = new SampleStream();

    private final Ray ray = new Ray();
    private final Hit hit = new Hit();
    private final Surface surface = new Surface();
    private final Scattering scattering = new Scattering();
    private final MediumStack media;
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
        counters.intersectionTests = ray.tests + directLight.tests();
        return counters;
    }

    /**
     * The radiance that arrives along the aimed ray, valid until the next call; only a part of it if the signal is set
     * meanwhile, for between mirrors a ray may go on for long.
     */
    Rgb trace(StopSignal stop) {
        counters.eyeRays++;
        radiance.set(0, 0, 0);
        carried.set(1, 1, 1);
        pending.clear();
        push(
                        ray.originX,
                        ray.originY,
                        ray.originZ,
                        ray.directionX,
                        ray.directionY,
                        ray.directionZ,
                        0,
                        SceneIndex.NONE,
                        0,
                        0)
                .copyFrom(plan.mediaAtEye());
        while (!pending.isEmpty() && !stop.isSet()) {
            pending.pop(ray, throughput, media);
            follow(pending.depth(), pending.object(), pending.primitive());
        }
        return radiance;
    }

    private void follow(int depth, int fromObject, int fromPrimitive) {
        int object = scene.nearest(ray, fromObject, fromPrimitive);
        boolean seesLight = seesLight();
        if (object != SceneIndex.NONE && !seesLight) {
            arrive(object, depth);
            return;
        }
        absorb(media.current(), ray.tMax);
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

    private void absorb(Medium medium, double distance) {
        if (medium.absorbs()) {
            throughput.multiply(
                    Medium.transmittance(medium.absorption().red(), distance),
                    Medium.transmittance(medium.absorption().green(), distance),
                    Medium.transmittance(medium.absorption().blue(), distance));
        }
    }

    private void arrive(int object, int depth) {
        Shape shape = scene.object(object).shape();
        hit.take(ray);
        shape.complete(ray, hit);
        double along = ray.directionX * hit.normalX + ray.directionY * hit.normalY + ray.directionZ * hit.normalZ;
        int side = along < 0 ? 1 : -1;
        boolean opaque = scene.isOpaque(object);
        if (opaque) {
            absorb(media.current(), ray.tMax);
        } else {
            media.lookAt(object, side > 0);
            absorb(media.near(), ray.tMax);
            if (!media.isVisible()) {
                media.cross(object, side > 0);
                carried.set(throughput);
                push(
                                hit.x,
                                hit.y,
                                hit.z,
                                ray.directionX,
                                ray.directionY,
                                ray.directionZ,
                                depth,
                                object,
                                hit.primitive,
                                hit.pointError)
                        .copyFrom(media);
                return;
            }
        }
        Material material = scene.object(object).material();
        if (material.needsMap()) {
            shape.inverseMap(hit);
        }
        material.evaluate(hit, surface);
        scattering.evaluate(
                rules,
                TransportMode.RADIANCE,
                ray,
                hit,
                surface,
                side,
                opaque ? 1 : media.near().indexOfRefraction(),
                opaque ? 1 : media.far().indexOfRefraction());
        addAmbient();
        directLight.add(object, side, hit, surface, scattering, media, throughput, radiance);
        if (depth < maxDepth) {
            goOn(object, side, depth, hit.pointError);
        }
    }

    private void addAmbient() {
        double share = plan.diffuseFactor();
        radiance.add(
                throughput.red * surface.diffuse.red * surface.ambient.red * share,
                throughput.green * surface.diffuse.green * surface.ambient.green * share,
                throughput.blue * surface.diffuse.blue * surface.ambient.blue * share);
    }

    /** Leaves the mirrored and the refracted ray for later, unless they carry too little. */
    private void goOn(int object, int side, int depth, double error) {
        if (carries(scattering.reflectance, scattering.reflectedX)) {
            counters.reflectionRays++;
            push(
                            hit.x,
                            hit.y,
                            hit.z,
                            scattering.reflectedX,
                            scattering.reflectedY,
                            scattering.reflectedZ,
                            depth + 1,
                            object,
                            hit.primitive,
                            error)
                    .copyFrom(media);
        }
        if (carries(scattering.transmittance, scattering.transmittedX)) {
            counters.refractionRays++;
            MediumStack beyond = push(
                    hit.x,
                    hit.y,
                    hit.z,
                    scattering.transmittedX,
                    scattering.transmittedY,
                    scattering.transmittedZ,
                    depth + 1,
                    object,
                    hit.primitive,
                    error);
            beyond.copyFrom(media);
            beyond.cross(object, side > 0);
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
        return largest > 0 && largest >= minimumThroughput;
    }

    private MediumStack push(
            double ox,
            double oy,
            double oz,
            double dx,
            double dy,
            double dz,
            int depth,
            int fromObject,
            int fromPrimitive,
            double error) {
        return pending.push(ox, oy, oz, dx, dy, dz, carried, depth, fromObject, fromPrimitive, error);
    }
}
