package org.diacaustic.scenefile;

import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import org.diacaustic.scenefile.Node.Entry;
import org.diacaustic.scenefile.Node.Mapping;

/** A mapping with exactly one key, which names the kind of what is described below it: {@code sphere: {radius: 1}}. */
final class Variant {
    private final Slot slot;

    Variant(Slot slot) {
        this.slot = slot;
    }

    /** The kind as it is written; empty if there is none. */
    public String kind() {
        return entry().map(entry -> entry.key().text()).orElse("");
    }

    /** The place of the kind's name. */
    public Place place() {
        return entry().map(entry -> entry.key().place()).orElse(slot.place());
    }

    /** The keys that lead here, with the kind: {@code objects[2].sphere}. */
    public String path() {
        return slot.path() + (kind().isEmpty() ? "" : "." + kind());
    }

    /**
     * Reads what is described by the reader of its kind, then reports the keys that this did not ask for.
     *
     * @return nothing if the kind is not known or anything below it is wrong; {@code problems} say why
     */
    public <T> Optional<T> read(Map<String, Function<MappingReader, T>> readers) {
        if (entry().isEmpty()) {
            if (!slot.isAbsent()) {
                slot.unexpected("a mapping with one key, one of " + String.join(", ", readers.keySet()));
            }
            return Optional.empty();
        }
        Function<MappingReader, T> reader = readers.get(kind());
        if (reader == null) {
            String advice = Suggestions.forWord(kind(), readers.keySet());
            slot.section().error(place(), slot.path(), "unknown kind '" + kind() + "'" + advice);
            return Optional.empty();
        }
        Entry entry = entry().get();
        MappingReader body =
                MappingReader.of(new Slot(slot.section(), path(), entry.value().place(), entry.value(), slot.silent()));
        T result = reader.apply(body);
        return body.finish() ? Optional.ofNullable(result) : Optional.empty();
    }

    private Optional<Entry> entry() {
        return slot.node() instanceof Mapping mapping && mapping.entries().size() == 1
                ? Optional.of(mapping.entries().get(0))
                : Optional.empty();
    }
}
