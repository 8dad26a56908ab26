package org.diacaustic.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import org.diacaustic.scenefile.Problems;
import org.diacaustic.scenefile.SceneFile;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** The scene file, and everything that the command line can say over its settings. */
final class SceneOptions {
    @Mixin
    private SceneInput input;

    @Option(names = "--shader", paramLabel = "S", description = "auto, non-transparent, non-refractive.")
    private String shader;

    @Option(
            names = "--preprocessor",
            paramLabel = "P",
            description = "auto, none, random, monte-carlo, planar, cube, own-map, adaptive.")
    private String preProcessor;

    @Option(names = "--map", paramLabel = "M", description = "auto, none, ambient-maps, photon-map, caustic-mesh.")
    private String map;

    @Option(
            names = "--estimator",
            paramLabel = "E",
            description = "auto, expected-count, density, nearest, progressive.")
    private String estimator;

    @Option(names = "--rays", paramLabel = "N", description = "Light rays chosen, in a pass.")
    private Long rays;

    @Option(names = "--passes", paramLabel = "N", description = "Independent passes whose pictures are averaged.")
    private Integer passes;

    @Option(names = "--samples", paramLabel = "N", description = "Eye rays per pixel.")
    private Integer samples;

    @Option(names = "--max-depth", paramLabel = "N", description = "Reflections and refractions of an eye ray.")
    private Integer maxDepth;

    @Option(names = "--exposure", paramLabel = "X|auto", description = "Factor from radiance to picture.")
    private String exposure;

    Path path() {
        return input.path();
    }

    boolean hasPasses() {
        return passes != null;
    }

    /**
     * Reads the scene; prints its problems and warnings on standard error.
     *
     * @throws CommandFailure if it has problems
     */
    SceneFile read() throws IOException {
        return input.read(asSettings());
    }

    /** Reads the scene; null if {@code problems} has errors then. */
    SceneFile read(Problems problems) throws IOException {
        return input.read(asSettings(), problems).orElse(null);
    }

    /** What the options say, as keys of the settings. */
    private Map<String, String> asSettings() {
        Map<String, String> settings = new LinkedHashMap<>();
        put(settings, "shader", shader);
        put(settings, "preprocessor", preProcessor);
        put(settings, "map", map);
        put(settings, "estimator", estimator);
        put(settings, "rays", rays);
        put(settings, "passes", passes);
        put(settings, "samples", samples);
        put(settings, "max-depth", maxDepth);
        put(settings, "exposure", exposure);
        return settings;
    }

    private static void put(Map<String, String> settings, String key, Object value) {
        if (value != null) {
            settings.put(key, value.toString());
        }
    }
}
