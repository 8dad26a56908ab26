package org.diacaustic.math;

/**
 * An affine map of space, with its inverse. Both are composed side by side from the exact inverses of the steps, so
 * neither is found by elimination, and the inverse of a translation is a subtraction, which keeps all digits near an
 * object however far from the origin it has been moved.
 *
 * <p>Immutable. {@code identity().scale(2, 2, 2).rotate(UNIT_Y, 90).translate(0, 1, 0)} scales first, then turns, then
 * moves.
 */
public final class Transform {
    private static final Transform IDENTITY = new Transform(Matrix.IDENTITY, Matrix.IDENTITY, Vector3.ZERO);

    private final Matrix linear;
    private final Matrix inverse;
    private final Vector3 translation;

    private Transform(Matrix linear, Matrix inverse, Vector3 translation) {
        if (!linear.isFinite() || !inverse.isFinite() || !translation.isFinite()) {
            throw new IllegalArgumentException("a transform must be finite and invertible");
        }
        this.linear = linear;
        this.inverse = inverse;
        this.translation = translation;
    }

    public static Transform identity() {
        return IDENTITY;
    }

    /**
     * The map p ↦ x·p.x + y·p.y + z·p.z + translation: the columns of a 3×4 matrix.
     *
     * @throws IllegalArgumentException if it is singular or not finite
     */
    public static Transform ofColumns(Vector3 x, Vector3 y, Vector3 z, Vector3 translation) {
        Matrix linear = Matrix.ofColumns(x, y, z);
        return new Transform(linear, linear.inverse(), translation);
    }

    /**
     * Then stretches along the axes about the origin; negative factors mirror.
     *
     * @throws IllegalArgumentException if a factor is zero or not finite
     */
    public Transform scale(double x, double y, double z) {
        Vector3 factors = new Vector3(x, y, z);
        if (!factors.isFinite() || x == 0 || y == 0 || z == 0) {
            throw new IllegalArgumentException("scale factors must be finite and not zero, but are " + factors);
        }
        return then(Matrix.diagonal(x, y, z), Matrix.diagonal(1 / x, 1 / y, 1 / z));
    }

    /** Then stretches by the same factor along all axes. */
    public Transform scale(double factor) {
        return scale(factor, factor, factor);
    }

    /**
     * Then turns about an axis through the origin, anticlockwise as seen against the axis. Multiples of 90° about
     * coordinate axes are exact.
     *
     * @throws IllegalArgumentException if the axis is zero or anything is not finite
     */
    public Transform rotate(Vector3 axis, double degrees) {
        if (!Double.isFinite(degrees)) {
            throw new IllegalArgumentException("an angle must be finite, but is " + degrees);
        }
        Matrix rotation = Matrix.rotation(axis.normalized(), degrees);
        return then(rotation, rotation.transpose());
    }

    /**
     * Then moves.
     *
     * @throws IllegalArgumentException if a component is not finite
     */
    public Transform translate(double x, double y, double z) {
        return new Transform(linear, inverse, translation.plus(new Vector3(x, y, z)));
    }

    public Transform translate(Vector3 by) {
        return translate(by.x(), by.y(), by.z());
    }

    /** Then does another. */
    public Transform then(Transform next) {
        Transform turned = then(next.linear, next.inverse);
        return turned.translate(next.translation);
    }

    private Transform then(Matrix next, Matrix nextInverse) {
        return new Transform(next.times(linear), inverse.times(nextInverse), next.times(translation));
    }

    /** The linear part: where directions go. */
    public Matrix linear() {
        return linear;
    }

    /** The inverse of the linear part. */
    public Matrix inverseLinear() {
        return inverse;
    }

    /** Where the origin goes. */
    public Vector3 translation() {
        return translation;
    }

    public Vector3 point(Vector3 p) {
        return linear.times(p).plus(translation);
    }

    public Vector3 vector(Vector3 v) {
        return linear.times(v);
    }

    /** The normal of the moved surface, of length 1, on the same side of it as before. */
    public Vector3 normal(Vector3 n) {
        return inverse.transpose().times(n).normalized();
    }

    public Vector3 inversePoint(Vector3 p) {
        return inverse.times(p.minus(translation));
    }

    public Vector3 inverseVector(Vector3 v) {
        return inverse.times(v);
    }
}
