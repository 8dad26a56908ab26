package org.diacaustic.shape;

import org.diacaustic.math.Arithmetic;
import org.diacaustic.math.Bounds;
import org.diacaustic.math.Ray;
import org.diacaustic.math.Vector3;

/**
 * A cylinder, a cone or a cone without its tip, from a base to a top; capped, and then solid, or an open sheet. Its
 * primitives are the side and the caps at base and top.
 *
 * <p>The map goes once around with u. v follows the outline from 0 to 1 by its length: up the side, and of a capped one
 * first out from the middle of the base and last in to the middle of the top; so no two points share their coordinates.
 */
public final class Frustum implements Shape {
    private static final int SIDE = 0;
    private static final int BASE = 1;
    private static final int TOP = 2;

    private final AxisFrame frame;
    private final double height;
    private final double baseRadius;
    private final double topRadius;
    private final double widening;
    private final double slant;
    private final boolean capped;
    private final Bounds bounds;
    private final double pointError;
    private final double size;

    private Frustum(Vector3 base, double baseRadius, Vector3 top, double topRadius, boolean capped) {
        if (!(base.isFinite() && top.isFinite()) || base.equals(top)) {
            throw new IllegalArgumentException(
                    "base and top must be finite and apart, but are " + base + " and " + top);
        }
        boolean finite = Double.isFinite(baseRadius) && Double.isFinite(topRadius);
        if (!(finite && baseRadius >= 0 && topRadius >= 0 && baseRadius + topRadius > 0)) {
            throw new IllegalArgumentException("radii must be finite, not negative and not both zero, but are "
                    + baseRadius + " and " + topRadius);
        }
        Vector3 axis = top.minus(base);
        this.frame = new AxisFrame(base, axis);
        this.height = axis.length();
        this.baseRadius = baseRadius;
        this.topRadius = topRadius;
        this.widening = (topRadius - baseRadius) / height;
        this.slant = Math.sqrt(1 + widening * widening);
        this.capped = capped;
        this.size = height + baseRadius + topRadius;
        this.pointError = Arithmetic.gamma(16) * (AxisFrame.largest(base) + size);
        this.bounds = AxisFrame.discBounds(base, frame.up, baseRadius, pointError)
                .union(AxisFrame.discBounds(top, frame.up, topRadius, pointError));
    }

    /**
     * A cylinder.
     *
     * @param capped whether it is closed by discs at both ends
     * @throws IllegalArgumentException unless the ends are finite and apart and the radius positive and finite
     */
    public static Frustum cylinder(Vector3 base, Vector3 top, double radius, boolean capped) {
        return new Frustum(base, radius, top, radius, capped);
    }

    /** A cone; otherwise as {@link #cylinder}. */
    public static Frustum cone(Vector3 base, double radius, Vector3 tip, boolean capped) {
        return new Frustum(base, radius, tip, 0, capped);
    }

    /** A cone without its tip; otherwise as {@link #cylinder}. */
    public static Frustum between(Vector3 base, double baseRadius, Vector3 top, double topRadius, boolean capped) {
        return new Frustum(base, baseRadius, top, topRadius, capped);
    }

    @Override
    public Bounds bounds() {
        return bounds;
    }

