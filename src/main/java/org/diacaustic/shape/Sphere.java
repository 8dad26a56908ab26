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
        double fx = ray.originX - centreX;
        double fy = ray.originY - centreY;
        double fz = ray.originZ - centreZ;
        double a = dx * dx + dy * dy + dz * dz;
        double b = -(fx * dx + fy * dy + fz * dz);
        if (ray.leaving != Ray.FREE) {
            // The start is a root; what remains is linear: a·t = 2b, ahead only if the ray goes inward.
            return accept(ray, 2 * b / a);
        }
        // The part of f at right angles to the ray gives the discriminant without cancellation [Haines et al. 2019].
        double along = b / a;
        double px = Math.fma(along, dx, fx);
        double py = Math.fma(along, dy, fy);
        double pz = Math.fma(along, dz, fz);
        double discriminant = a * ((radius * radius) - (px * px + py * py + pz * pz));
        if (!(discriminant >= 0)) {
            return false;
        }
        double distance = Math.sqrt(fx * fx + fy * fy + fz * fz);
        double c = (distance - radius) * (distance + radius);
        double q = b + Math.copySign(Math.sqrt(discriminant), b);
        double near = b > 0 ? c / q : q / a;
        return accept(ray, near) || (near <= 0 && accept(ray, b > 0 ? q / a : c / q));
    }

    private static boolean accept(Ray ray, double t) {
        if (t > 0 && t < ray.tMax) {
            ray.hit(t, 0);
            return true;
        }
        return false;
    }

    @Override
    public void complete(Ray ray, Hit hit) {
        double nx = ray.pointX(hit.t) - centreX;
        double ny = ray.pointY(hit.t) - centreY;
        double nz = ray.pointZ(hit.t) - centreZ;
        double length = Math.sqrt(nx * nx + ny * ny + nz * nz);
        nx /= length;
        ny /= length;
        nz /= length;
        double largest = Math.max(Math.abs(centreX), Math.max(Math.abs(centreY), Math.abs(centreZ)));
        hit.setPoint(
                Math.fma(radius, nx, centreX),
                Math.fma(radius, ny, centreY),
                Math.fma(radius, nz, centreZ),
                Arithmetic.gamma(6) * (largest + radius));
        hit.setNormal(nx, ny, nz);
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
