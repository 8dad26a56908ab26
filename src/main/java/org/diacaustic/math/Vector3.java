package org.diacaustic.math;

/**
 * An immutable point or direction, for scene descriptions and everything outside the hot loops. The loops themselves
 * keep three doubles apiece and allocate nothing.
 */
public record Vector3(double x, double y, double z) {
    public static final Vector3 ZERO = new Vector3(0, 0, 0);
    public static final Vector3 UNIT_X = new Vector3(1, 0, 0);
    public static final Vector3 UNIT_Y = new Vector3(0, 1, 0);
    public static final Vector3 UNIT_Z = new Vector3(0, 0, 1);

    public Vector3 plus(Vector3 other) {
        return new Vector3(x + other.x, y + other.y, z + other.z);
    }

    public Vector3 minus(Vector3 other) {
        return new Vector3(x - other.x, y - other.y, z - other.z);
    }

    public Vector3 times(double factor) {
        return new Vector3(x * factor, y * factor, z * factor);
    }

    public Vector3 negated() {
        return new Vector3(-x, -y, -z);
    }

    public double dot(Vector3 other) {
        return x * other.x + y * other.y + z * other.z;
    }

    /** The cross product; each component is a difference of products without cancellation error. */
    public Vector3 cross(Vector3 other) {
        return new Vector3(
                Arithmetic.differenceOfProducts(y, other.z, z, other.y),
                Arithmetic.differenceOfProducts(z, other.x, x, other.z),
                Arithmetic.differenceOfProducts(x, other.y, y, other.x));
    }

    /** The length, right for any finite components: neither the squares nor their sum overflow or vanish. */
    public double length() {
        return Arithmetic.length(x, y, z);
    }

    /**
     * This direction at length 1.
     *
     * @throws IllegalArgumentException if it is zero or not finite
     */
    public Vector3 normalized() {
        double largest = Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z)));
        if (!(largest > 0) || largest == Double.POSITIVE_INFINITY) {
            throw new IllegalArgumentException("a direction must be finite and not zero, but is " + this);
        }
        // Dividing by a power of two changes no digit and keeps the squares in range.
        double scale = Arithmetic.powerOfTwoNear(largest);
        double px = x / scale;
        double py = y / scale;
        double pz = z / scale;
        double length = Math.sqrt(px * px + py * py + pz * pz);
        return new Vector3(px / length, py / length, pz / length);
    }

    /** A unit vector at right angles to this one, which is any direction but zero. */
    public Vector3 perpendicular() {
        Vector3 unit = normalized();
        Vector3 axis = Math.abs(unit.x) < 0.6 ? UNIT_X : Math.abs(unit.y) < 0.6 ? UNIT_Y : UNIT_Z;
        return unit.cross(axis).normalized();
    }

    public boolean isFinite() {
        return Double.isFinite(x) && Double.isFinite(y) && Double.isFinite(z);
    }

    /** Component 0, 1 or 2. */
    public double component(int axis) {
        return switch (axis) {
            case 0 -> x;
            case 1 -> y;
            case 2 -> z;
            default -> throw new IndexOutOfBoundsException("axis " + axis);
        };
    }

    @Override
    public String toString() {
        return "[" + x + ", " + y + ", " + z + "]";
    }
}