    /**
     * The side is |f⊥ + t·d⊥| = ρ + t·s, where ρ is the radius at the height of the origin and s how fast it widens
     * along the ray: a·t² − 2b·t + c = 0.
     */
    @Override
    public boolean intersect(Ray ray) {
        ray.tests++;
        double ox = frame.originX(ray);
        double oy = frame.originY(ray);
        double oz = frame.originZ(ray);
        double f1 = frame.acrossOf(ox, oy, oz);
        double f2 = frame.asideOf(ox, oy, oz);
        double f3 = frame.upOf(ox, oy, oz);
        double d1 = frame.acrossOf(ray.directionX, ray.directionY, ray.directionZ);
        double d2 = frame.asideOf(ray.directionX, ray.directionY, ray.directionZ);
        double d3 = frame.upOf(ray.directionX, ray.directionY, ray.directionZ);
        double radius = Math.fma(widening, f3, baseRadius);
        double s = widening * d3;
        double dd = d1 * d1 + d2 * d2;
        double a = widening == 0 ? dd : Arithmetic.differenceOfProducts(1, dd, s, s);
        double b = radius * s - (f1 * d1 + f2 * d2);
        if (ray.leaving == SIDE) {
            double length = Math.sqrt(dd + d3 * d3);
            boolean atTip = a < 0 && s > 0 && radius * length < 4 * slack(ray, length);
            return leaveSide(ray, a, b, f3, d3, atTip ? -slack(ray, length) : slack(ray, length));
        }
        // b² − a·c without its cancellation: |ρ·d⊥ − s·f⊥|² − (f⊥ × d⊥)².
        double w1 = radius * d1 - s * f1;
        double w2 = radius * d2 - s * f2;
        double cross = Math.abs(Arithmetic.differenceOfProducts(f1, d2, f2, d1));
        double w = Math.sqrt(w1 * w1 + w2 * w2);
        double discriminant = (w - cross) * (w + cross);
        if (ray.leaving != Ray.FREE) {
            // On a cap the start is within the side, whatever rounding says.
            discriminant = Math.max(discriminant, 0);
        }
        if (!(discriminant >= 0)) {
            return false;
        }
        double fromAxis = Math.sqrt(f1 * f1 + f2 * f2);
        double c = (fromAxis - radius) * (fromAxis + radius);
        if (ray.leaving != Ray.FREE) {
            c = Math.min(c, 0);
        }
        double q = b + Math.copySign(Math.sqrt(discriminant), b);
        double one = a == 0 ? Double.NaN : q / a;
        double other = q == 0 ? one : c / q;
        return capped
                ? meetSolid(ray, a, s, c, one, other, f3, d3)
                : meetSide(ray, Math.min(one, other), f3, d3)
                        || meetSide(ray, Math.max(one, other), f3, d3)
                        || (a == 0 && meetSide(ray, other, f3, d3));
    }

    /** How far b may be off for a ray that leaves the side. */
    private double slack(Ray ray, double length) {
        return (Arithmetic.gamma(24) * size + ray.departureError * length) * length * slant * slant;
    }

    /**
     * The start is a root; what remains is linear.
     *
     * @param least what b must exceed for the ray to go inward; negative for a ray into the cone from its very tip
     */
    private boolean leaveSide(Ray ray, double a, double b, double f3, double d3, double least) {
        if (!capped) {
            return Math.abs(b) > Math.abs(least) && meetSide(ray, 2 * b / a, f3, d3);
        }
        if (!(b > least)) {
            return false;
        }
        double side = a > 0 ? 2 * b / a : Double.POSITIVE_INFINITY;
        double cap = d3 > 0 ? (height - f3) / d3 : d3 < 0 ? -f3 / d3 : Double.POSITIVE_INFINITY;
        // Inward there is always a way out, be it shorter than rounding.
        double exit = Math.max(Math.min(side, cap), Double.MIN_VALUE);
        return accept(ray, exit, side <= cap ? SIDE : d3 > 0 ? TOP : BASE);
    }

    private boolean meetSide(Ray ray, double t, double f3, double d3) {
        double h = Math.fma(t, d3, f3);
        return h >= 0 && h <= height && accept(ray, t, SIDE);
    }

