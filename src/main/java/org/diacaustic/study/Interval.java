package org.diacaustic.study;

/** A range of numbers; both ends are not a number if nothing is known. */
public record Interval(double low, double high) {
    /** Nothing is known. */
    public static final Interval UNKNOWN = new Interval(Double.NaN, Double.NaN);

    public boolean contains(double value) {
        return value >= low && value <= high;
    }
}
