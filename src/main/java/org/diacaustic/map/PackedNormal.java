package org.diacaustic.map;

/**
 * A direction in 32 bits: the octahedron |x| + |y| + |z| = 1 unfolded to a square of 65534 × 65534 steps [Meyer et al.
 * 2010]. The number of steps is even, so that the axes are exact; no direction is off by more than 2^-15 radians.
 */
final class PackedNormal {
    private static final double HALF_STEPS = 32767;

    private PackedNormal() {}

    /** Packs a direction of any length but 0. */
    static int of(double x, double y, double z) {
        double sum = Math.abs(x) + Math.abs(y) + Math.abs(z);
        double p = x / sum;
        double q = y / sum;
        if (z < 0) {
            double folded = (1 - Math.abs(q)) * Math.copySign(1, p);
            q = (1 - Math.abs(p)) * Math.copySign(1, q);
            p = folded;
        }
        int high = (int) Math.rint((p + 1) * HALF_STEPS);
        int low = (int) Math.rint((q + 1) * HALF_STEPS);
        return high << 16 | low;
    }

    /** Sets the normal of {@code out} to the direction. */
    static void unpack(int packed, SurfacePoint out) {
        double p = (packed >>> 16) / HALF_STEPS - 1;
        double q = (packed & 0xFFFF) / HALF_STEPS - 1;
        double z = 1 - Math.abs(p) - Math.abs(q);
        double fold = Math.max(-z, 0);
        double x = p - Math.copySign(fold, p);
        double y = q - Math.copySign(fold, q);
        double length = Math.sqrt(x * x + y * y + z * z);
        out.normalX = x / length;
        out.normalY = y / length;
        out.normalZ = z / length;
    }

    /** Whether the direction is within an angle below 90° of a unit vector, the cosine of which is given. */
    static boolean isWithin(int packed, double cosine, double ux, double uy, double uz) {
        double p = (packed >>> 16) / HALF_STEPS - 1;
        double q = (packed & 0xFFFF) / HALF_STEPS - 1;
        double z = 1 - Math.abs(p) - Math.abs(q);
        double fold = Math.max(-z, 0);
        double x = p - Math.copySign(fold, p);
        double y = q - Math.copySign(fold, q);
        double along = x * ux + y * uy + z * uz;
        return along > 0 && along * along >= cosine * cosine * (x * x + y * y + z * z);
    }
}
