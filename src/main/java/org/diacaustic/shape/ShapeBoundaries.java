package org.diacaustic.shape;

import org.diacaustic.math.Arithmetic;
import org.diacaustic.math.Ray;

/** The boundaries of a closed shape along a ray: each is left to find the one after it, as a path would leave it. */
final class ShapeBoundaries extends Boundaries {
    /** The primitive of the shape that the next boundary lies on. */
    int primitive;

    /** What the shape noted with it. */
    double noteU;

    double noteV;

    private final Ray ray = new Ray();
    private final Hit hit = new Hit();
    private Shape shape;
    private double start;
    private double length;

    /** @param leaving the primitive of the shape that the ray starts on, or {@link Ray#FREE} */
    void start(Shape closed, Ray asked, int leaving) {
        shape = closed;
        start = 0;
        length = Arithmetic.length(asked.directionX, asked.directionY, asked.directionZ);
        ray.set(asked.originX, asked.originY, asked.originZ, asked.directionX, asked.directionY, asked.directionZ);
        ray.tests = 0;
        ray.leaving = leaving;
        ray.departureError = asked.departureError;
        ray.departureOffset = asked.departureOffset;
        seek();
        inside = !isAtEnd() && !entering;
    }

    /** Tests made since the start. */
    long tests() {
        return ray.tests;
    }

    private void seek() {
        if (!shape.intersect(ray)) {
            t = Double.POSITIVE_INFINITY;
            return;
        }
        hit.take(ray);
        shape.complete(ray, hit);
        double cosine =
                (ray.directionX * hit.normalX + ray.directionY * hit.normalY + ray.directionZ * hit.normalZ) / length;
        t = start + hit.t;
        entering = cosine < 0;
        error = hit.touchingDistance(cosine) / length;
        primitive = hit.primitive;
        noteU = hit.noteU;
        noteV = hit.noteV;
    }

    @Override
    void advance() {
        inside = entering;
        start = t;
        ray.set(hit.x, hit.y, hit.z, ray.directionX, ray.directionY, ray.directionZ);
        ray.leaving = hit.primitive;
        ray.departureError = hit.pointError / length;
        seek();
    }
}
