package org.diacaustic.shape;

import org.diacaustic.math.Arithmetic;
import org.diacaustic.math.Ray;
import org.diacaustic.math.Vector3;

/** Rays and a plane given by a point and a unit normal: what all flat primitives have in common. */
final class FlatSurface {
    private FlatSurface() {}

    /** The t at which the ray meets the plane; infinite or NaN if it is parallel. */
    static double distance(Ray ray, Vector3 point, Vector3 normal) {
        double height = (point.x() - ray.originX) * normal.x()
                + (point.y() - ray.originY) * normal.y()
                + (point.z() - ray.originZ) * normal.z();
        return height / approach(ray, normal);
    }

    /** Direction · normal: negative if the ray comes from the front. */
    static double approach(Ray ray, Vector3 normal) {
        return ray.directionX * normal.x() + ray.directionY * normal.y() + ray.directionZ * normal.z();
    }

    /** Completes the hit: the point of the ray at {@code hit.t}, brought down to the plane. */
    static void complete(Ray ray, Hit hit, Vector3 point, Vector3 normal) {
        double x = ray.pointX(hit.t);
        double y = ray.pointY(hit.t);
        double z = ray.pointZ(hit.t);
        double height = (x - point.x()) * normal.x() + (y - point.y()) * normal.y() + (z - point.z()) * normal.z();
        x = Math.fma(-height, normal.x(), x);
        y = Math.fma(-height, normal.y(), y);
        z = Math.fma(-height, normal.z(), z);
        double magnitude = Math.abs(normal.x()) * (Math.abs(x) + Math.abs(point.x()))
                + Math.abs(normal.y()) * (Math.abs(y) + Math.abs(point.y()))
                + Math.abs(normal.z()) * (Math.abs(z) + Math.abs(point.z()));
        hit.setPoint(x, y, z, Arithmetic.gamma(8) * magnitude);
        hit.setNormal(normal.x(), normal.y(), normal.z());
    }
}
