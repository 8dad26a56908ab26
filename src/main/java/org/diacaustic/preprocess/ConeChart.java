package org.diacaustic.preprocess;

import org.diacaustic.light.LightPoint;
import org.diacaustic.math.Vector3;

/**
 * The rays from a light point into a cone, or into all directions; equal areas of the square are equal solid angles. The
 * square is laid concentrically on a disc [Shirley and Chiu 1997], and the disc by equal areas on the cap of the sphere.
 */
final class ConeChart extends EmissionChart {
    private final Vector3 from;
    private final Vector3 axis;
    private final Vector3 u;
    private final Vector3 v;
    private final double versine;

    /**
     * @param axis of length 1
     * @param versine 1 − cos of the half-angle: 2 for all directions
     */
    ConeChart(LightPoint from, Vector3 axis, double versine) {
        this.from = new Vector3(from.x, from.y, from.z);
        this.axis = axis;
        this.u = axis.perpendicular();
        this.v = axis.cross(u);
        this.versine = versine;
    }

    @Override
    public void aim(double p, double q, LightRay ray) {
        double a = 2 * p - 1;
        double b = 2 * q - 1;
        boolean wide = Math.abs(a) > Math.abs(b);
        double radius = wide ? a : b;
        // At most an eighth of a turn: the rest is symmetry, and needs no reduction of the angle.
        double angle = radius == 0 ? 0 : Math.PI / 4 * (wide ? b / a : a / b);
        double along = StrictMath.cos(angle);
        double across = StrictMath.sin(angle);
        double depth = versine * radius * radius;
        double cosine = 1 - depth;
        double sine = Math.copySign(Math.sqrt(depth * (2 - depth)), radius);
        double s = sine * (wide ? along : across);
        double t = sine * (wide ? across : along);
        ray.setOrigin(from.x(), from.y(), from.z());
        ray.setDirection(
                cosine * axis.x() + s * u.x() + t * v.x(),
                cosine * axis.y() + s * u.y() + t * v.y(),
                cosine * axis.z() + s * u.z() + t * v.z());
        ray.measure = density(p, q);
    }

    @Override
    public double density(double p, double q) {
        return 2 * Math.PI * versine;
    }

    @Override
    public double width() {
        return 1;
    }

    @Override
    public double height() {
        return 1;
    }
}
