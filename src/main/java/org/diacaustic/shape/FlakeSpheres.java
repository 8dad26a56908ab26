package org.diacaustic.shape;

import org.diacaustic.math.Arithmetic;
import org.diacaustic.math.Bounds;
import org.diacaustic.math.Ray;
import org.diacaustic.math.Vector3;

/**
 * The spheres of a flake and how rays meet them. They are numbered level by level: the children of sphere i are
 * i·children + 1 and those after it.
 */
final class FlakeSpheres {
    private static final int LARGEST_COUNT = 1 << 24;

    private final double[] spheres;
    private final int children;

    /**
     * @param ratio the radius of a child in radii of its parent
     * @param up the pole of the root
     * @param side where the equator of the root begins; its part along the pole is left out
     * @throws IllegalArgumentException if a number is out of its range or the flake has more than 2^24 spheres
     */
    FlakeSpheres(FlakeKind kind, int depth, Vector3 centre, double radius, double ratio, Vector3 up, Vector3 side) {
        if (!(radius > 0 && radius < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException("radius must be positive and finite, but is " + radius);
        }
        if (!centre.isFinite()) {
            throw new IllegalArgumentException("centre must be finite, but is " + centre);
        }
        if (!(ratio > 0 && ratio < 1)) {
            throw new IllegalArgumentException("ratio must lie between 0 and 1, but is " + ratio);
        }
        this.children = kind.children();
        this.spheres = new double[4 * count(children, depth)];
        Vector3 pole = up.normalized();
        Vector3 third = pole.cross(side.normalized()).normalized();
        grow(kind, new Sizes(radius, ratio), 0, 0, centre, new Frame(third.cross(pole), third, pole));
    }

    /** 1 + k + k² + … + k^depth. */
    private static int count(int children, int depth) {
        if (depth < 0) {
            throw new IllegalArgumentException("depth must not be negative, but is " + depth);
        }
        long count = 1;
        for (int level = 0; level < depth; level++) {
            count = count * children + 1;
            if (count > LARGEST_COUNT) {
                throw new IllegalArgumentException(
                        "a flake has at most " + LARGEST_COUNT + " spheres, too few for depth " + depth);
            }
        }
        return (int) count;
    }

    private void grow(FlakeKind kind, Sizes sizes, int level, int sphere, Vector3 centre, Frame frame) {
        double radius = sizes.ofLevel(level);
        int i = 4 * sphere;
        spheres[i] = centre.x();
        spheres[i + 1] = centre.y();
        spheres[i + 2] = centre.z();
        spheres[i + 3] = radius;
        int child = firstChild(sphere);
        if (child >= count()) {
            return;
        }
        double distance = radius + sizes.ofLevel(level + 1);
        for (Vector3 local : kind.directions()) {
            Vector3 direction = frame.toScene(local);
            Frame turned = kind.turnsOutward() ? frame.pointing(direction) : frame;
            grow(kind, sizes, level + 1, child, centre.plus(direction.times(distance)), turned);
            child++;
        }
    }

    /** Radii level by level. A ratio that is one part of a whole number, such as a third, is divided by that, without a rounding more. */
    private record Sizes(double radius, double ratio) {

        double ofLevel(int level) {
            double divisor = 1;
            for (int i = 0; i < level; i++) {
                divisor *= 1 / ratio;
            }
            return radius / divisor;
        }
    }

    /** Three axes at right angles, of length 1. */
    private record Frame(Vector3 x, Vector3 y, Vector3 z) {

        Vector3 toScene(Vector3 v) {
            return x.times(v.x()).plus(y.times(v.y())).plus(z.times(v.z()));
        }

        /** A frame with its pole in another direction. */
        Frame pointing(Vector3 pole) {
            Vector3 side = z.cross(pole).normalized();
            return new Frame(side.cross(pole), side, pole);
        }
    }

    int count() {
        return spheres.length / 4;
    }

    int children() {
        return children;
    }

    /** The number of the first child; at least {@link #count()} for the smallest spheres. */
    int firstChild(int sphere) {
        return sphere * children + 1;
    }

    Bounds bounds() {
        Bounds bounds = Bounds.EMPTY;
        for (int i = 0; i < spheres.length; i += 4) {
            double radius = spheres[i + 3];
            Vector3 centre = new Vector3(spheres[i], spheres[i + 1], spheres[i + 2]);
            bounds = bounds.union(Bounds.around(centre, radius, radius, radius));
        }
        return bounds;
    }

    /** x, y, z and radius of each sphere. */
    double[] spheres() {
        return spheres;
    }

    /**
     * Meets one sphere.
     *
     * @param inverseSquare 1 ÷ |direction|²
     * @return whether the ray was shortened
     */
    boolean meet(Ray ray, int sphere, double inverseSquare) {
        int i = 4 * sphere;
        return meet(ray, sphere, spheres[i], spheres[i + 1], spheres[i + 2], spheres[i + 3], inverseSquare);
    }

    static boolean meet(Ray ray, int sphere, double x, double y, double z, double radius, double inverseSquare) {
        double dx = ray.directionX;
        double dy = ray.directionY;
        double dz = ray.directionZ;
        double fx = ray.originX - x;
        double fy = ray.originY - y;
        double fz = ray.originZ - z;
        double middle = -(fx * dx + fy * dy + fz * dz) * inverseSquare;
        // The part of f at right angles to the ray gives the discriminant without cancellation [Haines et al. 2019].
        double px = Math.fma(middle, dx, fx);
        double py = Math.fma(middle, dy, fy);
        double pz = Math.fma(middle, dz, fz);
        double discriminant = radius * radius - (px * px + py * py + pz * pz);
        if (!(discriminant >= 0)) {
            return false;
        }
        double t = sphere == ray.leaving
                ? otherEnd(ray, fx, fy, fz, middle, inverseSquare)
                : firstEnd(fx, fy, fz, radius, middle, Math.sqrt(discriminant * inverseSquare), inverseSquare);
        if (t > 0 && t < ray.tMax) {
            ray.hit(t, sphere);
            return true;
        }
        return false;
    }

    /** The first positive end of the chord, if any, without subtracting nearly equal numbers. */
    private static double firstEnd(
            double fx, double fy, double fz, double radius, double middle, double halfChord, double inverseSquare) {
        double distance = Math.sqrt(fx * fx + fy * fy + fz * fz);
        double product = (distance - radius) * (distance + radius) * inverseSquare;
        double larger = middle + Math.copySign(halfChord, middle);
        double smaller = product / larger;
        return middle > 0 && smaller > 0 ? smaller : Math.max(larger, smaller);
    }

    /** The end of the chord that is not its start; 0 unless the ray goes inward by more than rounding. */
    private static double otherEnd(Ray ray, double fx, double fy, double fz, double middle, double inverseSquare) {
        double terms = Math.abs(fx * ray.directionX) + Math.abs(fy * ray.directionY) + Math.abs(fz * ray.directionZ);
        return middle > Arithmetic.gamma(8) * terms * inverseSquare + ray.departureError ? 2 * middle : 0;
    }

    void complete(Ray ray, Hit hit) {
        int i = 4 * hit.primitive;
        double x = spheres[i];
        double y = spheres[i + 1];
        double z = spheres[i + 2];
        double radius = spheres[i + 3];
        double fx = Math.fma(hit.t, ray.directionX, ray.originX - x);
        double fy = Math.fma(hit.t, ray.directionY, ray.originY - y);
        double fz = Math.fma(hit.t, ray.directionZ, ray.originZ - z);
        double scale = radius / Arithmetic.length(fx, fy, fz);
        double largest = Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z)));
        hit.setPoint(
                Math.fma(scale, fx, x),
                Math.fma(scale, fy, y),
                Math.fma(scale, fz, z),
                Arithmetic.gamma(6) * (largest + radius));
        // The normal of the point as rounded: a ray that leaves it outward is then outward to meet() too.
        double nx = hit.x - x;
        double ny = hit.y - y;
        double nz = hit.z - z;
        double length = Arithmetic.length(nx, ny, nz);
        hit.setNormal(nx / length, ny / length, nz / length);
    }

    void inverseMap(Hit hit) {
        int i = 4 * hit.primitive;
        SphericalMapping.UPRIGHT.map(hit.normalX, hit.normalY, hit.normalZ, hit);
        SphericalMapping.UPRIGHT.tangents(hit.x - spheres[i], hit.y - spheres[i + 1], hit.z - spheres[i + 2], hit);
    }
}
