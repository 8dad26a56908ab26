package org.diacaustic.example;

import org.diacaustic.math.Bounds;
import org.diacaustic.math.Ray;
import org.diacaustic.shape.Hit;
import org.diacaustic.shape.Shape;

/**
 * A shape of one's own, as a user of the library would write it: the heart (x² + 9/4·y² + z² − 1)³ = x²·z³ +
 * 9/80·y²·z³ [Taubin 1994], found by marching along the ray and bisecting where the sign changes.
 */
final class Heart implements Shape {
    private static final Bounds BOUNDS = new Bounds(-1.4, -0.9, -1.2, 1.4, 0.9, 1.4);
    private static final int STEPS = 400;
    private static final int BISECTIONS = 60;

    @Override
    public Bounds bounds() {
        return BOUNDS;
    }

    @Override
    public boolean intersect(Ray ray) {
        double reach = 2 * BOUNDS.radius();
        double along = -(ray.originX * ray.directionX + ray.originY * ray.directionY + ray.originZ * ray.directionZ);
        double start = Math.max(ray.nearest(), along - reach / 2);
        double end = Math.min(ray.tMax, along + reach / 2);
        double step = (end - start) / STEPS;
        double before = value(ray, start);
        for (int i = 1; i <= STEPS && step > 0; i++) {
            double t = start + i * step;
            double now = value(ray, t);
            if (before > 0 != now > 0) {
                double found = bisect(ray, t - step, t, before > 0);
                if (found > ray.nearest() && found < ray.tMax) {
                    ray.hit(found, 0);
                    return true;
                }
            }
            before = now;
        }
        return false;
    }

    private static double bisect(Ray ray, double low, double high, boolean positiveAtLow) {
        double from = low;
        double to = high;
        for (int i = 0; i < BISECTIONS; i++) {
            double middle = (from + to) / 2;
            if (value(ray, middle) > 0 == positiveAtLow) {
                from = middle;
            } else {
                to = middle;
            }
        }
        return to;
    }

    private static double value(Ray ray, double t) {
        return value(ray.pointX(t), ray.pointY(t), ray.pointZ(t));
    }

    private static double value(double x, double y, double z) {
        double a = x * x + 9.0 / 4 * y * y + z * z - 1;
        return a * a * a - x * x * z * z * z - 9.0 / 80 * y * y * z * z * z;
    }

    @Override
    public void complete(Ray ray, Hit hit) {
        double x = ray.pointX(hit.t);
        double y = ray.pointY(hit.t);
        double z = ray.pointZ(hit.t);
        double a = x * x + 9.0 / 4 * y * y + z * z - 1;
        double z2 = z * z;
        double nx = 6 * x * a * a - 2 * x * z2 * z;
        double ny = 27.0 / 2 * y * a * a - 9.0 / 40 * y * z2 * z;
        double nz = 6 * z * a * a - 3 * x * x * z2 - 27.0 / 80 * y * y * z2;
        double length = Math.sqrt(nx * nx + ny * ny + nz * nz);
        hit.setPoint(x, y, z, 1e-14);
        hit.setNormal(nx / length, ny / length, nz / length);
    }

    @Override
    public void inverseMap(Hit hit) {
        hit.setMap((hit.x - BOUNDS.minX()) / 2.8, (hit.z - BOUNDS.minZ()) / 2.6);
        hit.setTangents(2.8, 0, 0, 0, 0, 2.6);
    }

    @Override
    public boolean isClosed() {
        return true;
    }
}
