package org.diacaustic.trial;

import java.util.Arrays;
import org.diacaustic.math.Arithmetic;
import org.diacaustic.math.Ray;
import org.diacaustic.math.Vector3;
import org.diacaustic.shape.Hit;
import org.diacaustic.shape.Shape;

/**
 * Where a line meets a shape, found as a render finds it: the first point by {@link Shape#intersect}, each of the next by a
 * ray that leaves the completed hit before. What lies behind the start is found by a ray the other way.
 */
final class LineRoots {
    /** No shape of one piece has more. */
    private static final int MOST = 16;

    private final Shape shape;
    private final Vector3 origin;
    private final Vector3 direction;
    private final double length;
    private final double[] roots = new double[2 * MOST + 1];
    private final Hit first = new Hit();
    private int count;
    private boolean ahead;

    private LineRoots(Shape shape, Vector3 origin, Vector3 direction) {
        this.shape = shape;
        this.origin = origin;
        this.direction = direction;
        this.length = direction.length();
        follow(direction, 1);
        ahead = count > 0;
        follow(direction.negated(), -1);
    }

    static LineRoots of(Shape shape, Vector3 origin, Vector3 direction) {
        return new LineRoots(shape, origin, direction);
    }

    private void follow(Vector3 way, int sign) {
        Ray ray = new Ray();
        Hit hit = new Hit();
        ray.set(origin, way);
        double passed = 0;
        for (int i = 0; i < MOST && shape.intersect(ray); i++) {
            hit.take(ray);
            shape.complete(ray, hit);
            if (count == 0) {
                first.take(ray);
                shape.complete(ray, first);
            }
            passed += hit.t;
            roots[count++] = sign * passed;
            leave(ray, hit, way);
        }
    }

    /** Makes the ray leave a hit, as a path does. */
    static void leave(Ray ray, Hit hit, Vector3 way) {
        ray.set(hit.x, hit.y, hit.z, way.x(), way.y(), way.z());
        ray.leaving = hit.primitive;
        ray.departureError = hit.pointError / way.length();
    }

    /** Whether a ray from the start meets the shape. */
    boolean isAhead() {
        return ahead;
    }

    /** The nearest point ahead or, if there is none, behind. */
    Hit first() {
        return first;
    }

    /** All of them, in ascending order, in lengths of the direction. */
    double[] all() {
        double[] all = Arrays.copyOf(roots, count);
        Arrays.sort(all);
        return all;
    }

    /**
     * The same if the line has as many as are known of. A start that is itself a point of the surface is never found by rays that
     * leave it: it is added if one is missing and the shape's own {@code complete} moves the start no farther than it says
     * that its points may be off.
     */
    double[] all(int known) {
        return all(known, 1);
    }

    /** The same of a shape of so many primitives. */
    double[] all(int known, int primitives) {
        for (int primitive = 0; primitive < primitives && count == known - 1; primitive++) {
            if (isOnSurface(primitive)) {
                roots[count++] = 0;
            }
        }
        return all();
    }

    private boolean isOnSurface(int primitive) {
        Ray ray = new Ray();
        ray.set(origin, direction);
        Hit hit = new Hit();
        hit.primitive = primitive;
        shape.complete(ray, hit);
        double off = Arithmetic.length(hit.x - origin.x(), hit.y - origin.y(), hit.z - origin.z());
        return off <= hit.pointError;
    }

    /** The first point that a ray from the start meets if it leaves the surface there; not a number if there is none. */
    double afterLeavingStart() {
        Ray ray = new Ray();
        ray.set(origin, direction);
        Hit hit = new Hit();
        shape.complete(ray, hit);
        ray.leaving = hit.primitive;
        ray.departureError = hit.pointError / length;
        return shape.intersect(ray) ? ray.tMax : Double.NaN;
    }
}
