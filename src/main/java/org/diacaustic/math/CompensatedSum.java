package org.diacaustic.math;

import java.util.Arrays;

/**
 * A sum of doubles without any error but that of rounding the result once: it is kept as numbers of different sizes that do not
 * overlap, of which there are seldom more than three [Shewchuk 1997, "Adaptive Precision Floating-Point Arithmetic and
 * Fast Robust Geometric Predicates"]. It does not depend on the order, unless the sum leaves the range of doubles on the way.
 */
public final class CompensatedSum {
    /** In ascending order of size. */
    private double[] parts = new double[4];

    private int count;
    private double plain;

    public void add(double value) {
        plain += value;
        if (!Double.isFinite(plain)) {
            return;
        }
        double carried = value;
        int kept = 0;
        for (int i = 0; i < count; i++) {
            double part = parts[i];
            double sum = carried + part;
            double lost = Math.abs(carried) >= Math.abs(part) ? (carried - sum) + part : (part - sum) + carried;
            if (lost != 0) {
                parts[kept++] = lost;
            }
            carried = sum;
        }
        if (kept == parts.length) {
            parts = Arrays.copyOf(parts, 2 * kept);
        }
        parts[kept++] = carried;
        count = kept;
    }

    /** The double nearest to the sum; infinite or not a number from where on the plain sum is. */
    public double value() {
        if (!Double.isFinite(plain)) {
            return plain;
        }
        double sum = 0;
        double lost = 0;
        int left = count;
        while (left > 0 && lost == 0) {
            double part = parts[--left];
            double next = sum + part;
            lost = part - (next - sum);
            sum = next;
        }
        // Half a unit in the last place is rounded to even: but the parts below tell on which side of the half it is.
        if (left > 0 && lost != 0 && lost > 0 == parts[left - 1] > 0) {
            double twice = 2 * lost;
            double other = sum + twice;
            sum = other - sum == twice ? other : sum;
        }
        return sum;
    }
}
