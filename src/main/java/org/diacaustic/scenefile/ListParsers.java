package org.diacaustic.scenefile;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Function;
import org.diacaustic.math.Vector3;
import org.diacaustic.scenefile.Node.Sequence;

/** Reads lists of numbers and of vectors. Each wrong component is a problem of its own, at its own place. */
final class ListParsers {
    /** For {@link #numbers}: any count is right. */
    static final int ANY_COUNT = -1;

    private ListParsers() {}

    /** The finite numbers of a list; nothing after adding problems. */
    static Optional<double[]> numbers(Slot slot, int count, String expected, Range each) {
        if (!(slot.node() instanceof Sequence list)
                || count != ANY_COUNT && list.items().size() != count) {
            slot.unexpected(expected);
            return Optional.empty();
        }
        double[] values = new double[list.items().size()];
        boolean sound = true;
        String component = each.describe("a number");
        int index = 0;
        for (Slot item : slot.items(list)) {
            OptionalDouble number = NumberText.parse(item, component, false);
            if (number.isPresent() && !each.contains(number.getAsDouble())) {
                item.unexpected(component);
                number = OptionalDouble.empty();
            }
            sound &= number.isPresent();
            values[index++] = number.orElse(0);
        }
        return sound ? Optional.of(values) : Optional.empty();
    }

    static Optional<Vector3> vector3(Slot slot, String expected) {
        return numbers(slot, 3, expected, Range.ALL).map(v -> new Vector3(v[0], v[1], v[2]));
    }

    /** A vector with a direction, so not zero. */
    static Optional<Vector3> direction(Slot slot, String expected) {
        Optional<Vector3> vector = vector3(slot, expected);
        if (vector.isPresent() && vector.get().length() == 0) {
            slot.error("expected " + expected + ", found the zero vector");
            return Optional.empty();
        }
        return vector;
    }

    /** Every item of a list by {@code each}; nothing if the list is too short or one of them is wrong. */
    static <T> Optional<List<T>> items(Slot slot, int atLeast, String expected, Function<Slot, Optional<T>> each) {
        if (!(slot.node() instanceof Sequence list) || list.items().size() < atLeast) {
            slot.unexpected(expected);
            return Optional.empty();
        }
        List<T> values = new ArrayList<>();
        for (Slot item : slot.items(list)) {
            each.apply(item).ifPresent(values::add);
        }
        return values.size() == list.items().size() ? Optional.of(values) : Optional.empty();
    }
}
