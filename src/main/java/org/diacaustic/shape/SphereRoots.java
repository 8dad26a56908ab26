package org.diacaustic.shape;

import org.diacaustic.math.Arithmetic;
import org.diacaustic.math.Ray;

/** Where a ray meets a sphere about the origin of the coordinates given: what spheres and ellipsoids have in common. */
final class SphereRoots {
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
        double b = -(fx * dx + fy * dy + fz * dz);
        if (ray.leaving != Ray.FREE) {
            // The start is a root; what remains is linear: a·t = 2b, ahead only if the ray goes inward. A ray that goes
            // along the surface within rounding does not.
            double rounding = Arithmetic.gamma(8) * (Math.abs(fx * dx) + Math.abs(fy * dy) + Math.abs(fz * dz));
            return b > rounding + departure * Math.sqrt(a) && accept(ray, 2 * b / a);
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
}
