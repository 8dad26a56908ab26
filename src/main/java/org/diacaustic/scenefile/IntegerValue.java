package org.diacaustic.scenefile;

import java.util.Optional;
import java.util.OptionalLong;
import java.util.function.LongFunction;

/** A whole number that has been asked for, with its range: {@code integer("samples").atLeast(1).or(16)}. */
final class IntegerValue<T> extends Value<T> {
    private final LongFunction<T> convert;
    private final long lowest;
    private final long highest;
    private long low;
    private long high;

    private IntegerValue(Slot slot, long lowest, long highest, LongFunction<T> convert) {
        super(slot);
        this.convert = convert;
        this.lowest = lowest;
        this.highest = highest;
        low = lowest;
        high = highest;
    }

    static IntegerValue<Integer> ofInt(Slot slot) {
        return new IntegerValue<>(slot, Integer.MIN_VALUE, Integer.MAX_VALUE, value -> (int) value);
    }

    static IntegerValue<Long> ofLong(Slot slot) {
        return new IntegerValue<>(slot, Long.MIN_VALUE, Long.MAX_VALUE, value -> value);
    }

    public IntegerValue<T> atLeast(long bound) {
        low = Math.max(lowest, bound);
        return this;
    }

    public IntegerValue<T> atMost(long bound) {
        high = Math.min(highest, bound);
        return this;
    }

    @Override
    String expected() {
        if (low > lowest && high < highest) {
            return "a whole number from " + low + " to " + high;
        }
        return "a whole number"
                + (low > lowest ? " of at least " + low : "")
                + (high < highest ? " of at most " + high : "");
    }

    @Override
    T harmless() {
        return convert.apply(Math.min(high, Math.max(low, 0)));
    }

    @Override
    Optional<T> parse() {
        OptionalLong whole = NumberText.parseWhole(slot, expected());
        if (whole.isEmpty()) {
            return Optional.empty();
        }
        long value = whole.getAsLong();
        if (value < low || value > high) {
            boolean representable = value >= lowest && value <= highest;
            slot.error("expected " + expected() + ", found " + slot.node().describe()
                    + (representable ? "" : ", beyond the largest of " + highest));
            return Optional.empty();
        }
        return Optional.of(convert.apply(value));
    }
}
