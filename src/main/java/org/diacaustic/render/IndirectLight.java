package org.diacaustic.render;

import java.util.Arrays;
import org.diacaustic.map.IlluminationMap;
import org.diacaustic.map.SurfacePoint;
import org.diacaustic.material.Surface;
import org.diacaustic.math.Ray;
import org.diacaustic.math.Rgb;
import org.diacaustic.shape.Hit;

/**
 * The light that reaches a hit after being refracted or mirrored, as the map of the forward pass has it: the A of the thesis'
 * equation [Thesis 1.3, 3.3]. A map that reads footprints is asked for the mean over what the whole pixel sees there, once a
 * pixel for each way of the eye. Owned by one task.
 */
final class IndirectLight {
    /** Two colours. */
    private static final int ANSWER = 6;

    /** Null if there was no forward pass. */
    private final IlluminationMap.Lookup lookup;

    /** Null if there is no second map. */
    private final IlluminationMap.Lookup coarser;

    private final double diffuseFactor;
    private final boolean looksEverywhere;
    private final boolean keepsAnswers;
    /** Null if the map does not read footprints. */
    private final PixelFootprint footprint;

    private final SurfacePoint at = new SurfacePoint();
    private final Rgb irradiance = new Rgb();
    private final Rgb coarserIrradiance = new Rgb();
    private final Rgb difference = new Rgb();

    /** What was found for the pixel so far, by the way of the eye. */
    private long[] ways = new long[8];

    private double[] answers = new double[8 * ANSWER];
    private int answered;
    private boolean isCompared;

    IndirectLight(RenderPlan plan, Illumination light) {
        this.lookup = light.map() == null ? null : light.map().lookup();
        this.coarser = light.coarser() == null ? null : light.coarser().lookup();
        this.diffuseFactor = plan.diffuseFactor();
        this.looksEverywhere = plan.settings().usesListOrder();
        this.keepsAnswers = !(plan.scene().camera().lensRadius() > 0);
        this.footprint = lookup != null && light.map().readsFootprints() ? new PixelFootprint(plan) : null;
    }

    void startPixel() {
        answered = 0;
    }

    /**
     * See {@link org.diacaustic.scene.Camera#aim}.
     *
     * @param compares whether the sample stands for others when the two maps are compared
     */
    void startSample(double x, double y, double lensU, double lensV, boolean compares) {
        isCompared = coarser != null && compares;
        difference.set(0, 0, 0);
        if (footprint != null) {
            footprint.startSample(x, y, lensU, lensV);
        }
    }

    /** The eye ray has come here, mirrored or refracted so often. */
    void pass(int depth, long signature) {
        if (footprint != null) {
            footprint.pass(depth, signature);
        }
    }

    /**
     * Adds the light at a hit.
     *
     * @param way the signature of the eye's path with its end
     * @param pathLength its length, in scene units
     */
    void add(
            int object,
            int side,
            int depth,
            long way,
            Ray ray,
            double pathLength,
            Hit hit,
            Surface surface,
            Rgb throughput,
            Rgb radiance) {
        if (lookup == null || (surface.diffuse.isBlack() && !looksEverywhere)) {
            return;
        }
        at.x = hit.x;
        at.y = hit.y;
        at.z = hit.z;
        at.normalX = side * hit.normalX;
        at.normalY = side * hit.normalY;
        at.normalZ = side * hit.normalZ;
        at.object = object;
        at.front = side > 0;
        if (footprint == null) {
            lookup.irradiance(at, irradiance);
        } else if (!isAnswered(way)) {
            ask(depth, way, ray, pathLength, throughput.largest() * surface.diffuse.largest());
        }
        irradiance.multiply(surface.diffuse).scale(diffuseFactor);
        radiance.addProduct(throughput, irradiance);
        if (isCompared) {
            coarserIrradiance.multiply(surface.diffuse).scale(-diffuseFactor).add(irradiance);
            difference.addProduct(throughput, coarserIrradiance);
        }
    }

    private boolean isAnswered(long way) {
        for (int i = 0; i < answered; i++) {
            if (ways[i] == way) {
                int k = i * ANSWER;
                irradiance.set(answers[k], answers[k + 1], answers[k + 2]);
                coarserIrradiance.set(answers[k + 3], answers[k + 4], answers[k + 5]);
                return true;
            }
        }
        return false;
    }

    private void ask(int depth, long way, Ray ray, double pathLength, double weight) {
        boolean isWhole = footprint.find(depth, way, ray, pathLength, weight, at);
        footprint.ask(lookup, at, irradiance);
        if (isCompared && (depth == 0 || weight >= PixelFootprint.WORTHWHILE)) {
            footprint.ask(coarser, at, coarserIrradiance);
        } else {
            coarserIrradiance.set(irradiance);
        }
        if (isWhole && keepsAnswers) {
            keepAnswer(way);
        }
    }

    private void keepAnswer(long way) {
        if (answered == ways.length) {
            ways = Arrays.copyOf(ways, 2 * answered);
            answers = Arrays.copyOf(answers, 2 * answered * ANSWER);
        }
        ways[answered] = way;
        int k = answered * ANSWER;
        answers[k] = irradiance.red;
        answers[k + 1] = irradiance.green;
        answers[k + 2] = irradiance.blue;
        answers[k + 3] = coarserIrradiance.red;
        answers[k + 4] = coarserIrradiance.green;
        answers[k + 5] = coarserIrradiance.blue;
        answered++;
    }

    /** What the sample's radiance is more with the map than it would be with the coarser one. */
    Rgb difference() {
        return difference;
    }

    /** Tests of a ray against a primitive or a bounding volume, made to find footprints. */
    long tests() {
        return footprint == null ? 0 : footprint.tests();
    }

    long nodesExamined() {
        return lookup == null ? 0 : lookup.nodesExamined();
    }

    long photonsUsed() {
        return lookup == null ? 0 : lookup.photonsUsed();
    }
}
