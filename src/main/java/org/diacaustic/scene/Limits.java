package org.diacaustic.scene;

/** The checks that settings make of their numbers. */
final class Limits {
    private Limits() {}

    static int atLeast(String what, int value, int smallest) {
        return (int) atLeast(what, (long) value, smallest);
    }

    static long atLeast(String what, long value, long smallest) {
        if (value < smallest) {
            throw new IllegalArgumentException(what + " must be at least " + smallest + ", but is " + value);
        }
        return value;
    }

    /** As for whole numbers; refuses what is infinite or not a number too. */
    static double atLeast(String what, double value, double smallest) {
        if (!(value >= smallest && value < Double.POSITIVE_INFINITY)) {
            String bound = smallest == 0 ? "at least 0" : "above 0";
            throw new IllegalArgumentException(what + " must be finite and " + bound + ", but is " + value);
        }
        return value;
    }
}
