package org.diacaustic.light;

import org.diacaustic.math.Color;
import org.diacaustic.math.Ray;
import org.diacaustic.math.Rgb;

/**
 * A light with an extent: a surface that sends the same radiance into all directions of its bright side. For direct
 * light it is many points of intensity radiance · cosθ · dA, where θ is the angle at the light. It can be seen, in mirrors
 * too, so it makes no highlights: those stand for the size of lights that have none.
 */
abstract class AreaLight implements Light {
    private final Color radiance;
    private final Falloff falloff;
    private final int sampleCount;

    /** @param radiance in W·m⁻²·sr⁻¹ */
    AreaLight(Color radiance, Falloff falloff, int sampleCount) {
        this.radiance = Emission.checked(radiance, "radiance");
        this.falloff = falloff;
        this.sampleCount = Emission.checkedSamples(sampleCount);
    }

    @Override
    public final int sampleCount() {
        return sampleCount;
    }

    @Override
    public final boolean isVisible() {
        return true;
    }

    /** Lights from the sampled point, which stands for an area (scene units squared) at an angle at the light. */
    final boolean shine(double area, double cosAtLight, LightSample sample) {
        if (!(cosAtLight > 0)) {
            return false;
        }
        sample.irradiance.set(radiance).scale(area * cosAtLight * falloff.at(sample.distance));
        return true;
    }

    /** Lights from the sampled point, which stands for a solid angle as seen from the lit point. */
    final boolean shineFrom(double solidAngle, LightSample sample) {
        double distance = sample.distance;
        if (!(distance > 0)) {
            return false;
        }
        sample.irradiance.set(radiance).scale(solidAngle * (distance * distance * falloff.at(distance)));
        return true;
    }

    /** Reports that the ray meets the bright side at t, if it is the nearest so far. */
    final boolean seen(double t, Ray ray, Rgb seenRadiance) {
        if (!(t > 0 && t < ray.tMax)) {
            return false;
        }
        ray.tMax = t;
        seenRadiance.set(radiance);
        return true;
    }

    @Override
    public final Spread spread() {
        return Spread.FROM_POINT;
    }

    /** The area of the bright side, in scene units squared. */
    abstract double area();

    @Override
    public final void emit(LightPoint point, double dx, double dy, double dz, Rgb out) {
        double cosine = dx * point.normalX + dy * point.normalY + dz * point.normalZ;
        out.set(radiance).scale(area() * Math.max(0, cosine));
    }

    @Override
    public final Color flux() {
        return radiance.times(Math.PI * area());
    }

    @Override
    public final double depositFactor(double distance) {
        return falloff.besideSpreading(distance);
    }
}
