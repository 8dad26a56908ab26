package org.diacaustic.math;

/** An immutable 3×3 matrix, row by row. */
public record Matrix(
        double xx, double xy, double xz, double yx, double yy, double yz, double zx, double zy, double zz) {
    public static final Matrix IDENTITY = diagonal(1, 1, 1);

    public static Matrix diagonal(double x, double y, double z) {
        return new Matrix(x, 0, 0, 0, y, 0, 0, 0, z);
    }

    public static Matrix ofColumns(Vector3 x, Vector3 y, Vector3 z) {
        return new Matrix(x.x(), y.x(), z.x(), x.y(), y.y(), z.y(), x.z(), y.z(), z.z());
    }

    /** The turn by an angle about a unit axis, anticlockwise as seen against the axis [Rodrigues 1840]. */
    static Matrix rotation(Vector3 axis, double degrees) {
        // Sine and cosine of the remainder within ±45°, then whole quarter turns, which are exact.
        double turn = Math.IEEEremainder(degrees, 360);
        long quarters = Math.round(turn / 90);
        double rest = StrictMath.toRadians(turn - 90.0 * quarters);
        double s = StrictMath.sin(rest);
        double c = StrictMath.cos(rest);
        boolean odd = (quarters & 1) != 0;
        boolean sineNegative = (quarters & 2) != 0;
        boolean cosineNegative = ((quarters + 1) & 2) != 0;
        double sine = (sineNegative ? -1 : 1) * (odd ? c : s);
        double cosine = (cosineNegative ? -1 : 1) * (odd ? s : c);
        double x = axis.x();
        double y = axis.y();
        double z = axis.z();
        double versine = 1 - cosine;
        return new Matrix(
                cosine + x * x * versine,
                x * y * versine - z * sine,
                x * z * versine + y * sine,
                y * x * versine + z * sine,
                cosine + y * y * versine,
                y * z * versine - x * sine,
                z * x * versine - y * sine,
                z * y * versine + x * sine,
                cosine + z * z * versine);
    }

    public Matrix times(Matrix o) {
        return ofColumns(
                times(new Vector3(o.xx, o.yx, o.zx)),
                times(new Vector3(o.xy, o.yy, o.zy)),
                times(new Vector3(o.xz, o.yz, o.zz)));
    }

    public Vector3 times(Vector3 v) {
        return new Vector3(timesX(v.x(), v.y(), v.z()), timesY(v.x(), v.y(), v.z()), timesZ(v.x(), v.y(), v.z()));
    }

    /** The x component of this · (x, y, z), and so on: for loops that allocate nothing. */
    public double timesX(double x, double y, double z) {
        return xx * x + xy * y + xz * z;
    }

    public double timesY(double x, double y, double z) {
        return yx * x + yy * y + yz * z;
    }

    public double timesZ(double x, double y, double z) {
        return zx * x + zy * y + zz * z;
    }

    /** The x component of the transpose of this · (x, y, z), and so on. */
    public double transposedTimesX(double x, double y, double z) {
        return xx * x + yx * y + zx * z;
    }

    public double transposedTimesY(double x, double y, double z) {
        return xy * x + yy * y + zy * z;
    }

    public double transposedTimesZ(double x, double y, double z) {
        return xz * x + yz * y + zz * z;
    }

    public Matrix transpose() {
        return new Matrix(xx, yx, zx, xy, yy, zy, xz, yz, zz);
    }

    /** Every component without its sign. */
    public Matrix absolute() {
        return new Matrix(
                Math.abs(xx),
                Math.abs(xy),
                Math.abs(xz),
                Math.abs(yx),
                Math.abs(yy),
                Math.abs(yz),
                Math.abs(zx),
                Math.abs(zy),
                Math.abs(zz));
    }

    /** A factor by which no vector grows more: the Frobenius norm. */
    public double norm() {
        return Arithmetic.length(
                Arithmetic.length(xx, xy, xz), Arithmetic.length(yx, yy, yz), Arithmetic.length(zx, zy, zz));
    }

    /**
     * The inverse, by cofactors without cancellation error in each.
     *
     * @throws IllegalArgumentException if there is none within rounding
     */
    public Matrix inverse() {
        Vector3 x = new Vector3(xx, yx, zx);
        Vector3 y = new Vector3(xy, yy, zy);
        Vector3 z = new Vector3(xz, yz, zz);
        double volume = x.length() * y.length() * z.length();
        double determinant = x.dot(y.cross(z));
        if (!isFinite() || !(Math.abs(determinant) > Arithmetic.gamma(8) * volume)) {
            throw new IllegalArgumentException("a transform must be finite and invertible, but is " + this);
        }
        Matrix cofactors = ofColumns(y.cross(z), z.cross(x), x.cross(y)).transpose();
        return cofactors.times(diagonal(1 / determinant, 1 / determinant, 1 / determinant));
    }

    public boolean isFinite() {
        return Double.isFinite(norm());
    }
}
