package org.diacaustic.shader;

import org.diacaustic.material.Material;
import org.diacaustic.material.Surface;
import org.diacaustic.math.Ray;
import org.diacaustic.scene.SceneIndex;
import org.diacaustic.shape.Hit;
import org.diacaustic.shape.Shape;

/**
 * Stops at the first opaque object on a shadow ray and gathers all crossings of the transparent ones. All crossings of
 * one object count as one test, as in the thesis, where a test returned all intersection points [Thesis 3.2.2].
 */
final class CrossingCollector implements SceneIndex.Visitor {
    /** More surfaces of one object than this in one place are not told apart. */
    private static final int MOST_TOUCHING = 8;

    final Crossings crossings = new Crossings();
    private final ShadowRay shadow;
    private final Ray part = new Ray();
    private final Hit hit = new Hit();
    private final Surface surface = new Surface();

    CrossingCollector(ShadowRay shadow) {
        this.shadow = shadow;
    }

    long tests() {
        return part.tests;
    }

    @Override
    public boolean stopsAt(int object, Ray ray) {
        if (!shadow.scene.isOpaque(object)) {
            gather(object, ray);
            return false;
        }
        if (!shadow.scene.object(object).shape().occludes(ray)) {
            return false;
        }
        shadow.remember(object);
        return true;
    }

    private void gather(int object, Ray ray) {
        Shape shape = shadow.scene.object(object).shape();
        double back = shadow.touchingDistance();
        part.set(
                ray.originX - back * ray.directionX,
                ray.originY - back * ray.directionY,
                ray.originZ - back * ray.directionZ,
                ray.directionX,
                ray.directionY,
                ray.directionZ);
        part.tMax = ray.tMax + back;
        part.leaving = ray.leaving;
        part.departureError = ray.departureError + back;
        double travelled = -back;
        boolean found = shape.intersect(part);
        long tests = part.tests;
        int inPlace = 0;
        while (found) {
            hit.take(part);
            shape.complete(part, hit);
            travelled += hit.t;
            add(object, travelled);
            // Surfaces in one place could send the line to and fro for ever: then it leaves them all.
            inPlace = hit.t <= 2 * part.departureError ? inPlace + 1 : 0;
            double ahead = inPlace < MOST_TOUCHING ? 0 : 2 * part.departureError;
            travelled += ahead;
            part.set(
                    hit.x + ahead * ray.directionX,
                    hit.y + ahead * ray.directionY,
                    hit.z + ahead * ray.directionZ,
                    ray.directionX,
                    ray.directionY,
                    ray.directionZ);
            part.tMax = ray.tMax - travelled;
            part.leaving = hit.primitive;
            part.departureError = hit.pointError + ahead;
            found = shape.intersect(part);
        }
        part.tests = tests;
    }

    /** Adds a crossing; of surfaces that touch, those that are left come before those that are entered. */
    private void add(int object, double distance) {
        double along = part.directionX * hit.normalX + part.directionY * hit.normalY + part.directionZ * hit.normalZ;
        boolean entering = along < 0;
        if (distance <= shadow.touchingDistance() && !shadow.media.canCross(object, entering)) {
            return;
        }
        Material material = shadow.scene.object(object).material();
        if (material.needsMap()) {
            shadow.scene.object(object).shape().inverseMap(hit);
        }
        material.evaluate(hit, surface);
        double reach = hit.touchingDistance(along);
        crossings.add(
                entering ? distance + reach : distance - reach,
                object,
                entering,
                Math.min(1, Math.abs(along)),
                surface.transparency.red,
                surface.transparency.green,
                surface.transparency.blue);
    }
}
