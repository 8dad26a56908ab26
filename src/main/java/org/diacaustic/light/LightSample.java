package org.diacaustic.light;

import org.diacaustic.math.Arithmetic;
import org.diacaustic.math.Rgb;

/** Where light comes from and how much: mutable, owned by one task. */
public final class LightSample {
    /** Unit direction from the lit point towards the light. */
    public double directionX;

    public double directionY;
    public double directionZ;

    /** Distance to the light in scene units; infinite for a directional light. */
    public double distance;

    /** Irradiance on a surface that faces the light, with falloff, before anything in between. */
    public final Rgb irradiance = new Rgb();

    /** Where lights with an extent keep the point that they chose. */
    final LightPoint from = new LightPoint();

    /**
     * Points from (x, y, z) towards the light at (lx, ly, lz).
     *
     * @return false if the two coincide
     */
    boolean towards(double lx, double ly, double lz, double x, double y, double z) {
        double dx = lx - x;
        double dy = ly - y;
        double dz = lz - z;
        distance = Arithmetic.length(dx, dy, dz);
        if (!(distance > 0)) {
            return false;
        }
        directionX = dx / distance;
        directionY = dy / distance;
        directionZ = dz / distance;
        return true;
    }
}
