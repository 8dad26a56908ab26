package org.diacaustic.shape;

import org.diacaustic.math.Arithmetic;
import org.diacaustic.math.Bounds;
import org.diacaustic.math.Ray;
import org.diacaustic.math.Vector3;

/**
 * An ellipsoid with its axes along x, y and z: of all quadrics the one with an intersection of its own [Thesis 2.5].
 * Measured in its radii it is the unit sphere, so none of the quadric's products remain. Its inverse mapping is the
 * spherical one of that unit sphere.
 */
public final class Ellipsoid implements Shape {
    /** Newton steps from a rounded distance; of a flat ellipsoid the first is a long one in its shortest radius. */
    private static final int MOST_STEPS = 4;

    private final double centreX;
    private final double centreY;
    private final double centreZ;
    private final double radiusX;
    private final double radiusY;
    private final double radiusZ;
    private final double smallestRadius;
    private final double pointError;

    /**
     * @param radii the three half axes in scene units, positive and finite
     * @throws IllegalArgumentException otherwise
     */
    public Ellipsoid(Vector3 centre, Vector3 radii) {
        if (!(radii.isFinite() && radii.x() > 0 && radii.y() > 0 && radii.z() > 0)) {
            throw new IllegalArgumentException("radii must be positive and finite, but are " + radii);
        }
        if (!centre.isFinite()) {
            throw new IllegalArgumentException("centre must be finite, but is " + centre);
        }
        this.centreX = centre.x();
        this.centreY = centre.y();
        this.centreZ = centre.z();
        this.radiusX = radii.x();
        this.radiusY = radii.y();
        this.radiusZ = radii.z();
        this.smallestRadius = Math.min(radiusX, Math.min(radiusY, radiusZ));
        double reach = Math.max(
                Math.abs(centreX) + radiusX, Math.max(Math.abs(centreY) + radiusY, Math.abs(centreZ) + radiusZ));
        this.pointError = Arithmetic.gamma(8) * reach;
    }

    public Vector3 centre() {
        return new Vector3(centreX, centreY, centreZ);
    }

    public Vector3 radii() {
        return new Vector3(radiusX, radiusY, radiusZ);
    }

    @Override
    public Bounds bounds() {
        return Bounds.around(centre(), radiusX, radiusY, radiusZ);
    }

    @Override
    public boolean intersect(Ray ray) {
        ray.tests++;
        double departure = ray.leaving == Ray.FREE
                ? 0
                : ray.departureError
                        * Arithmetic.length(ray.directionX, ray.directionY, ray.directionZ)
                        / smallestRadius;
        return SphereRoots.intersect(
                ray,
                (ray.originX - centreX) / radiusX,
                (ray.originY - centreY) / radiusY,
                (ray.originZ - centreZ) / radiusZ,
                ray.directionX / radiusX,
                ray.directionY / radiusY,
                ray.directionZ / radiusZ,
                1,
                departure);
    }

    @Override
    public void complete(Ray ray, Hit hit) {
        double fx = Math.fma(hit.t, ray.directionX, ray.originX - centreX) / radiusX;
        double fy = Math.fma(hit.t, ray.directionY, ray.originY - centreY) / radiusY;
        double fz = Math.fma(hit.t, ray.directionZ, ray.originZ - centreZ) / radiusZ;
        // Newton steps along the ray, where the hit is; but not if it grazes, for then a step may be large.
        double dx = ray.directionX / radiusX;
        double dy = ray.directionY / radiusY;
        double dz = ray.directionZ / radiusZ;
        double depth = 1 - (fx * fx + fy * fy + fz * fz);
        for (int i = 0; i < MOST_STEPS && Math.abs(depth) > Arithmetic.gamma(8); i++) {
            double further = depth / (2 * (fx * dx + fy * dy + fz * dz));
            if (!(Math.abs(further) < 0x1p-30 * hit.t)) {
                break;
            }
            fx = Math.fma(further, dx, fx);
            fy = Math.fma(further, dy, fy);
            fz = Math.fma(further, dz, fz);
            depth = 1 - (fx * fx + fy * fy + fz * fz);
        }
        // What remains goes along the normal, which for a flat ellipsoid is not the way to the centre.
        double mx = smallestRadius / radiusX;
        double my = smallestRadius / radiusY;
        double mz = smallestRadius / radiusZ;
        if (Math.abs(depth) > Arithmetic.gamma(8)) {
            double slope = fx * fx * (mx * mx) + fy * fy * (my * my) + fz * fz * (mz * mz);
            double step = depth / (2 * slope);
            fx = Math.fma(step * mx * mx, fx, fx);
            fy = Math.fma(step * my * my, fy, fy);
            fz = Math.fma(step * mz * mz, fz, fz);
        }
        double length = Math.sqrt(fx * fx + fy * fy + fz * fz);
        hit.setPoint(
                Math.fma(radiusX, fx / length, centreX),
                Math.fma(radiusY, fy / length, centreY),
                Math.fma(radiusZ, fz / length, centreZ),
                pointError);
        // The gradient is f / radius; times the smallest radius no component can overflow. It is that of the point as
        // rounded: a ray that leaves it outward is then outward to intersect too.
        double nx = (hit.x - centreX) / radiusX * mx;
        double ny = (hit.y - centreY) / radiusY * my;
        double nz = (hit.z - centreZ) / radiusZ * mz;
        double normalLength = Arithmetic.length(nx, ny, nz);
        hit.setNormal(nx / normalLength, ny / normalLength, nz / normalLength);
    }

    @Override
    public void inverseMap(Hit hit) {
        double fx = (hit.x - centreX) / radiusX;
        double fy = (hit.y - centreY) / radiusY;
        double fz = (hit.z - centreZ) / radiusZ;
        SphericalMapping.UPRIGHT.map(fx, fy, fz, hit);
        SphericalMapping.UPRIGHT.tangents(fx, fy, fz, hit);
        hit.setTangents(
                radiusX * hit.tangentUX,
                radiusY * hit.tangentUY,
                radiusZ * hit.tangentUZ,
                radiusX * hit.tangentVX,
                radiusY * hit.tangentVY,
                radiusZ * hit.tangentVZ);
    }

    @Override
    public boolean isClosed() {
        return true;
    }
}
