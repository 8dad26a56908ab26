package org.diacaustic.scenefile;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.diacaustic.math.Vector3;
import org.diacaustic.scenefile.Node.Entry;
import org.diacaustic.scenefile.Node.Mapping;
import org.diacaustic.scenefile.Node.Scalar;
import org.diacaustic.scenefile.Node.Sequence;

/**
 * Reads one mapping of keys to values. Ask for each key by its type, then call {@link #finish}, which reports the keys
 * that nobody asked for. Nothing here throws for what a file holds: every problem is added to {@link Problems} with
 * its place, and reading goes on with a harmless value.
 *
 * <pre>{@code
 * Vector3 centre = sphere.vector3("at").required();
 * double radius = sphere.number("radius").above(0).required();
 * if (sphere.finish()) {
 *     return new Sphere(centre, radius);
 * }
 * }</pre>
 */
final class MappingReader {
    private final Section section;
    private final String path;
    private final Mapping mapping;
    private final Map<String, Entry> entries = new LinkedHashMap<>();
    private final Set<String> asked = new LinkedHashSet<>();
    private boolean finished;

    /** @param mapping null if it is missing or wrong, which has been told: then nothing more is */
    MappingReader(Section around, String path, Mapping mapping) {
        section = around.inside();
        this.path = path;
        this.mapping = mapping;
        if (mapping != null) {
            mapping.entries().forEach(this::index);
        }
    }

    private void index(Entry entry) {
        Entry first = entries.putIfAbsent(entry.key().text(), entry);
        if (first != null) {
            section.error(
                    entry.key().place(),
                    child(entry.key().text()),
                    "the key is there twice; the first is at line "
                            + first.key().place().line());
        }
    }

    /** A reader of the mapping in a slot, where nothing at all stands for an empty mapping. */
    static MappingReader of(Slot slot) {
        Mapping mapping = null;
        if (slot.node() instanceof Mapping found) {
            mapping = found;
        } else if (slot.node() instanceof Scalar scalar && scalar.isNull()) {
            mapping = new Mapping(slot.place(), List.of());
        } else if (!slot.isAbsent()) {
            slot.unexpected("a mapping of keys to values");
        }
        return new MappingReader(slot.section(), slot.path(), mapping);
    }

    public NumberValue number(String key) {
        return new NumberValue(slot(key));
    }

    /** A whole number that fits an int. */
    public IntegerValue<Integer> integer(String key) {
        return IntegerValue.ofInt(slot(key));
    }

    /** A whole number that fits a long, for seeds and counts of rays. */
    public IntegerValue<Long> longInteger(String key) {
        return IntegerValue.ofLong(slot(key));
    }

    /** Text, quoted or not; a number or flag in its place is taken as it is written. */
    public Value<String> text(String key) {
        return Value.of(slot(key), "text", "", Scalars::text);
    }

    /** {@code true} or {@code false}. */
    public Value<Boolean> flag(String key) {
        return Value.of(slot(key), "true or false", false, Scalars::flag);
    }

    /** One of the given names, in the map's order in messages; the first stands in for a wrong one. */
    public <T> Value<T> choice(String key, Map<String, T> values) {
        T first = values.values().iterator().next();
        String expected = "one of " + String.join(", ", values.keySet());
        return Value.of(slot(key), expected, first, slot -> Scalars.choice(slot, expected, values));
    }

    /** One of an enum's constants in kebab-case: {@code INVERSE_SQUARE} is written {@code inverse-square}. */
    public <E extends Enum<E>> Value<E> choice(String key, Class<E> type) {
        Map<String, E> values = new LinkedHashMap<>();
        for (E constant : type.getEnumConstants()) {
            values.put(constant.name().toLowerCase(Locale.ROOT).replace('_', '-'), constant);
        }
        return choice(key, values);
    }

    /** A point or offset: three finite numbers. */
    public Value<Vector3> vector3(String key) {
        String expected = "a list of 3 numbers";
        return Value.of(slot(key), expected, Vector3.ZERO, slot -> ListParsers.vector3(slot, expected));
    }

    /** Three finite numbers, not all zero, of any length. */
    public Value<Vector3> direction(String key) {
        String expected = "a direction, 3 numbers that are not all 0";
        return Value.of(slot(key), expected, Vector3.UNIT_Z, slot -> ListParsers.direction(slot, expected));
    }

    /** Two finite numbers. */
    public Value<double[]> vector2(String key) {
        return numbers(key, 2);
    }

    /** Exactly {@code count} finite numbers. */
    public Value<double[]> numbers(String key, int count) {
        String expected = "a list of " + count + " numbers";
        return Value.of(
                slot(key), expected, new double[count], slot -> ListParsers.numbers(slot, count, expected, Range.ALL));
    }

    /** Any count of finite numbers. */
    public Value<double[]> numbers(String key) {
        String expected = "a list of numbers";
        return Value.of(
                slot(key),
                expected,
                new double[0],
                slot -> ListParsers.numbers(slot, ListParsers.ANY_COUNT, expected, Range.ALL));
    }

    /** At least {@code atLeast} points. An empty list stands in for a wrong one. */
    public Value<List<Vector3>> points(String key, int atLeast) {
        String expected = "a list of at least " + atLeast + " points, each a list of 3 numbers";
        return Value.of(
                slot(key),
                expected,
                List.of(),
                slot -> ListParsers.items(
                        slot, atLeast, expected, item -> ListParsers.vector3(item, "a list of 3 numbers")));
    }

    public ColorValue color(String key) {
        return new ColorValue(slot(key));
    }

