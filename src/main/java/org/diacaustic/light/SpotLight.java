package org.diacaustic.light;

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
    private final double innerSpread;
    private final double outerSpread;

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
        this.innerSpread = spread(innerDegrees);
        this.outerSpread = spread(outerDegrees);
    }

    @Override
    public boolean sample(double x, double y, double z, double s, double t, LightSample sample) {
        if (!sample.towards(position.x(), position.y(), position.z(), x, y, z)) {
            return false;
        }
        double share = share(-sample.directionX, -sample.directionY, -sample.directionZ);
        sample.irradiance.set(intensity).scale(share * falloff.at(sample.distance));
        return share > 0;
    }

    /** 2·(1 − cosθ) of an angle, as 4·sin²(θ/2), which the narrowest cones have digits of. */
    private static double spread(double degrees) {
        double sine = StrictMath.sin(StrictMath.toRadians(degrees) / 2);
        return 4 * sine * sine;
    }

    /** The fraction of the full intensity in a unit direction; its spread is its distance from the axis, squared. */
    private double share(double dx, double dy, double dz) {
        double ex = dx - axis.x();
        double ey = dy - axis.y();
        double ez = dz - axis.z();
        double spread = Math.min(4, ex * ex + ey * ey + ez * ez);
        if (spread <= innerSpread) {
            return 1;
        }
        if (!(spread < outerSpread)) {
            return 0;
        }
        double step = (outerSpread - spread) / (outerSpread - innerSpread);
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
        out.set(intensity).scale(share(dx, dy, dz));
    }

    /** The smooth step stands for half of the cone that it fills. */
    @Override
    public Color flux() {
        return intensity.times(Math.PI / 2 * (innerSpread + outerSpread));
    }

    @Override
    public double depositFactor(double distance) {
        return falloff.besideSpreading(distance);
    }
}
