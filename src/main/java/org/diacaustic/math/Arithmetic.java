package org.diacaustic.math;

/** Small exact and nearly exact operations on doubles that the rest is built on. */
public final class Arithmetic {
    /** Half the distance from 1 to the next double: the largest relative error of one rounded operation. */
    public static final double UNIT_ROUNDOFF = 0x1p-53;

    private Arithmetic() {}

    /**
     * a·b − c·d with an error below 1.5 units in the last place, however much cancels [Kahan 2004; Jeannerod, Louvet
     * and Muller 2013].
     */
    public static double differenceOfProducts(double a, double b, double c, double d) {
        double cd = c * d;
        double roundingOfCd = Math.fma(-c, d, cd);
        return Math.fma(a, b, -cd) + roundingOfCd;
    }

    /** The bound γₙ = n·u / (1 − n·u) on the relative error of n rounded operations [Higham 2002, 3.1]. */
    public static double gamma(int operations) {
        double nu = operations * UNIT_ROUNDOFF;
        return nu / (1 - nu);
    }

    /** The length of (x, y, z), right for any finite components. */
    public static double length(double x, double y, double z) {
        double squared = x * x + y * y + z * z;
        if (squared > 0x1p-900 && squared < 0x1p1000) {
            return Math.sqrt(squared);
        }
        double largest = Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z)));
        if (largest == 0 || !(largest < Double.POSITIVE_INFINITY)) {
            return largest;
        }
        double scale = powerOfTwoNear(largest);
        double px = x / scale;
        double py = y / scale;
        double pz = z / scale;
        return scale * Math.sqrt(px * px + py * py + pz * pz);
    }

    /** The power of two at or just below a positive finite value, so that dividing by it changes no digit. */
    public static double powerOfTwoNear(double value) {
        return Math.scalb(1.0, Math.max(Double.MIN_EXPONENT, Math.min(Math.getExponent(value), Double.MAX_EXPONENT)));
    }

    /** {@code value} kept within {@code low} and {@code high}; NaN stays NaN. */
    public static double clamp(double value, double low, double high) {
        return Math.max(low, Math.min(high, value));
    }
}
