package org.diacaustic.shape;

import org.diacaustic.math.Arithmetic;
import org.diacaustic.math.Ray;

/** Where a ray meets a sphere about the origin of the coordinates given: what spheres and ellipsoids have in common. */
final class SphereRoots {
    /** Products that are smaller or larger may lose digits, or all, to the range of doubles. */
    private static final double SMALLEST = 0x1p-500;

    private static final double LARGEST = 0x1p500;

    private SphereRoots() {}

    /**
     * Meets the sphere |f + t·d| = radius; answers as {@link Shape#intersect}.
     *
     * @param departure how far the start f may lie off the sphere, in the units of f, if the ray leaves it
     */
    static boolean intersect(
            Ray ray,
            double fx,
            double fy,
            double fz,
            double dx,
            double dy,
            double dz,
            double radius,
            double departure) {
        double a = dx * dx + dy * dy + dz * dz;
        double radiusSquared = radius * radius;
        double reach = a * radiusSquared;
        if (!(reach > SMALLEST && reach < LARGEST)) {
            return intersectScaled(ray, fx, fy, fz, dx, dy, dz, radius, departure);
        }
        double b = -(fx * dx + fy * dy + fz * dz);
        if (ray.leaving != Ray.FREE) {
            // The surface that the ray leaves is a root; what remains is linear: both add up to 2b/a. The other is
            // ahead only
            // if the ray goes inward. A ray that goes along the surface within rounding does not.
            double rounding = Arithmetic.gamma(8) * (Math.abs(fx * dx) + Math.abs(fy * dy) + Math.abs(fz * dz));
            return b > rounding + departure * Math.sqrt(a) && accept(ray, 2 * b / a - ray.departureOffset);
        }
        double c = Math.fma(fx, fx, Math.fma(fy, fy, Math.fma(fz, fz, -radiusSquared)));
        // The part of f at right angles to the ray gives the discriminant without cancellation [Haines et al. 2019];
        // times |d|
        // it is f × d, of which no digit is lost.
        double px = Arithmetic.differenceOfProducts(fy, dz, fz, dy);
        double py = Arithmetic.differenceOfProducts(fz, dx, fx, dz);
        double pz = Arithmetic.differenceOfProducts(fx, dy, fy, dx);
        double discriminant = reach - (px * px + py * py + pz * pz);
        if (!(discriminant >= 0)) {
            return false;
        }
        // From outside the near root, which is behind if the sphere is; from inside, or from the sphere itself, the far
        // one.
        double half = Math.copySign(Math.sqrt(discriminant), c - Double.MIN_VALUE);
        double difference = b - half;
        // Where the difference loses digits, the product of both roots, c ÷ a, has them.
        return accept(ray, Math.abs(difference) < 0.125 * Math.abs(b) ? c / (b + half) : difference / a);
    }

    /** The same in units of about the radius and of about the length of the direction. */
    private static boolean intersectScaled(
            Ray ray,
            double fx,
            double fy,
            double fz,
            double dx,
            double dy,
            double dz,
            double radius,
            double departure) {
        double speed = Math.max(Math.abs(dx), Math.max(Math.abs(dy), Math.abs(dz)));
        if (!(speed > 0 && speed < Double.POSITIVE_INFINITY)) {
            return false;
        }
        int size = Math.getExponent(radius);
        int length = Math.getExponent(speed);
        double tMax = ray.tMax;
        double departureOffset = ray.departureOffset;
        ray.tMax = Math.scalb(tMax, length - size);
        ray.departureOffset = Math.scalb(departureOffset, length - size);
        boolean hit = intersect(
                ray,
                Math.scalb(fx, -size),
                Math.scalb(fy, -size),
                Math.scalb(fz, -size),
                Math.scalb(dx, -length),
                Math.scalb(dy, -length),
                Math.scalb(dz, -length),
                Math.scalb(radius, -size),
                Math.scalb(departure, -size));
        ray.tMax = hit ? Math.scalb(ray.tMax, size - length) : tMax;
        ray.departureOffset = departureOffset;
        return hit;
    }

    private static boolean accept(Ray ray, double t) {
        if (t > 0 && t < ray.tMax) {
            ray.hit(t, 0);
            return true;
        }
        return false;
    }
}
