package org.diacaustic.shape;

import org.diacaustic.math.Arithmetic;
import org.diacaustic.math.Bounds;
import org.diacaustic.math.Ray;
import org.diacaustic.math.Vector3;

/** A sphere. Its inverse mapping is the thesis' spherical one [Thesis 2.4, Eq. 4], pole up and equator along x. */
public final class Sphere implements Shape {
    private final double centreX;
    private final double centreY;
    private final double centreZ;
    private final double radius;

    /**
     * @param radius in scene units, positive and finite
     * @throws IllegalArgumentException otherwise
     */
    public Sphere(Vector3 centre, double radius) {
        if (!(radius > 0 && radius < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException("radius must be positive and finite, but is " + radius);
        }
        if (!centre.isFinite()) {
            throw new IllegalArgumentException("centre must be finite, but is " + centre);
        }
        this.centreX = centre.x();
        this.centreY = centre.y();
        this.centreZ = centre.z();
        this.radius = radius;
    }

    public Vector3 centre() {
        return new Vector3(centreX, centreY, centreZ);
    }

    public double radius() {
        return radius;
    }

    @Override
    public Bounds bounds() {
        return Bounds.around(centre(), radius, radius, radius);
    }

    @Override
    public boolean intersect(Ray ray) {
        ray.tests++;
        double dx = ray.directionX;
        double dy = ray.directionY;
        double dz = ray.directionZ;
        double departure = ray.leaving == Ray.FREE ? 0 : ray.departureError * Arithmetic.length(dx, dy, dz);
        return SphereRoots.intersect(
                ray,
                ray.originX - centreX,
                ray.originY - centreY,
                ray.originZ - centreZ,
                dx,
                dy,
                dz,
                radius,
                departure);
    }

    @Override
    public void complete(Ray ray, Hit hit) {
        double fx = Math.fma(hit.t, ray.directionX, ray.originX - centreX);
        double fy = Math.fma(hit.t, ray.directionY, ray.originY - centreY);
        double fz = Math.fma(hit.t, ray.directionZ, ray.originZ - centreZ);
        double length = Arithmetic.length(fx, fy, fz);
        double largest = Math.max(Math.abs(centreX), Math.max(Math.abs(centreY), Math.abs(centreZ)));
        hit.setPoint(
                Math.fma(radius, fx / length, centreX),
                Math.fma(radius, fy / length, centreY),
                Math.fma(radius, fz / length, centreZ),
                Arithmetic.gamma(6) * (largest + radius));
        // The normal of the point as rounded: a ray that leaves it outward is then outward to intersect too.
        double nx = hit.x - centreX;
        double ny = hit.y - centreY;
        double nz = hit.z - centreZ;
        double normalLength = Arithmetic.length(nx, ny, nz);
        hit.setNormal(nx / normalLength, ny / normalLength, nz / normalLength);
    }

    @Override
    public void inverseMap(Hit hit) {
        SphericalMapping.UPRIGHT.map(hit.normalX, hit.normalY, hit.normalZ, hit);
        SphericalMapping.UPRIGHT.tangents(hit.x - centreX, hit.y - centreY, hit.z - centreZ, hit);
    }

    @Override
    public boolean isClosed() {
        return true;
    }
}
