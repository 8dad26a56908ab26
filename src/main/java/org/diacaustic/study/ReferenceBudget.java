package org.diacaustic.study;

/** How much is spent on a reference. */
public sealed interface ReferenceBudget {

    /**
     * A number of light rays: the same picture every time.
     *
     * @param count rays chosen, at least 1
     */
    record Rays(long count) implements ReferenceBudget {
        public Rays {
            if (count < 1) {
                throw new IllegalArgumentException("a reference needs at least 1 light ray, but has " + count);
            }
        }
    }

    /**
     * A time, about. How many rays that makes depends on the machine.
     *
     * @param count wall clock, positive
     */
    record Seconds(double count) implements ReferenceBudget {
        public Seconds {
            if (!(count > 0 && count < Double.POSITIVE_INFINITY)) {
                throw new IllegalArgumentException("a reference needs a positive time, but has " + count + " s");
            }
        }
    }
}
