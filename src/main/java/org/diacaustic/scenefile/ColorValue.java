package org.diacaustic.scenefile;

import java.util.Optional;
import java.util.OptionalDouble;
import org.diacaustic.math.Color;
import org.diacaustic.scenefile.Node.Sequence;

/** A colour that has been asked for: three numbers, or one for grey, each in a range. */
final class ColorValue extends Value<Color> {
    private Range range = Range.ALL;

    ColorValue(Slot slot) {
        super(slot);
    }

    public ColorValue atLeast(double bound) {
        range = range.atLeast(bound);
        return this;
    }

    public ColorValue atMost(double bound) {
        range = range.atMost(bound);
        return this;
    }

    @Override
    String expected() {
        return "a colour, [red, green, blue] or one number for grey"
                + (range.isWhole() ? "" : ", each " + range.describe("").strip());
    }

    @Override
    Color harmless() {
        return Color.grey(range.inside());
    }

    @Override
    Optional<Color> parse() {
        if (slot.node() instanceof Sequence) {
            return ListParsers.numbers(slot, 3, expected(), range).map(c -> new Color(c[0], c[1], c[2]));
        }
        OptionalDouble grey = NumberText.parse(slot, expected(), false);
        if (grey.isPresent() && !range.contains(grey.getAsDouble())) {
            slot.unexpected(expected());
            return Optional.empty();
        }
        return grey.isPresent() ? Optional.of(Color.grey(grey.getAsDouble())) : Optional.empty();
    }
}
