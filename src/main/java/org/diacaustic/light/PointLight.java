package org.diacaustic.light;

import org.diacaustic.math.Color;
import org.diacaustic.math.Rgb;
import org.diacaustic.math.Vector3;

/**
 * A light without extent that shines alike in all directions.
 *
 * @param position in scene units
 * @param intensity in W·sr⁻¹
 * @param highlightExponent 0 for no highlights
 */
public record PointLight(Vector3 position, Color intensity, Falloff falloff, double highlightExponent)
        implements Light {
    public PointLight {
        Emission.checkedPoint(position, "position");
        Emission.checked(intensity, "intensity");
        Emission.checkedExponent(highlightExponent);
    }

    /** A physical point light without highlights. */
    public PointLight(Vector3 position, Color intensity) {
        this(position, intensity, new Falloff.InverseSquare(), 0);
    }

    @Override
    public boolean sample(double x, double y, double z, double s, double t, LightSample sample) {
        if (!sample.towards(position.x(), position.y(), position.z(), x, y, z)) {
            return false;
        }
        sample.irradiance.set(intensity).scale(falloff.at(sample.distance));
        return true;
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
        out.set(intensity);
    }

    @Override
    public Color flux() {
        return intensity.times(4 * Math.PI);
    }

    @Override
    public double depositFactor(double distance) {
        return falloff.besideSpreading(distance);
    }
}
