package org.diacaustic.scenefile;

/** The numbers that a value may have: one end or both, each counted in or not. */
record Range(double low, boolean lowIncluded, double high, boolean highIncluded) {
    static final Range ALL = new Range(Double.NEGATIVE_INFINITY, true, Double.POSITIVE_INFINITY, true);

    Range above(double bound) {
        return new Range(bound, false, high, highIncluded);
    }

    Range atLeast(double bound) {
        return new Range(bound, true, high, highIncluded);
    }

    Range below(double bound) {
        return new Range(low, lowIncluded, bound, false);
    }

    Range atMost(double bound) {
        return new Range(low, lowIncluded, bound, true);
    }

    boolean contains(double value) {
        return (lowIncluded ? value >= low : value > low) && (highIncluded ? value <= high : value < high);
    }

    boolean isWhole() {
        return low == Double.NEGATIVE_INFINITY && high == Double.POSITIVE_INFINITY;
    }

    /** Some number of the range, near its lower end if it has one. */
    double inside() {
        if (Double.isInfinite(low)) {
            return Double.isInfinite(high) ? 0 : highIncluded ? high : high - 1;
        }
        return lowIncluded ? low : Double.isInfinite(high) ? low + 1 : low + (high - low) / 2;
    }

    /** As in "a number above 0 and below 180"; {@code noun} alone if every number is allowed. */
    String describe(String noun) {
        String lower = Double.isInfinite(low) ? "" : (lowIncluded ? " of at least " : " above ") + shortest(low);
        String upper = Double.isInfinite(high) ? "" : (highIncluded ? " of at most " : " below ") + shortest(high);
        if (!lower.isEmpty() && !upper.isEmpty() && lowIncluded && highIncluded) {
            return noun + " from " + shortest(low) + " to " + shortest(high);
        }
        return noun + lower + (lower.isEmpty() || upper.isEmpty() ? "" : " and") + upper;
    }

    private static String shortest(double value) {
        return value == Math.rint(value) && Math.abs(value) < 1e15
                ? Long.toString((long) value)
                : Double.toString(value);
    }
}
