package org.diacaustic.light;

import org.diacaustic.math.Color;
import org.diacaustic.math.Ray;
import org.diacaustic.math.Rgb;
import org.diacaustic.math.Vector3;
import org.diacaustic.shape.Sphere;

/** A glowing ball. Only the cap of it that a point can see is sampled. */
public final class SphereLight extends AreaLight {
    private final Sphere sphere;
    private final Vector3 centre;
    private final double radius;

    public SphereLight(Vector3 centre, double radius, Color radiance, Falloff falloff, int sampleCount) {
        super(radiance, falloff, sampleCount);
        this.sphere = new Sphere(centre, radius);
        this.centre = centre;
        this.radius = radius;
    }

    @Override
    public boolean sample(double x, double y, double z, double s, double t, LightSample sample) {
        if (!sample.towards(centre.x(), centre.y(), centre.z(), x, y, z) || !(sample.distance > radius)) {
            return false;
        }
        // The visible cap about the axis from the centre to the point: heights radius·(radius ÷ distance .. 1).
        double ax = -sample.directionX;
        double ay = -sample.directionY;
        double az = -sample.directionZ;
        double horizon = radius / sample.distance;
        double height = 1 - s * (1 - horizon);
        double ring = Math.sqrt(Math.max(0, (1 - height) * (1 + height)));
        double angle = 2 * Math.PI * t;
        double cos = ring * StrictMath.cos(angle);
        double sin = ring * StrictMath.sin(angle);
        // A frame about the axis without a branch on its length [Duff et al. 2017].
        double sign = Math.copySign(1.0, az);
        double p = -1 / (sign + az);
        double q = ax * ay * p;
        double nx = height * ax + cos * (1 + sign * ax * ax * p) + sin * q;
        double ny = height * ay + cos * (sign * q) + sin * (sign + ay * ay * p);
        double nz = height * az + cos * (-sign * ax) + sin * (-ay);
        double cap = 2 * Math.PI * radius * radius * (1 - horizon);
        if (!sample.towards(
                Math.fma(radius, nx, centre.x()),
                Math.fma(radius, ny, centre.y()),
                Math.fma(radius, nz, centre.z()),
                x,
                y,
                z)) {
            return false;
        }
        return shine(cap, -(sample.directionX * nx + sample.directionY * ny + sample.directionZ * nz), sample);
    }

    @Override
    public boolean emitsAlong(Ray ray, Rgb radiance) {
        double ox = ray.originX - centre.x();
        double oy = ray.originY - centre.y();
        double oz = ray.originZ - centre.z();
        boolean outside = ox * ox + oy * oy + oz * oz > radius * radius;
        double before = ray.tMax;
        if (!outside || !sphere.intersect(ray)) {
            return false;
        }
        double t = ray.tMax;
        ray.tMax = before;
        return seen(t, ray, radiance);
    }
}
