package org.diacaustic.light;

import org.diacaustic.math.Arithmetic;
import org.diacaustic.math.Color;
import org.diacaustic.math.Rgb;
import org.diacaustic.math.Vector3;

/**
 * A point light that shines into a cone: full intensity within the inner half-angle, none beyond the outer one, and in
 * between a smooth step of the cosine. With both angles equal the cone is uniform with a sharp edge.
 */
public final class SpotLight implements Light {
    private final Vector3 position;
    private final Vector3 axis;
    private final Color intensity;
    private final Falloff falloff;
    private final double highlightExponent;
    private final double cosInner;
    private final double cosOuter;

    /**
     * @param direction where the spot shines, any length but 0
     * @param innerDegrees half-angle of full intensity, 0..180
     * @param outerDegrees half-angle beyond which there is no light, from innerDegrees to 180
     */
    public SpotLight(
            Vector3 position,
            Vector3 direction,
            double innerDegrees,
            double outerDegrees,
            Color intensity,
            Falloff falloff,
            double highlightExponent) {
        if (!(innerDegrees >= 0 && innerDegrees <= outerDegrees && outerDegrees > 0 && outerDegrees <= 180)) {
            throw new IllegalArgumentException("a spot needs half-angles 0 <= inner <= outer <= 180 degrees, outer > 0,"
                    + " but has inner " + innerDegrees + " and outer " + outerDegrees);
        }
        this.position = Emission.checkedPoint(position, "position");
        this.axis = direction.normalized();
        this.intensity = Emission.checked(intensity, "intensity");
        this.falloff = falloff;
        this.highlightExponent = Emission.checkedExponent(highlightExponent);
        this.cosInner = StrictMath.cos(StrictMath.toRadians(innerDegrees));
        this.cosOuter = StrictMath.cos(StrictMath.toRadians(outerDegrees));
    }

    @Override
    public boolean sample(double x, double y, double z, double s, double t, LightSample sample) {
        if (!sample.towards(position.x(), position.y(), position.z(), x, y, z)) {
            return false;
        }
        double cos = -(sample.directionX * axis.x() + sample.directionY * axis.y() + sample.directionZ * axis.z());
        double share = share(cos);
        sample.irradiance.set(intensity).scale(share * falloff.at(sample.distance));
        return share > 0;
    }

    /** The fraction of the full intensity in a direction at angle acos(cos) from the axis. */
    private double share(double cos) {
        if (cos >= cosInner) {
            return 1;
        }
        if (!(cos > cosOuter)) {
            return 0;
        }
        double step = Arithmetic.clamp((cos - cosOuter) / (cosInner - cosOuter), 0, 1);
        return step * step * (3 - 2 * step);
    }

    @Override
    public double highlightExponent() {
        return highlightExponent;
    }

    @Override
    public Spread spread() {
        return Spread.FROM_POINT;
    }

    @Override
    public void emitFrom(double s, double t, LightPoint point) {
        point.set(position.x(), position.y(), position.z(), 0, 0, 0);
    }

    @Override
    public void emit(LightPoint point, double dx, double dy, double dz, Rgb out) {
        out.set(intensity).scale(share(dx * axis.x() + dy * axis.y() + dz * axis.z()));
    }

    @Override
    public double depositFactor(double distance) {
        return falloff.besideSpreading(distance);
    }
}
