package org.diacaustic.study;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;

/** The techniques that a study knows by name. */
public final class Techniques {
    private static final List<Technique> KNOWN = List.of(
            over("caustic-mesh", "map=caustic-mesh"),
            into("light-tracing", "preprocessor=random"),
            over("random-photons", "preprocessor=random", "map=photon-map", "estimator=nearest"),
            over("planar-photons", "preprocessor=planar", "map=photon-map", "estimator=nearest"),
            over("adaptive-photons", "preprocessor=adaptive", "map=photon-map", "estimator=nearest"),
            over("progressive", "preprocessor=planar", "map=photon-map", "estimator=progressive", "passes=16"),
            over("ambient-maps", "preprocessor=planar", "map=ambient-maps", "estimator=density"));

    private Techniques() {}

    /** Those that are compared if nothing else is said. */
    public static List<Technique> known() {
        return KNOWN;
    }

    /**
     * Reads a list such as {@code light-tracing,planar-photons,mine:map=photon-map:gather-count=200}: names of known
     * techniques, and names of one's own with keys of the scene's settings.
     *
     * @throws IllegalArgumentException if a name is unknown or said twice, or a key has no value
     */
    public static List<Technique> parse(String text) {
        Map<String, Technique> techniques = new LinkedHashMap<>();
        for (String word : text.split(",")) {
            Technique technique = word.contains(":") ? own(word) : named(word.strip());
            if (techniques.putIfAbsent(technique.name(), technique) != null) {
                throw new IllegalArgumentException("two techniques are named '" + technique.name() + "'");
            }
        }
        return new ArrayList<>(techniques.values());
    }

    private static Technique named(String name) {
        return KNOWN.stream()
                .filter(technique -> technique.name().equals(name))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException("unknown technique '" + name + "'; known are "
                        + KNOWN.stream().map(Technique::name).collect(Collectors.joining(", "))
                        + ", and NAME:key=value:key=value"));
    }

    private static Technique own(String word) {
        String[] parts = word.strip().split(":");
        String name = parts.length == 0 ? "" : parts[0];
        // A file is named after it.
        if (!name.matches("[A-Za-z0-9_.-]+")) {
            throw new IllegalArgumentException(
                    "a technique's name must be of letters, digits, '-', '_' and '.', but is '" + name + "'");
        }
        return over(name, List.of(parts).subList(1, parts.length).toArray(String[]::new));
    }

    private static Technique over(String name, String... settings) {
        return new Technique(name, Technique.Way.OVER_A_MAP, pairs(name, settings));
    }

    private static Technique into(String name, String... settings) {
        return new Technique(name, Technique.Way.INTO_PIXELS, pairs(name, settings));
    }

    private static Map<String, String> pairs(String name, String... settings) {
        Map<String, String> pairs = new LinkedHashMap<>();
        for (String setting : settings) {
            int equals = setting.indexOf('=');
            if (equals < 1) {
                throw new IllegalArgumentException(
                        "technique '" + name + "': expected key=value, found '" + setting + "'");
            }
            pairs.put(setting.substring(0, equals), setting.substring(equals + 1));
        }
        return pairs;
    }
}
