package org.diacaustic.render;

import org.diacaustic.light.Light;
import org.diacaustic.light.LightSample;
import org.diacaustic.material.Scattering;
import org.diacaustic.material.Surface;
import org.diacaustic.math.Arithmetic;
import org.diacaustic.math.Rgb;
import org.diacaustic.math.SampleStream;
import org.diacaustic.scene.MediumStack;
import org.diacaustic.shader.ShadowRay;
import org.diacaustic.shape.Hit;

/**
 * Σ(D + S): what the lights add at a hit directly, diffusely and as highlights [Thesis 1.3, 2.1, 3.2].
 *
 * <p>No shadow ray is followed whose light would not be seen, except where the counters are to mean what the thesis' do.
 */
final class DirectLight {
    private final RenderPlan plan;
    private final Light[] lights;
    private final ShadowRay shadow;
    private final Counters counters;
    private final SampleStream random;
    private final boolean followsAll;
    private final double diffuseFactor;
    private final double leastWeight;
    private final LightSample sample = new LightSample();
    private final Rgb arrives = new Rgb();
    private final Rgb weight = new Rgb();

    DirectLight(RenderPlan plan, Counters counters, SampleStream random) {
        this.plan = plan;
        this.lights = plan.scene().lights().toArray(Light[]::new);
        this.followsAll = plan.settings().usesListOrder();
        this.diffuseFactor = plan.diffuseFactor();
        // What a ray that is just worth following would lose if just as little were left out of it.
        double minimumThroughput = plan.settings().minimumThroughput();
        this.leastWeight = minimumThroughput * minimumThroughput;
        this.shadow = new ShadowRay(plan.index(), lights.length, !followsAll);
        this.counters = counters;
        this.random = random;
    }

    void startTask() {
        shadow.forgetBlockers();
    }

    long tests() {
        return shadow.tests();
    }

    /**
     * Adds what all lights contribute.
     *
     * @param side 1 if the eye is where the normal points, −1 behind
     * @param media around the hit on the eye's side
     * @param throughput from the hit to the eye
     */
    void add(
            int object,
            int side,
            Hit hit,
            Surface surface,
            Scattering scattering,
            MediumStack media,
            Rgb throughput,
            Rgb radiance) {
        boolean diffuses = !surface.diffuse.isBlack();
        // What is totally reflected came through the object bent, and straight lines know nothing of that.
        boolean mirrors = !scattering.reflectance.isBlack() && (followsAll || !scattering.totalInternalReflection);
        for (int i = 0; i < lights.length; i++) {
            Light light = lights[i];
            boolean highlights = mirrors && light.highlightExponent() > 0;
            if (!diffuses && !highlights && !followsAll) {
                continue;
            }
            int count = sampleCount(light, throughput);
            boolean isPoint = light.sampleCount() == 1 && !light.isVisible();
            double shift = isPoint ? 0 : random.nextDouble();
            for (int j = 0; j < count; j++) {
                double s = isPoint ? 0.5 : (j + random.nextDouble()) / count;
                double t = isPoint ? 0.5 : Stratification.shiftedInverse(j, 2, shift);
                if (light.sample(hit.x, hit.y, hit.z, s, t, sample)) {
                    weigh(light, side, hit, surface, highlights ? scattering : null, throughput);
                    if (reaches(i, object, hit, media)) {
                        arrives.multiply(sample.irradiance).scale(1.0 / count);
                        radiance.addProduct(arrives, weight);
                    }
                }
            }
        }
    }

    /** Fewer samples where their light reaches the eye weakened: their noise is weakened too. */
    private int sampleCount(Light light, Rgb throughput) {
        int all = light.sampleCount();
        return followsAll ? all : (int) Math.ceil(all * Arithmetic.clamp(throughput.largest(), 0x1p-40, 1));
    }
    /** Sets the weight to radiance at the eye ÷ irradiance from the sample; 0 if the surface faces away from it. */
    private void weigh(Light light, int side, Hit hit, Surface surface, Scattering highlights, Rgb throughput) {
        weight.set(0, 0, 0);
        double cos = side * cosine(hit.shadingX, hit.shadingY, hit.shadingZ);
        // Written so that what is not a number goes on, and is seen.
        if (cos <= 0 || side * cosine(hit.normalX, hit.normalY, hit.normalZ) <= 0) {
            return;
        }
        weight.set(surface.diffuse).scale(cos * diffuseFactor);
        if (highlights != null) {
            double towards = cosine(highlights.reflectedX, highlights.reflectedY, highlights.reflectedZ);
            double lobe = plan.highlight(towards, light.highlightExponent());
            Rgb reflectance = highlights.reflectance;
            weight.add(lobe * reflectance.red, lobe * reflectance.green, lobe * reflectance.blue);
        }
        weight.multiply(throughput);
    }

    /** Follows the straight line to the sample, if its light is worth it. */
    private boolean reaches(int light, int object, Hit hit, MediumStack media) {
        double largest = weight.largest();
        boolean matters = !(largest <= 0 || largest < leastWeight);
        if (!matters && !followsAll) {
            return false;
        }
        counters.shadowRays++;
        shadow.aim(light, hit, object, sample, media);
        return plan.shader().transmit(shadow, arrives) && matters;
    }

    private double cosine(double x, double y, double z) {
        return sample.directionX * x + sample.directionY * y + sample.directionZ * z;
    }
}
