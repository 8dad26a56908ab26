package org.diacaustic.math;

/**
 * A long sum of doubles that loses almost nothing: second-order compensated summation [Klein 2006, "A Generalized
 * Kahan-Babuška-Summation-Algorithm"].
 */
public final class CompensatedSum {
    private double sum;
    private double first;
    private double second;

    public void add(double value) {
        double total = sum + value;
        double lost = Math.abs(sum) >= Math.abs(value) ? (sum - total) + value : (value - total) + sum;
        sum = total;
        total = first + lost;
        double lostAgain = Math.abs(first) >= Math.abs(lost) ? (first - total) + lost : (lost - total) + first;
        first = total;
        second += lostAgain;
    }

    /** The sum; infinite or not a number if that is what the plain sum is. */
    public double value() {
        return Double.isFinite(sum) ? sum + (first + second) : sum;
    }
}
