package org.diacaustic.light;

import org.diacaustic.math.Color;
import org.diacaustic.math.Ray;
import org.diacaustic.math.Rgb;
import org.diacaustic.math.Vector3;
import org.diacaustic.shape.Sphere;

/**
 * A glowing ball. Directions to it are chosen uniformly from the cone in which a point outside sees it, so with light
 * that falls off as it does in nature, all samples of a small ball carry the same [Pharr, Jakob and Humphreys 2016,
 * 14.2.2]. From inside it is dark.
 */
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
        double ax = sample.directionX;
        double ay = sample.directionY;
        double az = sample.directionZ;
        double sinRim = radius / sample.distance;
        double cosRim = Math.sqrt((1 - sinRim) * (1 + sinRim));
        double versineRim = sinRim * sinRim / (1 + cosRim);
        double versine = s * versineRim;
        double cosine = 1 - versine;
        double sine = Math.sqrt(versine * (2 - versine));
        double angle = 2 * Math.PI * t;
        double p = sine * StrictMath.cos(angle);
        double q = sine * StrictMath.sin(angle);
        // A frame about the axis without a branch on its length [Duff et al. 2017].
        double sign = Math.copySign(1.0, az);
        double a = -1 / (sign + az);
        double b = ax * ay * a;
        sample.directionX = cosine * ax + p * (1 + sign * ax * ax * a) + q * b;
        sample.directionY = cosine * ay + p * (sign * b) + q * (sign + ay * ay * a);
        sample.directionZ = cosine * az + p * (-sign * ax) + q * -ay;
        double halfChordSquared = Math.max(0, (sinRim - sine) * (sinRim + sine));
        sample.distance *= cosine - Math.sqrt(halfChordSquared);
        double solidAngle = 2 * Math.PI * versineRim;
        return shineFrom(solidAngle, sample);
    }

    /** Uniform on the surface. */
    @Override
    public void emitFrom(double s, double t, LightPoint point) {
        double height = 1 - 2 * s;
        double fromAxis = 2 * Math.sqrt(s * (1 - s));
        double angle = 2 * Math.PI * t;
        double nx = fromAxis * StrictMath.cos(angle);
        double nz = fromAxis * StrictMath.sin(angle);
        point.set(centre.x() + radius * nx, centre.y() + radius * height, centre.z() + radius * nz, nx, height, nz);
    }

    @Override
    double area() {
        return 4 * Math.PI * radius * radius;
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
