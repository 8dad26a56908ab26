package org.diacaustic.shape;

import org.diacaustic.math.Bounds;
import org.diacaustic.math.Ray;
import org.diacaustic.math.Vector3;

/**
 * An infinite plane, visible from both sides.
 *
 * <p>Its map repeats with every scene unit from its point. u runs along the x axis projected on the plane (along the z
 * axis if the normal is within 37° of x), v along normal × u: on a floor whose normal is +y, u is x and v is −z.
 */
public final class Plane implements Shape {
    private final Vector3 point;
    private final Vector3 normal;
    private final Vector3 mapAxisU;
    private final Vector3 mapAxisV;
    private final PlanarMapping mapping;

    /**
     * @param point any point of the plane
     * @param normal its outward direction, of any length
     * @throws IllegalArgumentException if the point is not finite, or the normal zero or not finite
     */
    public Plane(Vector3 point, Vector3 normal) {
        if (!point.isFinite()) {
            throw new IllegalArgumentException("point of a plane must be finite, but is " + point);
        }
        if (!normal.isFinite() || normal.equals(Vector3.ZERO) || normal.length() == 0) {
            throw new IllegalArgumentException("normal of a plane must be finite and not zero, but is " + normal);
        }
        this.point = point;
        this.normal = normal.normalized();
        Vector3 axis = Math.abs(this.normal.x()) < 0.8 ? Vector3.UNIT_X : Vector3.UNIT_Z;
        this.mapAxisV = this.normal.cross(axis).normalized();
        this.mapAxisU = mapAxisV.cross(this.normal);
        this.mapping = new PlanarMapping(point, mapAxisU, mapAxisV);
    }

    public Vector3 point() {
        return point;
    }

    /** The outward normal, of length 1. */
    public Vector3 normal() {
        return normal;
    }

    Vector3 mapAxisU() {
        return mapAxisU;
    }

    Vector3 mapAxisV() {
        return mapAxisV;
    }

    @Override
    public Bounds bounds() {
        return Bounds.UNBOUNDED;
    }

    @Override
    public boolean intersect(Ray ray) {
        ray.tests++;
        if (ray.leaving != Ray.FREE) {
            return false;
        }
        double t = FlatSurface.distance(ray, point, normal);
        if (t > 0 && t < ray.tMax) {
            ray.hit(t, 0);
            return true;
        }
        return false;
    }

    @Override
    public void complete(Ray ray, Hit hit) {
        FlatSurface.complete(ray, hit, point, normal);
    }

    @Override
    public void inverseMap(Hit hit) {
        mapping.map(hit);
    }

    @Override
    public boolean isClosed() {
        return false;
    }
}
