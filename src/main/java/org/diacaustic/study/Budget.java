package org.diacaustic.study;

import java.util.Locale;

/** What one picture may cost. */
public sealed interface Budget {

    /** As it is written on the command line, and in names of files. */
    String label();

    /** Light rays, or seconds. */
    double amount();

    /**
     * A number of light rays to choose, in all passes together: the same picture every time.
     *
     * @param count at least 1
     */
    record Rays(long count) implements Budget {
        public Rays {
            if (count < 1) {
                throw new IllegalArgumentException("a budget must be of at least 1 light ray, but is of " + count);
            }
        }

        @Override
        public String label() {
            return Long.toString(count);
        }

        @Override
        public double amount() {
            return count;
        }
    }

    /**
     * About a time, on the clock. How many rays that makes depends on the machine, and is found by trying.
     *
     * @param count positive
     */
    record Seconds(double count) implements Budget {
        public Seconds {
            if (!(count > 0 && count < Double.POSITIVE_INFINITY)) {
                throw new IllegalArgumentException("a budget must be of a positive time, but is of " + count + " s");
            }
        }

        @Override
        public String label() {
            return String.format(Locale.ROOT, count == Math.rint(count) ? "%.0fs" : "%ss", count);
        }

        @Override
        public double amount() {
            return count;
        }
    }
}
