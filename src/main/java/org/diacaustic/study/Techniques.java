package org.diacaustic.study;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The techniques that a study knows by name: ours, and the thesis' ways to choose light rays with every way to read them. */
public final class Techniques {
    /** Rays of one pass of the progressive ones. */
    private static final long RAYS_A_PASS = 10_000;

    /** The thesis sends a thousand rays after every base ray that finds something, and cuts cells in 25: no budget can foresee that. */
    private static final Map<String, List<String>> WITHIN_BUDGET =
            Map.of("monte-carlo", List.of("batch-rays=4"), "adaptive", List.of("split=2"));

    private static final List<String> PRE_PROCESSORS = List.of("random", "monte-carlo", "planar", "cube", "adaptive");

    /** Those whose rays have neighbours. */
    private static final List<String> LATTICES = List.of("planar", "cube", "adaptive");

    private static final List<Technique> KNOWN = all();

    private static final List<String> QUICK = List.of(
            "caustic-mesh",
            "random-nearest",
            "monte-carlo-nearest",
            "planar-nearest",
            "adaptive-nearest",
            "planar-progressive",
            "planar-ambient-maps",
            "planar-expected-count");

    private Techniques() {}

    private static List<Technique> all() {
        List<Technique> all = new ArrayList<>();
        all.add(technique("caustic-mesh", "map=caustic-mesh"));
        LATTICES.forEach(
                name -> all.add(technique(name + "-caustic-mesh", "preprocessor=" + name, "map=caustic-mesh")));
        all.add(new Technique("light-tracing", Technique.Way.INTO_PIXELS, Map.of("preprocessor", "random"), 0));
        for (String estimator : List.of("nearest", "density", "progressive", "expected-count")) {
            for (String name : PRE_PROCESSORS) {
                long raysAPass = estimator.equals("progressive") ? RAYS_A_PASS : 0;
                List<String> settings =
                        new ArrayList<>(List.of("preprocessor=" + name, "map=photon-map", "estimator=" + estimator));
                if (estimator.equals("expected-count")) {
                    settings.addAll(WITHIN_BUDGET.getOrDefault(name, List.of()));
                }
                all.add(technique(name + "-" + estimator, raysAPass, settings.toArray(String[]::new)));
            }
        }
        PRE_PROCESSORS.forEach(name -> all.add(
                technique(name + "-ambient-maps", "preprocessor=" + name, "map=ambient-maps", "estimator=density")));
        return List.copyOf(all);
    }

    /** All of them. */
    public static List<Technique> known() {
        return KNOWN;
    }

    /** A few that stand for the others. */
    public static List<Technique> quick() {
        return QUICK.stream().map(name -> named(name).get(0)).toList();
    }

    /**
     * Reads a list such as {@code light-tracing,planar-*,mine:map=photon-map:gather-count=200}: names of known
     * techniques, where a star stands for any letters, and names of one's own with keys of the scene's settings.
     *
     * @throws IllegalArgumentException if a name is unknown or said twice, or a key has no value
     */
    public static List<Technique> parse(String text) {
        Map<String, Technique> techniques = new LinkedHashMap<>();
        for (String word : text.split(",")) {
            for (Technique technique : word.contains(":") ? List.of(own(word)) : named(word.strip())) {
                if (techniques.putIfAbsent(technique.name(), technique) != null) {
                    throw new IllegalArgumentException("two techniques are named '" + technique.name() + "'");
                }
            }
        }
        return new ArrayList<>(techniques.values());
    }

    private static List<Technique> named(String pattern) {
        String expression =
                Stream.of(pattern.split("\\*", -1)).map(Pattern::quote).collect(Collectors.joining(".*"));
        List<Technique> found = KNOWN.stream()
                .filter(technique -> technique.name().matches(expression))
                .toList();
        if (found.isEmpty()) {
            throw new IllegalArgumentException("unknown technique '" + pattern + "'; known are "
                    + KNOWN.stream().map(Technique::name).collect(Collectors.joining(", "))
                    + ", and NAME:key=value:key=value");
        }
        return found;
    }

    private static Technique own(String word) {
        String[] parts = word.strip().split(":");
        String name = parts.length == 0 ? "" : parts[0];
        // A file is named after it.
        if (!name.matches("[A-Za-z0-9_.-]+")) {
            throw new IllegalArgumentException(
                    "a technique's name must be of letters, digits, '-', '_' and '.', but is '" + name + "'");
        }
        return technique(name, List.of(parts).subList(1, parts.length).toArray(String[]::new));
    }

    private static Technique technique(String name, String... settings) {
        return technique(name, 0, settings);
    }

    private static Technique technique(String name, long raysAPass, String... settings) {
        Map<String, String> pairs = new LinkedHashMap<>();
        for (String setting : settings) {
            int equals = setting.indexOf('=');
            if (equals < 1) {
                throw new IllegalArgumentException(
                        "technique '" + name + "': expected key=value, found '" + setting + "'");
            }
            pairs.put(setting.substring(0, equals), setting.substring(equals + 1));
        }
        return new Technique(name, Technique.Way.OVER_A_MAP, pairs, raysAPass);
    }
}
