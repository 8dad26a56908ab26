package org.diacaustic.scenefile;

import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.diacaustic.scenefile.Node.Scalar;

/** Reads text, flags, names and file names. Each gives nothing after adding a problem. */
final class Scalars {
    /** True and false in YAML 1.1, plain text in 1.2. */
    private static final Set<String> OLD_FLAGS = Set.of("yes", "no", "on", "off", "y", "n");

    private Scalars() {}

    static Optional<String> text(Slot slot) {
        return text(slot, "text");
    }

    private static Optional<String> text(Slot slot, String expected) {
        if (slot.node() instanceof Scalar scalar && !scalar.isNull()) {
            return Optional.of(scalar.text());
        }
        slot.unexpected(expected);
        return Optional.empty();
    }

    static Optional<Boolean> flag(Slot slot) {
        String text = slot.node() instanceof Scalar scalar && scalar.plain() ? scalar.text() : "";
        switch (text) {
            case "true", "True", "TRUE" -> {
                return Optional.of(true);
            }
            case "false", "False", "FALSE" -> {
                return Optional.of(false);
            }
            default -> {
                boolean old = OLD_FLAGS.contains(text.toLowerCase(java.util.Locale.ROOT));
                slot.error("expected true or false, found " + slot.node().describe()
                        + (old ? ", which is text in YAML 1.2" : ""));
                return Optional.empty();
            }
        }
    }

    static <T> Optional<T> choice(Slot slot, String expected, Map<String, T> values) {
        Optional<String> name = text(slot, expected);
        if (name.isPresent() && !values.containsKey(name.get())) {
            String suggestion = Suggestions.forWord(name.get(), values.keySet());
            slot.error("expected " + expected + ", found " + slot.node().describe()
                    + (suggestion.contains("did you mean") ? suggestion : ""));
        }
        return name.map(values::get);
    }

    static Optional<Path> file(Slot slot) {
        return text(slot, "a file name").flatMap(name -> slot.section().files().resolve(name, slot));
    }
}
