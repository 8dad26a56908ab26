package org.diacaustic.shape;

import org.diacaustic.math.Arithmetic;
import org.diacaustic.math.Bounds;
import org.diacaustic.math.Ray;
import org.diacaustic.math.Vector3;

/**
 * A flat disc, or the ring between two circles, visible from both sides. Its map is the square around it, turned like
 * the map of the {@link Plane} that it lies in.
 */
public final class Disc implements Shape {
    private final Vector3 centre;
    private final Vector3 normal;
    private final double innerRadius;
    private final double outerRadius;
    private final Bounds bounds;
    private final PlanarMapping mapping;

    /** A whole disc; otherwise as the ring. */
    public Disc(Vector3 centre, Vector3 normal, double radius) {
        this(centre, normal, 0, radius);
    }

    /**
     * @param normal the outward direction, of any length
     * @param innerRadius of the hole, 0 for none
     * @param outerRadius in scene units
     * @throws IllegalArgumentException unless 0 ≤ innerRadius &lt; outerRadius and all is finite, the normal not zero
     */
    public Disc(Vector3 centre, Vector3 normal, double innerRadius, double outerRadius) {
        if (!(innerRadius >= 0 && innerRadius < outerRadius && outerRadius < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException("radii of a disc must obey 0 ≤ inner < outer and be finite, but are "
                    + innerRadius + " and " + outerRadius);
        }
        Plane plane = new Plane(centre, normal);
        this.centre = centre;
        this.normal = plane.normal();
        this.innerRadius = innerRadius;
        this.outerRadius = outerRadius;
        this.bounds = AxisFrame.discBounds(
                centre, this.normal, outerRadius, Arithmetic.gamma(16) * (AxisFrame.largest(centre) + outerRadius));
        Vector3 u = plane.mapAxisU().times(outerRadius);
        Vector3 v = plane.mapAxisV().times(outerRadius);
        this.mapping = new PlanarMapping(centre.minus(u).minus(v), u.times(2), v.times(2));
    }

    public Vector3 centre() {
        return centre;
    }

    /** The outward normal, of length 1. */
    public Vector3 normal() {
        return normal;
    }

    public double outerRadius() {
        return outerRadius;
    }

    @Override
    public Bounds bounds() {
        return bounds;
    }

    @Override
    public boolean intersect(Ray ray) {
        ray.tests++;
        if (ray.leaving != Ray.FREE) {
            return false;
        }
        double t = FlatSurface.distance(ray, centre, normal);
        if (!(t > 0 && t < ray.tMax)) {
            return false;
        }
        double x = Math.fma(t, ray.directionX, ray.originX - centre.x());
        double y = Math.fma(t, ray.directionY, ray.originY - centre.y());
        double z = Math.fma(t, ray.directionZ, ray.originZ - centre.z());
        double squared = x * x + y * y + z * z;
        if (squared > outerRadius * outerRadius || squared < innerRadius * innerRadius) {
            return false;
        }
        ray.hit(t, 0);
        return true;
    }

    @Override
    public void complete(Ray ray, Hit hit) {
        FlatSurface.complete(ray, hit, centre, normal);
    }

    @Override
    public void inverseMap(Hit hit) {
        mapping.mapWithin(hit);
    }

    @Override
    public boolean isClosed() {
        return false;
    }
}
