package org.diacaustic.render;

import org.diacaustic.light.Light;
import org.diacaustic.light.LightSample;
import org.diacaustic.material.Scattering;
import org.diacaustic.material.Surface;
import org.diacaustic.math.Rgb;
import org.diacaustic.math.SampleStream;
import org.diacaustic.scene.MediumStack;
import org.diacaustic.shader.ShadowRay;
import org.diacaustic.shape.Hit;

/** Σ(D + S): what the lights add at a hit directly, diffusely and as highlights [Thesis 1.3, 2.1, 3.2]. */
final class DirectLight {
    private final RenderPlan plan;
    private final Light[] lights;
    private final ShadowRay shadow;
    private final Counters counters;
    private final SampleStream random;
    private final LightSample sample = new LightSample();
    private final Rgb arrives = new Rgb();

    DirectLight(RenderPlan plan, Counters counters, SampleStream random) {
        this.plan = plan;
        this.lights = plan.scene().lights().toArray(Light[]::new);
        this.shadow =
                new ShadowRay(plan.index(), lights.length, !plan.settings().usesListOrder());
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
        for (int i = 0; i < lights.length; i++) {
            Light light = lights[i];
            boolean highlights = light.highlightExponent() > 0 && !scattering.reflectance.isBlack();
            if (surface.diffuse.isBlack() && !highlights && !plan.settings().usesListOrder()) {
                continue;
            }
            int count = light.sampleCount();
            double shift = count == 1 ? 0 : random.nextDouble();
            for (int j = 0; j < count; j++) {
                double s = count == 1 ? 0.5 : (j + random.nextDouble()) / count;
                double t = count == 1 ? 0.5 : Stratification.shiftedInverse(j, 2, shift);
                if (light.sample(hit.x, hit.y, hit.z, s, t, sample) && reaches(i, object, side, hit, media)) {
                    shine(light, 1.0 / count, side, hit, surface, highlights ? scattering : null, throughput, radiance);
                }
            }
        }
    }

    /** Follows the straight line to the sample, if it is above the surface. */
    private boolean reaches(int light, int object, int side, Hit hit, MediumStack media) {
        boolean above = side * cosine(hit.normalX, hit.normalY, hit.normalZ) > 0;
        if (!above && !plan.settings().usesListOrder()) {
            return false;
        }
        counters.shadowRays++;
        shadow.aim(light, hit, object, sample, media);
        return plan.shader().transmit(shadow, arrives) && above;
    }

    private void shine(
            Light light,
            double share,
            int side,
            Hit hit,
            Surface surface,
            Scattering highlights,
            Rgb throughput,
            Rgb radiance) {
        double cos = side * cosine(hit.shadingX, hit.shadingY, hit.shadingZ);
        if (!(cos > 0)) {
            return;
        }
        arrives.multiply(sample.irradiance).scale(share).multiply(throughput);
        double diffuse = cos * plan.diffuseFactor();
        radiance.add(
                arrives.red * surface.diffuse.red * diffuse,
                arrives.green * surface.diffuse.green * diffuse,
                arrives.blue * surface.diffuse.blue * diffuse);
        if (highlights != null) {
            double towards = cosine(highlights.reflectedX, highlights.reflectedY, highlights.reflectedZ);
            double lobe = plan.highlight(towards, light.highlightExponent());
            radiance.add(
                    arrives.red * highlights.reflectance.red * lobe,
                    arrives.green * highlights.reflectance.green * lobe,
                    arrives.blue * highlights.reflectance.blue * lobe);
        }
    }

    private double cosine(double x, double y, double z) {
        return sample.directionX * x + sample.directionY * y + sample.directionZ * z;
    }
}
