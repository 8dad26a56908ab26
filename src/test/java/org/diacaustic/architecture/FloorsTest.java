package org.diacaustic.architecture;

import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.domain.Dependency;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;

/**
 * Holds the packages to their floors. A package may use those it names here and all that those may use; any other edge
 * fails, and so does a package that is not listed. ARCHITECTURE.md draws the same table.
 */
class FloorsTest {
    private static final String ROOT = "org.diacaustic.";

    private static final Map<String, Set<String>> NAMES = new LinkedHashMap<>();

    static {
        NAMES.put("math", Set.of());
        NAMES.put("parallel", Set.of());
        NAMES.put("json", Set.of());
        NAMES.put("index", Set.of("math", "parallel"));
        NAMES.put("image", Set.of("math"));
        NAMES.put("chart", Set.of("image"));
        NAMES.put("shape", Set.of("index"));
        NAMES.put("material", Set.of("shape", "image"));
        NAMES.put("light", Set.of("shape"));
        NAMES.put("map", Set.of("index"));
        NAMES.put("scene", Set.of("shape", "material", "light", "map"));
        NAMES.put("shader", Set.of("scene"));
        NAMES.put("transport", Set.of("scene", "parallel"));
        NAMES.put("preprocess", Set.of("transport", "map", "scene", "parallel"));
        NAMES.put("render", Set.of("preprocess", "transport", "shader", "map", "scene", "image", "parallel"));
        NAMES.put("scenefile", Set.of("scene", "image"));
        NAMES.put("study", Set.of("render", "scenefile", "chart", "json"));
        NAMES.put("reproduction", Set.of("render", "scenefile", "chart", "json"));
        NAMES.put("stability", Set.of("parallel", "json"));
        NAMES.put("page", Set.of("study", "chart"));
        NAMES.put("trial", Set.of("stability", "render", "scenefile"));
        NAMES.put("fault", Set.of("stability", "render", "scenefile"));
        NAMES.put("cli", Set.of("page", "reproduction", "trial", "fault", "render", "scenefile", "json"));
    }

    private final JavaClasses classes = new ClassFileImporter()
            .withImportOption(ImportOption.Predefined.DO_NOT_INCLUDE_TESTS)
            .importPackages("org.diacaustic");

    @Test
    void packages_givenTheirImports_useOnlyWhatTheyMay() {
        assertThat(edges()).isNotEmpty();
        List<String> forbidden = edges().entrySet().stream()
                .flatMap(edge -> edge.getValue().stream()
                        .filter(used -> !mayUse(edge.getKey()).contains(used))
                        .map(used -> edge.getKey() + " -> " + used))
                .toList();
        assertThat(forbidden)
                .as("edges between packages that the floors do not allow")
                .isEmpty();
    }

    @Test
    void packages_givenTheSources_areAllListed() {
        Set<String> found = new TreeSet<>();
        classes.forEach(type -> found.add(packageOf(type)));
        assertThat(found).isEqualTo(new TreeSet<>(NAMES.keySet()));
    }

    @Test
    void floors_givenTheTable_haveNoCycle() {
        NAMES.keySet()
                .forEach(name ->
                        assertThat(mayUse(name)).as("what %s may use", name).doesNotContain(name));
    }

    private Map<String, Set<String>> edges() {
        Map<String, Set<String>> edges = new TreeMap<>();
        for (JavaClass type : classes) {
            for (Dependency dependency : type.getDirectDependenciesFromSelf()) {
                JavaClass used = dependency.getTargetClass().getBaseComponentType();
                if (used.getPackageName().startsWith(ROOT) && !packageOf(used).equals(packageOf(type))) {
                    edges.computeIfAbsent(packageOf(type), key -> new TreeSet<>())
                            .add(packageOf(used));
                }
            }
        }
        return edges;
    }

    private static String packageOf(JavaClass type) {
        return type.getPackageName().substring(ROOT.length());
    }

    /** What a package names and what those may use. */
    private static Set<String> mayUse(String name) {
        Set<String> all = new TreeSet<>();
        Deque<String> open = new ArrayDeque<>(NAMES.get(name));
        while (!open.isEmpty()) {
            String next = open.pop();
            if (all.add(next)) {
                open.addAll(NAMES.get(next));
            }
        }
        return all;
    }
}
