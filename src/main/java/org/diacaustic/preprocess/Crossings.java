package org.diacaustic.preprocess;

import org.diacaustic.math.Arithmetic;
import org.diacaustic.math.Bounds;
import org.diacaustic.math.Ray;
import org.diacaustic.shape.Hit;
import org.diacaustic.shape.Shape;

/** Follows a line through one shape, from crossing to crossing. Owned by one task. */
final class Crossings {
    final Ray ray = new Ray();

    /** The crossing that was found last. */
    final Hit hit = new Hit();

    /**
     * Goes on to the next crossing beyond the start of {@link #ray}, whose direction has length 1, and moves the start just
     * beyond it: triangles that share the edge the line goes through count once. The start moves along the line and
     * never back, so there is an end.
     *
     * @return whether there was one
     */
    boolean next(Shape shape) {
        if (!shape.intersect(ray)) {
            return false;
        }
        hit.take(ray);
        shape.complete(ray, hit);
        double ahead = hit.touchingDistance(cosine()) + Arithmetic.gamma(8) * hit.t;
        double on = hit.t + ahead;
        ray.set(ray.pointX(on), ray.pointY(on), ray.pointZ(on), ray.directionX, ray.directionY, ray.directionZ);
        ray.leaving = hit.primitive;
        ray.departureError = hit.pointError + ahead;
        return true;
    }

    /** Moves the start along the line to before the box, which must hold all that is to be crossed. */
    void startBefore(Bounds bounds) {
        double x = bounds.minX() + (bounds.maxX() - bounds.minX()) / 2 - ray.originX;
        double y = bounds.minY() + (bounds.maxY() - bounds.minY()) / 2 - ray.originY;
        double z = bounds.minZ() + (bounds.maxZ() - bounds.minZ()) / 2 - ray.originZ;
        double middle = x * ray.directionX + y * ray.directionY + z * ray.directionZ;
        double start = middle - 2 * bounds.radius();
        ray.originX = Math.fma(start, ray.directionX, ray.originX);
        ray.originY = Math.fma(start, ray.directionY, ray.originY);
        ray.originZ = Math.fma(start, ray.directionZ, ray.originZ);
    }

    /** Of the line to the surface's normal: positive where it leaves. */
    double cosine() {
        return ray.directionX * hit.normalX + ray.directionY * hit.normalY + ray.directionZ * hit.normalZ;
    }
}
