package org.diacaustic.shape;

import org.diacaustic.math.Arithmetic;
import org.diacaustic.math.Bounds;
import org.diacaustic.math.Quartic;
import org.diacaustic.math.Ray;
import org.diacaustic.math.Vector3;

/**
 * A ring torus. Its map goes once around the axis with u and once around the tube with v, from the outer equator over
 * the top, so no two points share their coordinates as they would in the spherical mapping [Thesis 2.4].
 *
 * <p>Rays are measured in a power of two near the major radius, which changes no digit, and, if they start outside the bounding sphere, from their point nearest the
 * centre: then all coefficients of the quartic are of the order of 1, from however far the ray comes.
 */
public final class Torus implements Shape {
    /** Newton steps on a root: one is enough, but for two that lie close together. */
    private static final int MOST_STEPS = 8;

    private final AxisFrame frame;
    private final double majorRadius;
    private final double minorRadius;
    /** The power of two that all lengths are divided by while roots are looked for. */
    private final double scale;

    private final double ringRadius;
    private final double tube;
    private final double sharpest;
    private final Bounds bounds;
    private final double pointError;

    /**
     * @param axis of any length
     * @param majorRadius from the centre to the middle of the tube, in scene units
     * @param minorRadius of the tube, positive and smaller than the major one
     * @throws IllegalArgumentException otherwise, or if something is not finite
     */
    public Torus(Vector3 centre, Vector3 axis, double majorRadius, double minorRadius) {
        if (!(minorRadius > 0 && minorRadius < majorRadius && majorRadius < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException("radii of a torus must obey 0 < minor < major and be finite, but are "
                    + minorRadius + " and " + majorRadius);
        }
        if (!centre.isFinite()) {
            throw new IllegalArgumentException("centre must be finite, but is " + centre);
        }
        this.frame = new AxisFrame(centre, axis);
        this.majorRadius = majorRadius;
        this.minorRadius = minorRadius;
        this.scale = Arithmetic.powerOfTwoNear(majorRadius);
        this.ringRadius = majorRadius / scale;
        this.tube = minorRadius / scale;
        this.sharpest = Math.max(1 / tube, 1 / (ringRadius - tube));
        this.pointError = Arithmetic.gamma(24) * (AxisFrame.largest(centre) + majorRadius + minorRadius);
        this.bounds = AxisFrame.discBounds(centre, frame.up, majorRadius, minorRadius + pointError);
    }

    @Override
    public Bounds bounds() {
        return bounds;
    }

    /** With p = f + τ·d, the torus is (|p|² + R² − r²)² = 4·R²·|p⊥|². */
    @Override
    public boolean intersect(Ray ray) {
        ray.tests++;
        double length = Arithmetic.length(ray.directionX, ray.directionY, ray.directionZ);
        double dx = ray.directionX / length;
        double dy = ray.directionY / length;
        double dz = ray.directionZ / length;
        double fx = frame.originX(ray) / scale;
        double fy = frame.originY(ray) / scale;
        double fz = frame.originZ(ray) / scale;
        double unit = scale / length;
        if (ray.leaving != Ray.FREE) {
            return leave(ray, fx, fy, fz, dx, dy, dz, unit);
        }
        double reach = ringRadius + tube;
        double start = 0;
        if (fx * fx + fy * fy + fz * fz > reach * reach) {
            start = -(fx * dx + fy * dy + fz * dz);
            fx = Math.fma(start, dx, fx);
            fy = Math.fma(start, dy, fy);
            fz = Math.fma(start, dz, fz);
            if (start <= -reach || fx * fx + fy * fy + fz * fz > reach * reach) {
                return false;
            }
        }
        return meet(ray, fx, fy, fz, dx, dy, dz, start, unit);
    }

    private boolean meet(
            Ray ray, double fx, double fy, double fz, double dx, double dy, double dz, double start, double unit) {
        double f1 = frame.acrossOf(fx, fy, fz);
        double f2 = frame.asideOf(fx, fy, fz);
        double f3 = frame.upOf(fx, fy, fz);
        double d1 = frame.acrossOf(dx, dy, dz);
        double d2 = frame.asideOf(dx, dy, dz);
        double d3 = frame.upOf(dx, dy, dz);
        double ff = f1 * f1 + f2 * f2;
        double along = f1 * d1 + f2 * d2 + f3 * d3;
        double ring = Math.sqrt(ff);
        double g = ff + f3 * f3 + (ringRadius - tube) * (ringRadius + tube);
        double twice = 2 * ringRadius;
        // (g − 2·R·ring)·(g + 2·R·ring), the first factor in the form that does not cancel near the surface.
        double constant = offTube(ring, f3) * (g + twice * ring);
        double linear = 4 * along * g - 2 * twice * twice * (f1 * d1 + f2 * d2);
        double square = 4 * along * along + 2 * g - twice * twice * (d1 * d1 + d2 * d2);
        // A little beyond the bounding sphere, where the sign is certain.
        double reach = 1.0625 * (ringRadius + tube);
        int count = Quartic.solve(1, 4 * along, square, linear, constant, -along - reach, -along + reach, ray.roots);
        for (int i = 0; i < count; i++) {
            if (accept(ray, (start + corrected(f1, f2, f3, d1, d2, d3, ray.roots[i])) * unit)) {
                return true;
            }
        }
        return false;
    }

    /** Newton steps on the distance from the middle of the tube, which keeps digits that the quartic has lost. */
    private double corrected(double f1, double f2, double f3, double d1, double d2, double d3, double root) {
        double better = root;
        for (int i = 0; i < MOST_STEPS; i++) {
            double p1 = Math.fma(better, d1, f1);
            double p2 = Math.fma(better, d2, f2);
            double p3 = Math.fma(better, d3, f3);
            double ring = Math.sqrt(p1 * p1 + p2 * p2);
            double slope = 2 * ((ring - ringRadius) / ring * (p1 * d1 + p2 * d2) + p3 * d3);
            double next = better - offTube(ring, p3) / slope;
            if (!(Math.abs(next - root) < 0x1p-20)) {
                return root;
            }
            boolean settled = Math.abs(next - better) <= Math.ulp(ringRadius);
            better = next;
            if (settled) {
                break;
            }
        }
        return better;
    }

    /** The squared distance from the middle of the tube, less that of the surface, without cancellation near the surface. */
    private double offTube(double ring, double height) {
        return (ring - ringRadius) * (ring - ringRadius) + (height - tube) * (height + tube);
    }

    /** The start is a root; a cubic remains. If the ray goes along the surface it is a double one: a quadratic remains. */
    private boolean leave(Ray ray, double fx, double fy, double fz, double dx, double dy, double dz, double unit) {
        double f1 = frame.acrossOf(fx, fy, fz);
        double f2 = frame.asideOf(fx, fy, fz);
        double f3 = frame.upOf(fx, fy, fz);
        double d1 = frame.acrossOf(dx, dy, dz);
        double d2 = frame.asideOf(dx, dy, dz);
        double d3 = frame.upOf(dx, dy, dz);
        double ff = f1 * f1 + f2 * f2;
        double along = f1 * d1 + f2 * d2 + f3 * d3;
        double ring = Math.sqrt(ff);
        double g = ff + f3 * f3 + (ringRadius - tube) * (ringRadius + tube);
        double square = 4 * along * along + 2 * g - 4 * ringRadius * ringRadius * (d1 * d1 + d2 * d2);
        // The direction against the gradient: 8·R·ring·r·(normal · direction).
        double linear = 8 * ringRadius * ((ring - ringRadius) * (f1 * d1 + f2 * d2) + ring * f3 * d3);
        double slack = 8 * ringRadius * ring * tube * sharpest * (Arithmetic.gamma(32) + ray.departureError / unit);
        double reach = 1.0625 * (ringRadius + tube);
        if (Math.abs(linear) <= slack) {
            linear = 0;
        }
        int count = linear == 0
                ? Quartic.solveCubic(0, 1, 4 * along, square, 0, -along + reach, ray.roots)
                : Quartic.solveCubic(1, 4 * along, square, linear, 0, -along + reach, ray.roots);
        if (count == 0) {
            return false;
        }
        double better = corrected(f1, f2, f3, d1, d2, d3, ray.roots[0]);
        // Near the start, steps could lead back to it.
        double root = better > ray.roots[0] / 2 ? better : ray.roots[0];
        return accept(ray, Math.max(root * unit, Double.MIN_VALUE));
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
        double x = Math.fma(hit.t, ray.directionX, frame.originX(ray));
        double y = Math.fma(hit.t, ray.directionY, frame.originY(ray));
        double z = Math.fma(hit.t, ray.directionZ, frame.originZ(ray));
        double a = frame.acrossOf(x, y, z);
        double b = frame.asideOf(x, y, z);
        double h = frame.upOf(x, y, z);
        double ring = Math.sqrt(a * a + b * b);
        double out = ring - majorRadius;
        double scale = minorRadius / Math.sqrt(out * out + h * h);
        double outward = (majorRadius + scale * out) / ring;
        frame.setPoint(hit, outward * a, outward * b, scale * h, pointError);
        // The normal of the point as rounded: a ray that leaves it outward is then outward to intersect too.
        double px = hit.x - frame.origin.x();
        double py = hit.y - frame.origin.y();
        double pz = hit.z - frame.origin.z();
        a = frame.acrossOf(px, py, pz);
        b = frame.asideOf(px, py, pz);
        ring = Math.sqrt(a * a + b * b);
        out = (ring - majorRadius) / ring;
        frame.setNormal(hit, out * a, out * b, frame.upOf(px, py, pz));
    }

    @Override
    public void inverseMap(Hit hit) {
        double x = hit.x - frame.origin.x();
        double y = hit.y - frame.origin.y();
        double z = hit.z - frame.origin.z();
        double a = frame.acrossOf(x, y, z);
        double b = frame.asideOf(x, y, z);
        double h = frame.upOf(x, y, z);
        double ring = Math.sqrt(a * a + b * b);
        double out = ring - majorRadius;
        hit.setMap(AxisFrame.turn(a, b), AxisFrame.turn(out, h));
        double turn = 2 * Math.PI;
        double inward = -turn * h / ring;
        frame.setTangents(hit, -turn * b, turn * a, 0, inward * a, inward * b, turn * out);
    }

    @Override
    public boolean isClosed() {
        return true;
    }
}
