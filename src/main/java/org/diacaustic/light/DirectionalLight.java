package org.diacaustic.light;

import org.diacaustic.math.Color;
import org.diacaustic.math.Rgb;
import org.diacaustic.math.Vector3;

/** A light infinitely far away, as good as the sun: parallel rays of the same irradiance everywhere. */
public final class DirectionalLight implements Light {
    private final Vector3 towards;
    private final Color irradiance;
    private final double highlightExponent;

    /**
     * @param direction in which the light travels, any length but 0
     * @param irradiance on a surface that faces the light, in W·m⁻²
     */
    public DirectionalLight(Vector3 direction, Color irradiance, double highlightExponent) {
        this.towards = direction.normalized().negated();
        this.irradiance = Emission.checked(irradiance, "irradiance");
        this.highlightExponent = Emission.checkedExponent(highlightExponent);
    }

    @Override
    public boolean sample(double x, double y, double z, double s, double t, LightSample sample) {
        sample.directionX = towards.x();
        sample.directionY = towards.y();
        sample.directionZ = towards.z();
        sample.distance = Double.POSITIVE_INFINITY;
        sample.irradiance.set(irradiance);
        return true;
    }

    @Override
    public double highlightExponent() {
        return highlightExponent;
    }

    @Override
    public Spread spread() {
        return Spread.PARALLEL;
    }

    @Override
    public void emitFrom(double s, double t, LightPoint point) {
        point.set(0, 0, 0, -towards.x(), -towards.y(), -towards.z());
    }

    @Override
    public void emit(LightPoint point, double dx, double dy, double dz, Rgb out) {
        out.set(irradiance);
    }
}
