package org.diacaustic.light;

import org.diacaustic.math.Color;
import org.diacaustic.math.Ray;
import org.diacaustic.math.Rgb;
import org.diacaustic.math.Vector3;

/** A flat area light, a disc or a parallelogram, bright on the side its normal points to. */
public final class FlatLight extends AreaLight {
    private final Vector3 centre;
    private final Vector3 sideU;
    private final Vector3 sideV;
    /** What a vector of the plane is multiplied by for its share of {@link #sideU}, and of {@link #sideV}. */
    private final Vector3 dualU;

    private final Vector3 dualV;
    private final Vector3 normal;
    private final boolean round;
    private final double area;

    private FlatLight(
            Vector3 centre,
            Vector3 sideU,
            Vector3 sideV,
            boolean round,
            Color radiance,
            Falloff falloff,
            int sampleCount) {
        super(radiance, falloff, sampleCount);
        this.centre = Emission.checkedPoint(centre, "centre");
        this.sideU = sideU;
        this.sideV = sideV;
        this.round = round;
        Vector3 cross = sideU.cross(sideV);
        double rectangle = cross.length();
        if (!(rectangle > 0 && rectangle < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException("an area light needs a positive, finite area, but has " + rectangle);
        }
        this.normal = cross.normalized();
        this.dualU = sideV.cross(normal).times(1 / rectangle);
        this.dualV = normal.cross(sideU).times(1 / rectangle);
        this.area = round ? Math.PI * rectangle : 4 * rectangle;
    }

    /** A disc that faces along {@code normal}. */
    public static FlatLight disc(
            Vector3 centre, Vector3 normal, double radius, Color radiance, Falloff falloff, int sampleCount) {
        if (!(radius > 0)) {
            throw new IllegalArgumentException("the radius of a light must be positive, but is " + radius);
        }
        Vector3 unit = normal.normalized();
        Vector3 u = unit.perpendicular();
        Vector3 v = unit.cross(u);
        return new FlatLight(centre, u.times(radius), v.times(radius), true, radiance, falloff, sampleCount);
    }

    /** The parallelogram corner, corner + edgeU, corner + edgeU + edgeV, corner + edgeV; it faces along edgeU × edgeV. */
    public static FlatLight rectangle(
            Vector3 corner, Vector3 edgeU, Vector3 edgeV, Color radiance, Falloff falloff, int sampleCount) {
        Vector3 halfU = edgeU.times(0.5);
        Vector3 halfV = edgeV.times(0.5);
        return new FlatLight(corner.plus(halfU).plus(halfV), halfU, halfV, false, radiance, falloff, sampleCount);
    }

    @Override
    public boolean sample(double x, double y, double z, double s, double t, LightSample sample) {
        LightPoint from = sample.from;
        emitFrom(s, t, from);
        return sample.towards(from.x, from.y, from.z, x, y, z)
                && shine(
                        area,
                        -(sample.directionX * normal.x()
                                + sample.directionY * normal.y()
                                + sample.directionZ * normal.z()),
                        sample);
    }

    @Override
    public void emitFrom(double s, double t, LightPoint point) {
        double a;
        double b;
        if (round) {
            double distance = Math.sqrt(s);
            double angle = 2 * Math.PI * t;
            a = distance * StrictMath.cos(angle);
            b = distance * StrictMath.sin(angle);
        } else {
            a = 2 * s - 1;
            b = 2 * t - 1;
        }
        double lx = centre.x() + a * sideU.x() + b * sideV.x();
        double ly = centre.y() + a * sideU.y() + b * sideV.y();
        double lz = centre.z() + a * sideU.z() + b * sideV.z();
        point.set(lx, ly, lz, normal.x(), normal.y(), normal.z());
    }

    @Override
    double area() {
        return area;
    }

    @Override
    public boolean emitsAlong(Ray ray, Rgb radiance) {
        double against = -(ray.directionX * normal.x() + ray.directionY * normal.y() + ray.directionZ * normal.z());
        if (!(against > 0)) {
            return false;
        }
        double ox = ray.originX - centre.x();
        double oy = ray.originY - centre.y();
        double oz = ray.originZ - centre.z();
        double t = (ox * normal.x() + oy * normal.y() + oz * normal.z()) / against;
        double px = Math.fma(t, ray.directionX, ox);
        double py = Math.fma(t, ray.directionY, oy);
        double pz = Math.fma(t, ray.directionZ, oz);
        return isInside(px, py, pz) && seen(t, ray, radiance);
    }

    /** Whether the point of the light's plane at (x, y, z) from the centre is part of the light. */
    private boolean isInside(double x, double y, double z) {
        double a = x * dualU.x() + y * dualU.y() + z * dualU.z();
        double b = x * dualV.x() + y * dualV.y() + z * dualV.z();
        return round ? a * a + b * b <= 1 : Math.abs(a) <= 1 && Math.abs(b) <= 1;
    }
}
