package org.diacaustic.math;

/**
 * An axis-aligned box, closed. Empty if a minimum exceeds its maximum; sides may be infinite.
 *
 * @param minX smallest x, and so on
 */
public record Bounds(double minX, double minY, double minZ, double maxX, double maxY, double maxZ) {
    public static final Bounds EMPTY = new Bounds(
            Double.POSITIVE_INFINITY,
            Double.POSITIVE_INFINITY,
            Double.POSITIVE_INFINITY,
            Double.NEGATIVE_INFINITY,
            Double.NEGATIVE_INFINITY,
            Double.NEGATIVE_INFINITY);

    /** All of space: the bounds of what has none. */
    public static final Bounds UNBOUNDED = new Bounds(
            Double.NEGATIVE_INFINITY,
            Double.NEGATIVE_INFINITY,
            Double.NEGATIVE_INFINITY,
            Double.POSITIVE_INFINITY,
            Double.POSITIVE_INFINITY,
            Double.POSITIVE_INFINITY);

    public static Bounds of(Vector3... points) {
        Bounds bounds = EMPTY;
        for (Vector3 p : points) {
            bounds = bounds.including(p.x(), p.y(), p.z());
        }
        return bounds;
    }

    /** The box of half size (hx, hy, hz) about a centre, rounded outward. */
    public static Bounds around(Vector3 centre, double hx, double hy, double hz) {
        return new Bounds(
                Math.nextDown(centre.x() - hx),
                Math.nextDown(centre.y() - hy),
                Math.nextDown(centre.z() - hz),
                Math.nextUp(centre.x() + hx),
                Math.nextUp(centre.y() + hy),
                Math.nextUp(centre.z() + hz));
    }

    public Bounds including(double x, double y, double z) {
        return new Bounds(
                Math.min(minX, x),
                Math.min(minY, y),
                Math.min(minZ, z),
                Math.max(maxX, x),
                Math.max(maxY, y),
                Math.max(maxZ, z));
    }

    public Bounds union(Bounds other) {
        return new Bounds(
                Math.min(minX, other.minX),
                Math.min(minY, other.minY),
                Math.min(minZ, other.minZ),
                Math.max(maxX, other.maxX),
                Math.max(maxY, other.maxY),
                Math.max(maxZ, other.maxZ));
    }

    /** What both hold; empty if they do not overlap. */
    public Bounds intersection(Bounds other) {
        return new Bounds(
                Math.max(minX, other.minX),
                Math.max(minY, other.minY),
                Math.max(minZ, other.minZ),
                Math.min(maxX, other.maxX),
                Math.min(maxY, other.maxY),
                Math.min(maxZ, other.maxZ));
    }

    public boolean isEmpty() {
        return !(minX <= maxX && minY <= maxY && minZ <= maxZ);
    }

    public boolean isFinite() {
        return minX > Double.NEGATIVE_INFINITY
                && minY > Double.NEGATIVE_INFINITY
                && minZ > Double.NEGATIVE_INFINITY
                && maxX < Double.POSITIVE_INFINITY
                && maxY < Double.POSITIVE_INFINITY
                && maxZ < Double.POSITIVE_INFINITY;
    }

    public boolean contains(double x, double y, double z) {
        return x >= minX && x <= maxX && y >= minY && y <= maxY && z >= minZ && z <= maxZ;
    }

    public boolean overlaps(Bounds other) {
        return minX <= other.maxX
                && maxX >= other.minX
                && minY <= other.maxY
                && maxY >= other.minY
                && minZ <= other.maxZ
                && maxZ >= other.minZ;
    }

    public Vector3 centre() {
        return new Vector3(minX + (maxX - minX) / 2, minY + (maxY - minY) / 2, minZ + (maxZ - minZ) / 2);
    }

    /** Half the diagonal: the radius of the sphere about {@link #centre()} that holds the box. */
    public double radius() {
        return Arithmetic.length(maxX - minX, maxY - minY, maxZ - minZ) / 2;
    }

    /**
     * Whether the ray meets the box within [0, tMax]. Zero components of the direction and flat boxes are right: a ray
     * inside the plane of a face hits. The far side is widened by the rounding of its own computation [Ize 2013], so a
     * box is never missed that the ray enters.
     */
    public boolean isHitBy(Ray ray) {
        double near = 0;
        double far = ray.tMax;
        for (int axis = 0; axis < 3; axis++) {
            double origin = axis == 0 ? ray.originX : axis == 1 ? ray.originY : ray.originZ;
            double direction = axis == 0 ? ray.directionX : axis == 1 ? ray.directionY : ray.directionZ;
            double low = axis == 0 ? minX : axis == 1 ? minY : minZ;
            double high = axis == 0 ? maxX : axis == 1 ? maxY : maxZ;
            double inverse = 1 / direction;
            boolean forward = Math.copySign(1.0, direction) > 0;
            double entry = ((forward ? low : high) - origin) * inverse;
            double exit = ((forward ? high : low) - origin) * inverse * ROUND_OUT;
            // NaN (a ray in the plane of a face) fails both comparisons and so limits nothing.
            if (entry > near) {
                near = entry;
            }
            if (exit < far) {
                far = exit;
            }
        }
        return near <= far;
    }

    private static final double ROUND_OUT = 1 + 2 * Arithmetic.gamma(3);
}
