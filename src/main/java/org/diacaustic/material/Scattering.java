package org.diacaustic.material;

import org.diacaustic.math.Dielectric;
import org.diacaustic.math.Ray;
import org.diacaustic.math.Rgb;
import org.diacaustic.shape.Hit;

/**
 * The mirrored and the refracted continuation of a ray at a surface, each with its direction and the fraction it
 * carries: the one physics of the eye pass and of the forward passes [Thesis 2.2, 2.3]. Mutable and owned by one task;
 * {@link #evaluate} fills it in.
 *
 * <p>With Fresnel reflectance F, given reflectivity r and transparency t: R = F + (1 − F)·r and T = (1 − F)·t; opaque
 * surfaces have F = 0. Without Fresnel, R = r and T = t, and under total internal reflection R = r + t.
 *
 * <p>The geometric normal decides which side the ray is on, the shading normal where the continuations point. A bump, or
 * a smooth normal on flat triangles, could send a mirrored ray into the surface or a refracted one out of it: such a
 * direction is mirrored back by the surface as it is. It passes the horizon at an angle that is too small to see but not 0,
 * and nothing jumps there; nor do rays slide along the surface.
 */
public final class Scattering {
    /** The sine of the angle to the horizon (0.06°) within which bumped normals and their rays are bent. */
    private static final double HORIZON = 0x1p-10;

    /** The fraction mirrored, per colour. */
    public final Rgb reflectance = new Rgb();

    /** The fraction refracted, per colour, with the scaling of radiance if that is what travels. */
    public final Rgb transmittance = new Rgb();

    public double reflectedX;
    public double reflectedY;
    public double reflectedZ;
    public double transmittedX;
    public double transmittedY;
    public double transmittedZ;

    /** Whether the refracted ray does not exist because the angle is beyond the critical one. */
    public boolean totalInternalReflection;

    private final Dielectric dielectric = new Dielectric();
    private double cosIncident;
    private double normalX;
    private double normalY;
    private double normalZ;

    /**
     * @param ray the arriving ray, of unit direction
     * @param hit completed, with the shading normal tilted
     * @param surface the coefficients at the hit
     * @param side 1 if the ray arrives where the normal points, −1 behind
     * @param nNear index of refraction on the side where the ray arrives
     * @param nFar index of refraction on the other side
     */
    public void evaluate(
            ScatterRules rules,
            TransportMode mode,
            Ray ray,
            Hit hit,
            Surface surface,
            int side,
            double nNear,
            double nFar) {
        boolean bumped = hit.shadingX != hit.normalX || hit.shadingY != hit.normalY || hit.shadingZ != hit.normalZ;
        faceTheRay(rules, ray, hit, side, bumped);
        boolean transparent = !surface.transparency.isBlack();
        double fresnel = 0;
        totalInternalReflection = false;
        if (transparent) {
            dielectric.evaluate(cosIncident, nNear, nFar);
            totalInternalReflection = dielectric.totalInternalReflection;
            fresnel = rules.fresnel() ? dielectric.reflectance : 0;
        }
        double rest = transparent && rules.fresnel() ? dielectric.transmittance : 1;
        reflectance.set(surface.reflectivity).scale(rest).add(fresnel, fresnel, fresnel);
        transmittance.set(surface.transparency).scale(rest);
        if (totalInternalReflection) {
            if (!rules.fresnel() && !rules.dropTotalInternalReflection()) {
                reflectance.add(transmittance);
            } else if (rules.dropTotalInternalReflection()) {
                reflectance.set(surface.reflectivity);
            }
            transmittance.set(0, 0, 0);
        }
        if (!reflectance.isBlack()) {
            reflect(ray, hit, side, bumped);
        }
        if (!transmittance.isBlack()) {
            refract(ray, hit, side, bumped);
            if (mode == TransportMode.RADIANCE && rules.scaleRadiance()) {
                transmittance.scale(dielectric.eta * dielectric.eta);
            }
        }
    }

    /** Sets the normal to shade with so that it faces against the ray, and the cosine of incidence. */
    private void faceTheRay(ScatterRules rules, Ray ray, Hit hit, int side, boolean bumped) {
        normalX = side * hit.shadingX;
        normalY = side * hit.shadingY;
        normalZ = side * hit.shadingZ;
        cosIncident = -(ray.directionX * normalX + ray.directionY * normalY + ray.directionZ * normalZ);
        if (!bumped) {
            cosIncident = Math.min(1, Math.max(0, cosIncident));
        } else if (rules.backFacingBump() == ScatterRules.BackFacingBump.FLIP) {
            double sign = Math.copySign(1.0, cosIncident);
            normalX *= sign;
            normalY *= sign;
            normalZ *= sign;
            cosIncident = Math.min(1, sign * cosIncident);
        } else if (cosIncident < HORIZON) {
            double lift = HORIZON - cosIncident;
            double nx = normalX - lift * ray.directionX;
            double ny = normalY - lift * ray.directionY;
            double nz = normalZ - lift * ray.directionZ;
            double length = Math.sqrt(nx * nx + ny * ny + nz * nz);
            normalX = nx / length;
            normalY = ny / length;
            normalZ = nz / length;
            cosIncident = HORIZON / length;
        } else {
            cosIncident = Math.min(1, cosIncident);
        }
    }

    /** [Thesis 2.2, Eq. 1] */
    private void reflect(Ray ray, Hit hit, int side, boolean bumped) {
        double twice = 2 * cosIncident;
        double x = Math.fma(twice, normalX, ray.directionX);
        double y = Math.fma(twice, normalY, ray.directionY);
        double z = Math.fma(twice, normalZ, ray.directionZ);
        double lift = bumped ? liftOverHorizon(x, y, z, hit, side) : 0;
        x += lift * hit.normalX;
        y += lift * hit.normalY;
        z += lift * hit.normalZ;
        double length = Math.sqrt(x * x + y * y + z * z);
        reflectedX = x / length;
        reflectedY = y / length;
        reflectedZ = z / length;
    }

    /** [Thesis 2.3, Eq. 3]; equal indices leave the direction as it is, to the bit. */
    private void refract(Ray ray, Hit hit, int side, boolean bumped) {
        if (dielectric.eta == 1) {
            transmittedX = ray.directionX;
            transmittedY = ray.directionY;
            transmittedZ = ray.directionZ;
            return;
        }
        double eta = dielectric.eta;
        double g = dielectric.normalCoefficient();
        double x = Math.fma(eta, ray.directionX, g * normalX);
        double y = Math.fma(eta, ray.directionY, g * normalY);
        double z = Math.fma(eta, ray.directionZ, g * normalZ);
        double lift = bumped ? liftOverHorizon(x, y, z, hit, -side) : 0;
        x += lift * hit.normalX;
        y += lift * hit.normalY;
        z += lift * hit.normalZ;
        double length = Math.sqrt(x * x + y * y + z * z);
        transmittedX = x / length;
        transmittedY = y / length;
        transmittedZ = z / length;
    }

    /**
     * How much of the geometric normal must be added so that a direction points to the given side: one that points to the
     * other is mirrored by the surface as it is, and none is left flatter than the horizon.
     */
    private static double liftOverHorizon(double x, double y, double z, Hit hit, int side) {
        double height = side * (x * hit.normalX + y * hit.normalY + z * hit.normalZ);
        return height < HORIZON ? side * (Math.max(HORIZON, -height) - height) : 0;
    }
}
