package org.diacaustic.image;

/** A sum whose error does not grow with the number of terms [Neumaier 1974]. */
final class CompensatedSum {
    private double sum;
    private double lost;

    void add(double term) {
        double next = sum + term;
        lost += Math.abs(sum) >= Math.abs(term) ? sum - next + term : term - next + sum;
        sum = next;
    }

    double value() {
        // With an infinite term, what was lost is not a number.
        return Double.isInfinite(sum) ? sum : sum + lost;
    }
}
