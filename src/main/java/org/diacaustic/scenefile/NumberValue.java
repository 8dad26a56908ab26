package org.diacaustic.scenefile;

import java.util.Optional;
import java.util.OptionalDouble;

/** A number that has been asked for, with its range and unit: {@code number("radius").above(0).required()}. */
final class NumberValue extends Value<Double> {
    private Range range = Range.ALL;
    private String unit = "";
    private boolean infinityAllowed;

    NumberValue(Slot slot) {
        super(slot);
    }

    public NumberValue above(double bound) {
        range = range.above(bound);
        return this;
    }

    public NumberValue atLeast(double bound) {
        range = range.atLeast(bound);
        return this;
    }

    public NumberValue below(double bound) {
        range = range.below(bound);
        return this;
    }

    public NumberValue atMost(double bound) {
        range = range.atMost(bound);
        return this;
    }

    /** Names the unit in messages, such as {@code degrees}. */
    public NumberValue in(String plural) {
        unit = ", in " + plural;
        return this;
    }

    /** Allows {@code .inf} where the range does. */
    public NumberValue orInfinite() {
        infinityAllowed = true;
        return this;
    }

    @Override
    String expected() {
        return range.describe("a number") + unit;
    }

    @Override
    Double harmless() {
        return range.inside();
    }

    @Override
    Optional<Double> parse() {
        OptionalDouble number = NumberText.parse(slot, expected(), infinityAllowed);
        if (number.isPresent() && !range.contains(number.getAsDouble())) {
            slot.unexpected(expected());
            return Optional.empty();
        }
        return number.isPresent() ? Optional.of(number.getAsDouble()) : Optional.empty();
    }
}
