package org.diacaustic.render;

/**
 * Spreads a set of samples so that it leaves no large gap: each coordinate runs through the radical inverses of the
 * samples' numbers in a prime base of its own, or through equal strata, moved around the unit circle by a random shift
 * that all samples of the set share [Cranley and Patterson 1976].
 */
final class Stratification {
    private Stratification() {}

    /** The radical inverse of {@code i} in a base, moved by {@code shift} around the unit circle: 0..1. */
    static double shiftedInverse(int i, int base, double shift) {
        double inverse = 0;
        double digit = 1.0 / base;
        for (int rest = i; rest > 0; rest /= base) {
            inverse += (rest % base) * digit;
            digit /= base;
        }
        double shifted = inverse + shift;
        return shifted < 1 ? shifted : shifted - 1;
    }
}
