package org.diacaustic.render;

import java.util.OptionalDouble;
import java.util.OptionalLong;

/**
 * What a {@link Refinement} goes for: a small error, a time to be ready, or whichever comes first.
 *
 * @param error the largest estimated error of the picture: root of the mean square ÷ mean; positive
 * @param deadline when the picture is to be there, by {@link System#nanoTime()}
 */
public record Goal(OptionalDouble error, OptionalLong deadline) {

    /** @throws IllegalArgumentException if there is neither, or the error is not positive */
    public Goal {
        if (error.isEmpty() && deadline.isEmpty()) {
            throw new IllegalArgumentException("a goal needs an error or a deadline");
        }
        if (error.isPresent() && !(error.getAsDouble() > 0)) {
            throw new IllegalArgumentException("an error to go for must be above 0, but is " + error.getAsDouble());
        }
    }

    /** An error to go for. */
    public static Goal ofError(double largest) {
        return new Goal(OptionalDouble.of(largest), OptionalLong.empty());
    }

    /** A time to be ready, by {@link System#nanoTime()}. */
    public static Goal until(long nanoTime) {
        return new Goal(OptionalDouble.empty(), OptionalLong.of(nanoTime));
    }

    /** Whether an error is asked for and this one is as small; not if it is not a number. */
    boolean isReachedBy(double estimate) {
        return error.isPresent() && estimate <= error.getAsDouble();
    }

    /** The seconds until the deadline, negative after it; infinity if there is none. */
    double secondsLeft() {
        return deadline.isPresent() ? (deadline.getAsLong() - System.nanoTime()) * 1e-9 : Double.POSITIVE_INFINITY;
    }
}
