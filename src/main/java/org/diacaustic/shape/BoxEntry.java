package org.diacaustic.shape;

import org.diacaustic.math.Bounds;
import org.diacaustic.math.Ray;

/** Where a ray enters a box. */
final class BoxEntry {
    private BoxEntry() {}

    /** The t at which the ray enters; 0 if it starts inside; positive infinity if it misses. */
    static double of(Bounds box, Ray ray) {
        if (!box.isHitBy(ray)) {
            return Double.POSITIVE_INFINITY;
        }
        double x = entry(box.minX(), box.maxX(), ray.originX, ray.directionX);
        double y = entry(box.minY(), box.maxY(), ray.originY, ray.directionY);
        double z = entry(box.minZ(), box.maxZ(), ray.originZ, ray.directionZ);
        return Math.max(Math.max(x, y), Math.max(z, 0));
    }

    private static double entry(double low, double high, double origin, double direction) {
        return direction == 0 ? 0 : ((direction > 0 ? low : high) - origin) / direction;
    }
}