    public Value<List<String>> texts(String key) {
        return Value.of(
                slot(key),
                "a list of texts",
                List.of(),
                slot -> ListParsers.items(slot, 0, "a list of texts", Scalars::text));
    }

    /** The path of a file that is there and may be read, within what the document's {@link FileScope} allows. */
    public Value<Path> file(String key) {
        return Value.of(slot(key), "a file name", Path.of(""), Scalars::file);
    }

    /** The mapping under a key; a problem if it is missing. */
    public MappingReader mapping(String key) {
        Slot slot = slot(key);
        if (slot.isAbsent()) {
            slot.missing("a mapping of keys to values");
        }
        return of(slot);
    }

    /** The mapping under a key, or nothing if it is missing. */
    public Optional<MappingReader> optionalMapping(String key) {
        Slot slot = slot(key);
        return slot.isAbsent() ? Optional.empty() : Optional.of(of(slot));
    }

    /** The mapping under a key, or an empty one if it is missing: its defaults hold, its required keys are missed. */
    public MappingReader mappingOrEmpty(String key) {
        return optionalMapping(key)
                .orElseGet(() -> new MappingReader(
                        section, child(key), mapping == null ? null : new Mapping(mapping.place(), List.of())));
    }

    /** The mappings that a mapping holds, by name and in order, as in {@code materials}; none if it is missing. */
    public Map<String, MappingReader> namedMappings(String key) {
        Map<String, MappingReader> named = new LinkedHashMap<>();
        optionalMapping(key).ifPresent(names -> {
            for (String name : names.keys()) {
                named.put(name, names.mapping(name));
            }
        });
        return named;
    }

    /** The mappings of a list; none if it is missing. */
    public List<MappingReader> mappings(String key) {
        return listItems(key).stream().map(MappingReader::of).toList();
    }

    /** A mapping whose one key names a kind; a problem if it is missing. */
    public Variant variant(String key) {
        Slot slot = slot(key);
        if (slot.isAbsent()) {
            slot.missing("a mapping with one key that names a kind");
        }
        return new Variant(slot);
    }

    /** A list of mappings whose one key names a kind, as in {@code objects}; none if it is missing. */
    public List<Variant> variants(String key) {
        return listItems(key).stream().map(Variant::new).toList();
    }

    /** As {@link #variants(String)}; a problem if the list is missing or has fewer. */
    public List<Variant> variants(String key, int atLeast) {
        Slot slot = slot(key);
        String expected = "a list of at least " + atLeast + " mappings with one key that names a kind";
        if (slot.isAbsent()) {
            slot.missing(expected);
        } else if (slot.node() instanceof Sequence list && list.items().size() < atLeast) {
            slot.error("expected " + expected + ", found " + list.items().size());
        }
        return variants(key);
    }

    private List<Slot> listItems(String key) {
        Slot slot = slot(key);
        if (slot.node() instanceof Sequence list) {
            return slot.items(list);
        }
        if (!slot.isAbsent() && !(slot.node() instanceof Scalar scalar && scalar.isNull())) {
            slot.unexpected("a list");
        }
        return List.of();
    }

    /** What stands under a key, where more than one form is allowed. */
    public Form form(String key) {
        return Form.of(slot(key).node());
    }

    public boolean has(String key) {
        return !slot(key).isAbsent();
    }

    /** The keys as they stand in the file. */
    public List<String> keys() {
        return new ArrayList<>(entries.keySet());
    }

    /** The place of the mapping itself. */
    public Place place() {
        return mapping == null ? Place.of("") : mapping.place();
    }

    /** The keys that lead here, as {@code objects[2].sphere}; empty at the root. */
    public String path() {
        return path;
    }

    /** Adds an error about a key's value; about the mapping if the key is missing. */
    public void error(String key, String message) {
        slot(key).error(message);
    }

    /** Adds an error about the mapping itself. */
    public void error(String message) {
        if (mapping != null) {
            section.error(mapping.place(), path, message);
        }
    }

    /** Adds that the file named under a key cannot be read. */
    public void unreadable(String key, String message) {
        slot(key).unreadable(message);
    }

    /** Adds that what stands under a key is larger than we take on. */
    public void limit(String key, String message) {
        slot(key).limit(message);
    }

    public void warning(String key, String message) {
        slot(key).warning(message);
    }

    public void warning(String message) {
        if (mapping != null) {
            section.warning(mapping.place(), path, message);
        }
    }

    /**
     * Reports the keys that nobody asked for.
     *
     * @return whether the mapping is there and no error has been found in it or below it
     */
    public boolean finish() {
        for (Entry entry : finished ? List.<Entry>of() : entries.values()) {
            String key = entry.key().text();
            if (!asked.contains(key)) {
                section.error(entry.key().place(), child(key), "unknown key" + advice(entry));
                Suggestions.nearest(key, asked).ifPresent(meant -> section.misspelt(child(meant)));
            }
        }
        finished = true;
        return mapping != null && !section.isFlawed();
    }

    private String advice(Entry entry) {
        if (NumberText.isNumber(entry.key()) && entry.value() instanceof Scalar scalar && scalar.isNull()) {
            return "; if it belongs to a number before it, write that with a point, not a comma";
        }
        if (entry.key().text().equals("<<")) {
            return "; merging with << is not part of YAML 1.2";
        }
        return Suggestions.forWord(entry.key().text(), asked);
    }

    private Slot slot(String key) {
        asked.add(key);
        Entry entry = entries.get(key);
        Place place = entry != null ? entry.value().place() : place();
        return new Slot(section, child(key), place, entry == null ? null : entry.value(), mapping == null);
    }

    private String child(String key) {
        return path.isEmpty() ? key : path + "." + key;
    }
}
