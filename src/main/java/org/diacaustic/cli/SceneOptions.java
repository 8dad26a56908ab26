package org.diacaustic.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import org.diacaustic.scene.Scene;
import org.diacaustic.scene.Settings;
import org.diacaustic.scenefile.FileScope;
import org.diacaustic.scenefile.Problems;
import org.diacaustic.scenefile.SceneDocument;
import org.diacaustic.scenefile.SceneFile;
import org.diacaustic.scenefile.SceneReader;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** The scene file and what the command line says over it. */
final class SceneOptions {
    @Parameters(paramLabel = "SCENE", description = "Scene file, YAML or JSON.")
    private Path scene;

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

    @Option(names = "--size", paramLabel = "WxH", converter = PixelSize.Converter.class, description = "In pixels.")
    private PixelSize size;

    @Option(names = "--samples", paramLabel = "N", description = "Eye rays per pixel.")
    private Integer samples;

    @Option(names = "--max-depth", paramLabel = "N", description = "Reflections and refractions of an eye ray.")
    private Integer maxDepth;

    @Option(names = "--seed", paramLabel = "N", description = "Seed of all random choices.")
    private Long seed;

    @Option(names = "--exposure", paramLabel = "X|auto", description = "Factor from radiance to picture.")
    private String exposure;

    @Option(names = "-D", paramLabel = "key=value", description = "Any key of the scene's settings.")
    private Map<String, String> overrides = new LinkedHashMap<>();

    @Option(names = "--allow-outside", description = "Let the scene name files outside its folder.")
    private boolean allowOutside;

    @Option(names = "--debug", description = "Show a stack trace when something fails.")
    private boolean debug;

    Path path() {
        return scene;
    }

    boolean hasPasses() {
        return passes != null;
    }

    boolean debug() {
        return debug;
    }

    /**
     * Reads the scene; prints its problems and warnings on standard error.
     *
     * @throws CommandFailure if it has problems
     */
    SceneFile read() throws IOException {
        Problems problems = new Problems();
        SceneFile file = read(problems);
        String lines = problems.toString();
        if (problems.hasErrors()) {
            throw new ProblemsFailure(problems.exitCode(), lines);
        }
        if (!lines.isEmpty()) {
            System.err.println(lines);
        }
        return file;
    }

    /** Reads the scene; null if {@code problems} has errors then. */
    SceneFile read(Problems problems) throws IOException {
        FileScope files = allowOutside ? FileScope.anywhere(scene) : FileScope.inFolderOf(scene);
        SceneDocument document = SceneDocument.read(scene, files, problems);
        asSettings().forEach((key, value) -> document.override("settings", key, value));
        return SceneReader.read(document, problems).map(this::resized).orElse(null);
    }

    /** What the options say, as keys of the settings; {@code -D} comes first, so that an option of its own wins. */
    private Map<String, String> asSettings() {
        Map<String, String> settings = new LinkedHashMap<>(overrides);
        put(settings, "shader", shader);
        put(settings, "preprocessor", preProcessor);
        put(settings, "map", map);
        put(settings, "estimator", estimator);
        put(settings, "rays", rays);
        put(settings, "passes", passes);
        put(settings, "samples", samples);
        put(settings, "max-depth", maxDepth);
        put(settings, "seed", seed);
        put(settings, "exposure", exposure);
        return settings;
    }

    private static void put(Map<String, String> settings, String key, Object value) {
        if (value != null) {
            settings.put(key, value.toString());
        }
    }

    private SceneFile resized(SceneFile file) {
        if (size == null) {
            return file;
        }
        Scene whole = file.scene();
        Scene resized = new Scene(
                whole.camera().withSize(size.width(), size.height()),
                whole.lights(),
                whole.objects(),
                whole.background());
        Settings settings = file.settings();
        return new SceneFile(resized, settings);
    }
}
