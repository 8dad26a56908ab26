package org.diacaustic.shape;

import org.diacaustic.math.Arithmetic;
import org.diacaustic.math.Bounds;
import org.diacaustic.math.Matrix;
import org.diacaustic.math.Quadratic;
import org.diacaustic.math.Ray;
import org.diacaustic.math.Vector3;

/**
 * Any surface of second degree, a·x² + 2b·xy + 2c·xz + 2d·x + e·y² + 2f·yz + 2g·y + h·z² + 2i·z + j = 0 [Thesis 2.5],
 * whole or only the part of it within a box. Outward is where the left side grows; of an ellipsoid given inside out all
 * signs are changed first, so that outward is out of it. Its inverse mapping is the spherical one about the middle of its
 * bounds, or about the origin if it has none.
 *
 * <p>In the code the left side is p·Qp + 2·l·p + j.
 */
public final class Quadric implements Shape {
    private final Matrix q;
    private final Matrix sizes;
    private final Vector3 l;
    private final double j;
    private final Bounds clip;
    private final Bounds bounds;
    private final boolean closed;
    private final SphericalMapping mapping;

    private Quadric(Matrix q, Vector3 l, double j, Bounds clip) {
        this.q = q;
        this.sizes = q.absolute();
        this.l = l;
        this.j = j;
        this.clip = clip;
        Bounds whole = QuadricBounds.of(q, l, j);
        this.closed = whole.isFinite()
                && clip.contains(whole.minX(), whole.minY(), whole.minZ())
                && clip.contains(whole.maxX(), whole.maxY(), whole.maxZ());
        this.bounds = whole.intersection(clip);
        this.mapping = new SphericalMapping(
                bounds.isFinite() ? bounds.centre() : Vector3.ZERO, Vector3.UNIT_Y, Vector3.UNIT_X);
    }

    /**
     * The whole surface.
     *
     * @param coefficients the ten numbers a to j
     * @throws IllegalArgumentException if they are not ten finite numbers, or all but the last are zero, or no point
     *     satisfies the equation
     */
    public static Quadric of(double... coefficients) {
        if (coefficients.length != 10) {
            throw new IllegalArgumentException("a quadric has 10 coefficients, but was given " + coefficients.length);
        }
        boolean empty = true;
        for (int k = 0; k < 10; k++) {
            if (!Double.isFinite(coefficients[k])) {
                throw new IllegalArgumentException("coefficient " + "abcdefghij".charAt(k)
                        + " of a quadric must be finite, but is " + coefficients[k]);
            }
            empty &= k == 9 || coefficients[k] == 0;
        }
        if (empty) {
            throw new IllegalArgumentException("a quadric needs a coefficient besides j that is not zero");
        }
        double[] k = coefficients;
        Matrix q = new Matrix(k[0], k[1], k[2], k[1], k[4], k[5], k[2], k[5], k[7]);
        Vector3 l = new Vector3(k[3], k[6], k[8]);
        if (QuadricBounds.isNegativeDefinite(q)) {
            return new Quadric(q.times(Matrix.diagonal(-1, -1, -1)), l.negated(), -k[9], Bounds.UNBOUNDED);
        }
        return new Quadric(q, l, k[9], Bounds.UNBOUNDED);
    }

    /**
     * The part of this surface that lies within a box. It is open, unless the box holds all of it.
     *
     * @throws IllegalArgumentException if the box is empty
     */
    public Quadric within(Bounds box) {
        if (box.isEmpty()) {
            throw new IllegalArgumentException("the box that clips a quadric must not be empty, but is " + box);
        }
        return new Quadric(q, l, j, box);
    }

    @Override
    public Bounds bounds() {
        return bounds;
    }

    @Override
    public boolean intersect(Ray ray) {
        ray.tests++;
        double dx = ray.directionX;
        double dy = ray.directionY;
        double dz = ray.directionZ;
        if (ray.leaving != Ray.FREE) {
            return leave(ray, dx, dy, dz);
        }
        // From where the ray enters the bounds the products keep digits that they would lose from far away.
        double start = bounds == Bounds.UNBOUNDED ? 0 : BoxEntry.of(bounds, ray);
        if (!(start < ray.tMax)) {
            return false;
        }
        double x = ray.pointX(start);
        double y = ray.pointY(start);
        double z = ray.pointZ(start);
        double gx = q.timesX(x, y, z) + l.x();
        double gy = q.timesY(x, y, z) + l.y();
        double gz = q.timesZ(x, y, z) + l.z();
        double a = dx * q.timesX(dx, dy, dz) + dy * q.timesY(dx, dy, dz) + dz * q.timesZ(dx, dy, dz);
        double b = -(dx * gx + dy * gy + dz * gz);
        double c = x * (gx + l.x()) + y * (gy + l.y()) + z * (gz + l.z()) + j;
        int count = Quadratic.solveHalf(a, b, c, ray.roots);
        return count > 0 && accept(ray, start + ray.roots[0]) || count > 1 && accept(ray, start + ray.roots[1]);
    }

