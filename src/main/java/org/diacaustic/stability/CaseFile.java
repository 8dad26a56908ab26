package org.diacaustic.stability;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.snakeyaml.engine.v2.api.Load;
import org.snakeyaml.engine.v2.api.LoadSettings;
import org.snakeyaml.engine.v2.exceptions.YamlEngineException;

/** Reads files of numeric cases: JSON of the schema {@code caustics-numerics/1}. */
public final class CaseFile {
    private static final String SCHEMA = "caustics-numerics/1";
    private static final String BUNDLED = "cases.json";

    private CaseFile() {}

    /** The cases that come along. */
    public static List<NumericCase> bundled() {
        try (InputStream in = CaseFile.class.getResourceAsStream(BUNDLED)) {
            return read(new String(in.readAllBytes(), StandardCharsets.UTF_8), BUNDLED);
        } catch (IOException unreadable) {
            throw new UncheckedIOException(unreadable);
        }
    }

    /**
     * The cases of a file.
     *
     * @throws IOException if it cannot be read
     * @throws CaseFileException if it is not a file of cases
     */
    public static List<NumericCase> read(Path file) throws IOException {
        return read(Files.readString(file), file.toString());
    }

    /**
     * The cases of a text.
     *
     * @param place what faults call it
     * @throws CaseFileException if it is not one of cases
     */
    static List<NumericCase> read(String text, String place) {
        Map<?, ?> root = map(parse(text, place), place, "an object of cases");
        if (!SCHEMA.equals(root.get("schema"))) {
            throw new CaseFileException(place + ": schema should be " + SCHEMA + ", but is " + root.get("schema"));
        }
        if (!(root.get("cases") instanceof List<?> listed)) {
            throw new CaseFileException(place + ": cases should be a list");
        }
        List<NumericCase> cases = new ArrayList<>();
        Set<String> ids = new HashSet<>();
        for (Object one : listed) {
            String at = place + ": case " + (cases.size() + 1);
            NumericCase next = numericCase(map(one, at, "an object"), at);
            if (!ids.add(next.id())) {
                throw new CaseFileException(at + ": the id " + next.id() + " is used twice");
            }
            cases.add(next);
        }
        return cases;
    }

    private static Object parse(String text, String place) {
        LoadSettings settings = LoadSettings.builder()
                .setCodePointLimit(Integer.MAX_VALUE)
                .setLabel(place)
                .build();
        try {
            return new Load(settings).loadFromString(text);
        } catch (YamlEngineException malformed) {
            throw new CaseFileException(
                    place + ": " + malformed.getMessage().strip().replaceAll("\\s*\\R\\s*", "; "));
        }
    }

    private static NumericCase numericCase(Map<?, ?> members, String at) {
        return new NumericCase(
                text(members, "id", at),
                text(members, "category", at),
                text(members, "title", at),
                text(members, "op", at),
                values(members, "inputs", at),
                values(members, "expected", at),
                values(members, "tolerance", at),
                members.get("acceptable") instanceof List<?> list
                        ? list.stream().map(String::valueOf).toList()
                        : List.of(),
                members.containsKey("typical_failure") ? String.valueOf(members.get("typical_failure")) : "");
    }

    private static String text(Map<?, ?> members, String key, String at) {
        if (members.get(key) instanceof String text) {
            return text;
        }
        throw new CaseFileException(at + ": " + key + " should be a text, but is " + members.get(key));
    }

    private static Values values(Map<?, ?> members, String key, String at) {
        Object found = members.get(key);
        return Values.of(key, found == null ? Map.of() : map(found, at + ": " + key, "an object"));
    }

    private static Map<?, ?> map(Object found, String at, String wanted) {
        if (found instanceof Map<?, ?> map) {
            return map;
        }
        throw new CaseFileException(at + " should be " + wanted);
    }
}
