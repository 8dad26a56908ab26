package org.diacaustic.map;

import org.diacaustic.math.Rgb;

/** A direction in 32 bits: the octahedron unfolded to a square of 65535 × 65535 steps [Meyer et al. 2010]. */
final class PackedNormal {
    private static final double STEPS = 65535;

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
        int high = (int) Math.rint((p + 1) / 2 * STEPS);
        int low = (int) Math.rint((q + 1) / 2 * STEPS);
        return high << 16 | low;
    }

    /** Sets {@code out} to the direction (red, green, blue being x, y, z), not normalised: its |x| + |y| + |z| is 1. */
    static void unpack(int packed, Rgb out) {
        double p = (packed >>> 16) / STEPS * 2 - 1;
        double q = (packed & 0xFFFF) / STEPS * 2 - 1;
        double z = 1 - Math.abs(p) - Math.abs(q);
        if (z < 0) {
            double unfolded = (1 - Math.abs(q)) * Math.copySign(1, p);
            q = (1 - Math.abs(p)) * Math.copySign(1, q);
            p = unfolded;
        }
        out.set(p, q, z);
    }
}