    /** The start is a root; what remains is a·t = 2b. A ray along the surface within rounding has both roots there. */
    private boolean leave(Ray ray, double dx, double dy, double dz) {
        double x = ray.originX;
        double y = ray.originY;
        double z = ray.originZ;
        double qdx = q.timesX(dx, dy, dz);
        double qdy = q.timesY(dx, dy, dz);
        double qdz = q.timesZ(dx, dy, dz);
        double a = dx * qdx + dy * qdy + dz * qdz;
        double b = -(dx * (q.timesX(x, y, z) + l.x())
                + dy * (q.timesY(x, y, z) + l.y())
                + dz * (q.timesZ(x, y, z) + l.z()));
        double ax = Math.abs(x);
        double ay = Math.abs(y);
        double az = Math.abs(z);
        double rounding = Arithmetic.gamma(16)
                * (Math.abs(dx) * (sizes.timesX(ax, ay, az) + Math.abs(l.x()))
                        + Math.abs(dy) * (sizes.timesY(ax, ay, az) + Math.abs(l.y()))
                        + Math.abs(dz) * (sizes.timesZ(ax, ay, az) + Math.abs(l.z())));
        double departure = ray.departureError * Arithmetic.length(dx, dy, dz) * Arithmetic.length(qdx, qdy, qdz);
        return Math.abs(b) > rounding + departure && accept(ray, 2 * b / a);
    }

    private boolean accept(Ray ray, double t) {
        if (t > 0 && t < ray.tMax && (closed || clip.contains(ray.pointX(t), ray.pointY(t), ray.pointZ(t)))) {
            ray.hit(t, 0);
            return true;
        }
        return false;
    }

    @Override
    public void complete(Ray ray, Hit hit) {
        double x = ray.pointX(hit.t);
        double y = ray.pointY(hit.t);
        double z = ray.pointZ(hit.t);
        double gx = q.timesX(x, y, z) + l.x();
        double gy = q.timesY(x, y, z) + l.y();
        double gz = q.timesZ(x, y, z) + l.z();
        double squared = gx * gx + gy * gy + gz * gz;
        double value = x * (gx + l.x()) + y * (gy + l.y()) + z * (gz + l.z()) + j;
        // One Newton step along the gradient; none at the tip of a cone.
        double step = squared > 0 ? -value / (2 * squared) : 0;
        x = Math.fma(step, gx, x);
        y = Math.fma(step, gy, y);
        z = Math.fma(step, gz, z);
        double error = pointError(x, y, z, Math.abs(step) * Math.sqrt(squared));
        double insideX = Arithmetic.clamp(x, bounds.minX(), bounds.maxX());
        double insideY = Arithmetic.clamp(y, bounds.minY(), bounds.maxY());
        double insideZ = Arithmetic.clamp(z, bounds.minZ(), bounds.maxZ());
        error += Arithmetic.length(insideX - x, insideY - y, insideZ - z);
        x = insideX;
        y = insideY;
        z = insideZ;
        hit.setPoint(x, y, z, error);
        gx = q.timesX(x, y, z) + l.x();
        gy = q.timesY(x, y, z) + l.y();
        gz = q.timesZ(x, y, z) + l.z();
        double length = Arithmetic.length(gx, gy, gz);
        if (length > 0) {
            hit.setNormal(gx / length, gy / length, gz / length);
        } else {
            double back = -Arithmetic.length(ray.directionX, ray.directionY, ray.directionZ);
            hit.setNormal(ray.directionX / back, ray.directionY / back, ray.directionZ / back);
        }
    }

    /** The rounding of the left side ÷ its slope, or where it has none, by its curvature. */
    private double pointError(double x, double y, double z, double step) {
        double ax = Math.abs(x);
        double ay = Math.abs(y);
        double az = Math.abs(z);
        double size = ax * (sizes.timesX(ax, ay, az) + 2 * Math.abs(l.x()))
                + ay * (sizes.timesY(ax, ay, az) + 2 * Math.abs(l.y()))
                + az * (sizes.timesZ(ax, ay, az) + 2 * Math.abs(l.z()))
                + Math.abs(j);
        double slope =
                Arithmetic.length(q.timesX(x, y, z) + l.x(), q.timesY(x, y, z) + l.y(), q.timesZ(x, y, z) + l.z());
        double rounding = Arithmetic.gamma(16) * size;
        double bySlope = (rounding + step * step * q.norm()) / slope;
        double byCurvature = 2 * Math.sqrt(rounding / q.norm());
        return (bySlope <= byCurvature ? bySlope : byCurvature) + Arithmetic.gamma(4) * Arithmetic.length(x, y, z);
    }

    @Override
    public void inverseMap(Hit hit) {
        mapping.map(hit);
    }

    @Override
    public boolean isClosed() {
        return closed;
    }
}
