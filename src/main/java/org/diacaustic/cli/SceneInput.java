package org.diacaustic.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.diacaustic.scene.Scene;
import org.diacaustic.scenefile.FileScope;
import org.diacaustic.scenefile.Problems;
import org.diacaustic.scenefile.SceneDocument;
import org.diacaustic.scenefile.SceneFile;
import org.diacaustic.scenefile.SceneReader;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** The scene file, and what every command that reads one can say over it. */
final class SceneInput {
    @Parameters(paramLabel = "SCENE", description = "Scene file, YAML or JSON.")
    private Path scene;

    @Option(names = "--size", paramLabel = "WxH", converter = PixelSize.Converter.class, description = "In pixels.")
    private PixelSize size;

    @Option(names = "--seed", paramLabel = "N", description = "Seed of all random choices.")
    private Long seed;

    @Option(names = "-D", paramLabel = "key=value", description = "Any key of the scene's settings.")
    private Map<String, String> overrides = new LinkedHashMap<>();

    @Option(names = "--allow-outside", description = "Let the scene name files outside its folder.")
    private boolean allowOutside;

    @Option(names = "--debug", description = "Show a stack trace when something fails.")
    private boolean debug;

    Path path() {
        return scene;
    }

    /** Takes another size than the scene's, unless one was given. */
    void proposeSize(PixelSize proposed) {
        size = size == null ? proposed : size;
    }

    /** All of it but the scene, as arguments of another command for the same scene. */
    List<String> optionTexts() {
        List<String> arguments = new ArrayList<>();
        if (size != null) {
            arguments.addAll(List.of("--size", size.width() + "x" + size.height()));
        }
        if (allowOutside) {
            arguments.add("--allow-outside");
        }
        overrides().forEach((key, value) -> arguments.addAll(List.of("-D", key + "=" + value)));
        return arguments;
    }

    /** What was said over the settings, with {@code -D} and as options. */
    Map<String, String> overrides() {
        Map<String, String> all = new LinkedHashMap<>(overrides);
        if (seed != null) {
            all.put("seed", seed.toString());
        }
        return all;
    }

    /**
     * Reads the scene; prints its warnings on standard error.
     *
     * @param extra keys of the settings that go over all others
     * @throws CommandFailure if it has problems
     */
    SceneFile read(Map<String, String> extra) throws IOException {
        Problems problems = new Problems();
        SceneFile file = readOrFail(extra, problems);
        String lines = problems.toString();
        if (!lines.isEmpty()) {
            System.err.println(lines);
        }
        return file;
    }

    /** As {@link #read(Map)}, but says nothing of warnings. */
    SceneFile readAgain(Map<String, String> extra) throws IOException {
        return readOrFail(extra, new Problems());
    }

    private SceneFile readOrFail(Map<String, String> extra, Problems problems) throws IOException {
        return read(extra, problems).orElseThrow(() -> new ProblemsFailure(problems.exitCode(), problems.toString()));
    }

    /** Reads the scene; nothing if {@code problems} has errors then. */
    Optional<SceneFile> read(Map<String, String> extra, Problems problems) throws IOException {
        FileScope files = allowOutside ? FileScope.anywhere(scene) : FileScope.inFolderOf(scene);
        SceneDocument document = SceneDocument.read(scene, files, problems);
        Map<String, String> settings = overrides();
        settings.putAll(extra);
        settings.forEach((key, value) -> document.override("settings", key, value));
        return SceneReader.read(document, problems).map(this::resized);
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
        return new SceneFile(resized, file.settings());
    }
}
