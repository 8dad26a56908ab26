package org.diacaustic.shape;

import java.util.ArrayList;
import java.util.List;
import org.diacaustic.math.Ray;
import org.diacaustic.math.Vector3;

/** Shoots single rays for the tests of shapes. */
final class Line {
    private Line() {}

    /** The hit of a ray, completed; null if it misses. */
    static Hit meet(Shape shape, Vector3 origin, Vector3 direction) {
        Ray ray = new Ray();
        ray.set(origin, direction);
        return shape.intersect(ray) ? complete(shape, ray) : null;
    }

    static Hit complete(Shape shape, Ray ray) {
        Hit hit = new Hit();
        hit.t = ray.tMax;
        hit.primitive = ray.hitPrimitive;
        shape.complete(ray, hit);
        return hit;
    }

    /** A ray that leaves a hit. */
    static Ray leaving(Hit hit, Vector3 direction) {
        Ray ray = new Ray();
        ray.set(new Vector3(hit.x, hit.y, hit.z), direction);
        ray.leaving = hit.primitive;
        ray.departureError = hit.pointError / direction.length();
        return ray;
    }

    /** All t at which a line from outside crosses the shape, each found from the one before. */
    static List<Double> crossings(Shape shape, Vector3 origin, Vector3 direction) {
        List<Double> found = new ArrayList<>();
        Ray ray = new Ray();
        ray.set(origin, direction);
        double t = 0;
        while (shape.intersect(ray)) {
            t += ray.tMax;
            found.add(t);
            ray = leaving(complete(shape, ray), direction);
        }
        return found;
    }

    static Vector3 normal(Hit hit) {
        return new Vector3(hit.normalX, hit.normalY, hit.normalZ);
    }

    static Vector3 v(double x, double y, double z) {
        return new Vector3(x, y, z);
    }
}
