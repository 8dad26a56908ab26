package org.diacaustic.scenefile;

import java.util.Optional;
import java.util.function.Function;

/**
 * A value that has been asked for and not yet read. One that breaks its rule adds a problem when it is read, and a
 * harmless value that keeps the rule stands in for it, so that reading goes on to the next problem. Read it once.
 */
abstract class Value<T> {
    final Slot slot;

    Value(Slot slot) {
        this.slot = slot;
    }

    /** The value; a problem if it is missing. */
    public final T required() {
        if (slot.isAbsent()) {
            slot.missing(expected());
            return harmless();
        }
        return parse().orElseGet(this::harmless);
    }

    /** The value, or {@code fallback} if it is missing. */
    public final T or(T fallback) {
        return optional().orElse(fallback);
    }

    /** The value, or nothing if it is missing. */
    public final Optional<T> optional() {
        return slot.isAbsent() ? Optional.empty() : parse();
    }

    /** The rule in words, as in "expected …". */
    abstract String expected();

    /** What stands in for a wrong or missing value. */
    abstract T harmless();

    /** The value of a slot that is not absent; nothing after adding a problem. */
    abstract Optional<T> parse();

    static <T> Value<T> of(Slot slot, String expected, T harmless, Function<Slot, Optional<T>> parser) {
        return new Value<>(slot) {
            @Override
            String expected() {
                return expected;
            }

            @Override
            T harmless() {
                return harmless;
            }

            @Override
            Optional<T> parse() {
                return parser.apply(slot);
            }
        };
    }
}
