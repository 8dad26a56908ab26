package org.diacaustic.render;

import org.diacaustic.light.Light;
import org.diacaustic.math.Ray;
import org.diacaustic.math.Rgb;
import org.diacaustic.math.SampleStream;
import org.diacaustic.parallel.StopSignal;
import org.diacaustic.transport.PathTracer;

/** Follows eye rays: I = A + Σ(D + S) + R + T at every hit [Thesis 1.3]. */
final class EyeTracer extends PathTracer {
    private final RenderPlan plan;
    private final Light[] visibleLights;
    private final DirectLight directLight;
    private final IndirectLight indirectLight;
    private final Counters counters = new Counters();
    private final SampleStream random = new SampleStream();
    private final Rgb glow = new Rgb();
    private final SampleStream lightRandom = new SampleStream();
    private final Rgb otherLight = new Rgb();
    private final Rgb mapLight = new Rgb();
    private final boolean seesMapOnly;
    private boolean seesLight;

    /** @param seesMapOnly whether {@link #trace} is to find nothing but what the map brings */
    EyeTracer(RenderPlan plan, Illumination light, boolean seesMapOnly) {
        super(plan.index(), plan.eyeRules());
        this.plan = plan;
        this.visibleLights = plan.visibleLights();
        this.directLight = new DirectLight(plan, counters, lightRandom);
        this.indirectLight = new IndirectLight(plan, light);
        this.seesMapOnly = seesMapOnly;
    }

    /** The ray to aim before {@link #trace}. */
    Ray ray() {
        return ray;
    }

    /** The random numbers that samples are spread by; those of lights are others, so that neither depends on the other's number. */
    SampleStream random() {
        return random;
    }

    /** The samples from now on are those of another pixel. */
    void startPixel(int pass, long pixel) {
        long seed = plan.settings().seed();
        // Forward passes have the streams above 0.
        random.start(seed, -pass, pixel);
        lightRandom.start(seed, -pass, ~pixel);
        indirectLight.startPixel();
    }

    /**
     * The sample that is traced next; see {@link org.diacaustic.scene.Camera#aim}, which must aim the ray.
     *
     * @param compares whether {@link #difference} is wanted
     */
    void startSample(double x, double y, double lensU, double lensV, boolean compares) {
        indirectLight.startSample(x, y, lensU, lensV, compares);
    }

    /** How much the last sample would change with a coarser map; valid until the next. */
    Rgb difference() {
        return indirectLight.difference();
    }

    /** Forgets what the last task taught about blockers, so that counters do not depend on the order of tasks. */
    void startTask() {
        directLight.startTask();
    }

    /** What was counted since the tracer was made. */
    Counters counters() {
        counters.shadowTests = directLight.tests();
        counters.intersectionTests = tests() + directLight.tests() + indirectLight.tests();
        counters.nodesExamined = indirectLight.nodesExamined();
        counters.photonsUsed = indirectLight.photonsUsed();
        return counters;
    }

    /**
     * The radiance that arrives along the aimed ray, but what the map brings of it; valid until the next call. Only a part of it
     * if the signal is set meanwhile, for between mirrors a ray may go on for long.
     */
    Rgb trace(StopSignal stop) {
        counters.eyeRays++;
        otherLight.set(0, 0, 0);
        mapLight.set(0, 0, 0);
        followAll(plan.mediaAtEye(), stop);
        return otherLight;
    }

    /** What the map brings of the last radiance; valid until the next. */
    Rgb mapLight() {
        return mapLight;
    }

    /** Whether a light that can be seen lies before everything else; sets its radiance. */
    @Override
    protected boolean endsBeforeSurface() {
        seesLight = false;
        ray.leaving = Ray.FREE;
        for (Light light : visibleLights) {
            seesLight |= light.emitsAlong(ray, glow);
        }
        return seesLight;
    }

    @Override
    protected void end() {
        if (!seesLight) {
            glow.set(plan.scene().background());
        }
        otherLight.addProduct(throughput, glow);
    }

    /** Adds A and Σ(D + S) of the hit. */
    @Override
    protected boolean arrive(int object, int side) {
        indirectLight.pass(depth, signature);
        indirectLight.add(
                object, side, depth, signatureAt(object, side), ray, pathLength, hit, surface, throughput, mapLight);
        if (!seesMapOnly) {
            addAmbient();
            directLight.add(object, side, hit, surface, scattering, media, throughput, otherLight);
        }
        return true;
    }

    private void addAmbient() {
        double share = plan.diffuseFactor();
        otherLight.add(
                throughput.red * surface.diffuse.red * surface.ambient.red * share,
                throughput.green * surface.diffuse.green * surface.ambient.green * share,
                throughput.blue * surface.diffuse.blue * surface.ambient.blue * share);
    }

    @Override
    protected void goesOn(boolean refracted) {
        if (refracted) {
            counters.refractionRays++;
        } else {
            counters.reflectionRays++;
        }
    }

    @Override
    protected void cut(Rgb fraction) {
        counters.cutRays++;
    }

    /** Makes the sample what is not a number, so that it is counted. */
    @Override
    protected void spoiled() {
        otherLight.set(Double.NaN, Double.NaN, Double.NaN);
        mapLight.set(Double.NaN, Double.NaN, Double.NaN);
    }
}