    /** The solid is convex: what the line has in common with the side's inside and with the slab between the caps. */
    private boolean meetSolid(Ray ray, double a, double s, double c, double one, double other, double f3, double d3) {
        double sideEntry = Double.NEGATIVE_INFINITY;
        double sideExit = Double.POSITIVE_INFINITY;
        if (a > 0) {
            sideEntry = Math.min(one, other);
            sideExit = Math.max(one, other);
        } else if (a == 0 && Double.isNaN(other)) {
            if (c > 0) {
                return false;
            }
        } else if (s > 0) {
            // Steeper than the side: inside from the last root on, or up to the first, where the cone is wide.
            sideEntry = a == 0 ? other : Math.max(one, other);
        } else {
            sideExit = a == 0 ? other : Math.min(one, other);
        }
        if (d3 == 0 && !(f3 >= 0 && f3 <= height)) {
            return false;
        }
        double capEntry = d3 > 0 ? -f3 / d3 : d3 < 0 ? (height - f3) / d3 : Double.NEGATIVE_INFINITY;
        double capExit = d3 > 0 ? (height - f3) / d3 : d3 < 0 ? -f3 / d3 : Double.POSITIVE_INFINITY;
        int exitPrimitive = sideExit <= capExit ? SIDE : d3 > 0 ? TOP : BASE;
        double exit = Math.min(sideExit, capExit);
        if (ray.leaving != Ray.FREE) {
            boolean inward = ray.leaving == BASE ? d3 > 0 : d3 < 0;
            return inward && accept(ray, Math.max(exit, Double.MIN_VALUE), exitPrimitive);
        }
        double entry = Math.max(sideEntry, capEntry);
        if (!(entry < exit)) {
            return false;
        }
        return entry > 0
                ? accept(ray, entry, sideEntry >= capEntry ? SIDE : d3 > 0 ? BASE : TOP)
                : accept(ray, exit, exitPrimitive);
    }

    private static boolean accept(Ray ray, double t, int primitive) {
        if (t > 0 && t < ray.tMax) {
            ray.hit(t, primitive);
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
        if (hit.primitive != SIDE) {
            frame.setPoint(hit, a, b, hit.primitive == BASE ? 0 : height, pointError);
            frame.setNormal(hit, 0, 0, hit.primitive == BASE ? -1 : 1);
            return;
        }
        double h = Math.max(0, Math.min(height, frame.upOf(x, y, z)));
        double fromAxis = Math.sqrt(a * a + b * b);
        double scale = fromAxis == 0 ? 0 : Math.max(0, Math.fma(widening, h, baseRadius)) / fromAxis;
        frame.setPoint(hit, scale * a, scale * b, h, pointError);
        // The normal of the point as rounded: a ray that leaves it outward is then outward to intersect too.
        double px = hit.x - frame.origin.x();
        double py = hit.y - frame.origin.y();
        double pz = hit.z - frame.origin.z();
        a = frame.acrossOf(px, py, pz);
        b = frame.asideOf(px, py, pz);
        fromAxis = Math.sqrt(a * a + b * b);
        if (fromAxis == 0) {
            frame.setNormal(hit, 0, 0, widening > 0 ? -1 : 1);
        } else {
            frame.setNormal(hit, a / fromAxis, b / fromAxis, -widening);
        }
    }

    @Override
    public void inverseMap(Hit hit) {
        double x = hit.x - frame.origin.x();
        double y = hit.y - frame.origin.y();
        double z = hit.z - frame.origin.z();
        double a = frame.acrossOf(x, y, z);
        double b = frame.asideOf(x, y, z);
        double fromAxis = Math.sqrt(a * a + b * b);
        double sideLength = slant * height;
        double outline = capped ? baseRadius + sideLength + topRadius : sideLength;
        double beforeSide = capped ? baseRadius : 0;
        double along = switch (hit.primitive) {
            case BASE -> fromAxis;
            case TOP -> outline - fromAxis;
            default -> beforeSide + slant * frame.upOf(x, y, z);
        };
        hit.setMap(AxisFrame.turn(a, b), PlanarMapping.within(along / outline));
        double turn = 2 * Math.PI;
        double outward = fromAxis == 0 ? 0 : outline / fromAxis;
        double out = switch (hit.primitive) {
            case BASE -> outward;
            case TOP -> -outward;
            default -> outward * widening / slant;
        };
        double up = hit.primitive == SIDE ? outline / slant : 0;
        frame.setTangents(hit, -turn * b, turn * a, 0, out * a, out * b, up);
    }

    @Override
    public boolean isClosed() {
        return capped;
    }
}
