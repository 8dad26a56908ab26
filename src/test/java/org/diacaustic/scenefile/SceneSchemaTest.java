package org.diacaustic.scenefile;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.diacaustic.image.Exposure;
import org.diacaustic.image.ImageFiles;
import org.diacaustic.image.LinearImage;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.snakeyaml.engine.v2.api.Load;
import org.snakeyaml.engine.v2.api.LoadSettings;

/**
 * Holds {@code scenes/scene.schema.json} and the scene reader together: no list of keys is copied here. What the reader
 * knows is taken from its own messages, what the schema knows from the schema.
 */
class SceneSchemaTest {
    private static final Path SCENES = Path.of("scenes");
    /** Too far from every word for a suggestion, so that the reader lists what it knows. */
    private static final String NO_WORD = "q".repeat(40);

    private static final String KNOWN_HERE = "; known here: ";

    @TempDir
    static Path folder;

    private static SceneSchema schema;

    @BeforeAll
    static void readSchema() throws IOException {
        schema = new SceneSchema(SCENES.resolve("scene.schema.json"));
        ImageFiles.write(new LinearImage(2, 2), Exposure.fixed(1), folder.resolve("picture.png"));
        Files.writeString(
                folder.resolve("mesh.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");
    }

    static Stream<Path> bundledScenes() throws IOException {
        return Files.walk(SCENES).filter(path -> path.toString().endsWith(".yaml"));
    }

    @ParameterizedTest
    @MethodSource("bundledScenes")
    void schema_givenBundledScene_acceptsIt(Path scene) throws IOException {
        Object document = new Load(LoadSettings.builder().build()).loadFromString(Files.readString(scene));
        assertThat(schema.complaints(SceneSchema.JSON.valueToTree(document))).isEqualTo("[]");
    }

    @Test
    void schema_givenEachMapping_hasTheKeysThatTheReaderAsksFor() {
        for (SceneSchema.Site site : schema.sites()) {
            if (site.isMapping()) {
                Set<String> asked = new TreeSet<>();
                for (String key : site.keys()) {
                    ObjectNode mapping = schema.mappingWith(site, key);
                    asked.addAll(known(site.embed().apply(mapping.put(NO_WORD, 1)), "unknown key"));
                }
                assertThat(site.keys()).as(site.path()).isEqualTo(asked);
            }
        }
    }

    @Test
    void schema_givenEachVariant_hasTheKindsThatTheReaderKnows() {
        for (SceneSchema.Site site : schema.sites()) {
            if (site.isVariant()) {
                JsonNode scene =
                        site.embed().apply(JsonNodeFactory.instance.objectNode().set(NO_WORD, null));
                assertThat(site.keys()).as(site.path()).isEqualTo(known(scene, "unknown kind '" + NO_WORD + "'"));
            }
        }
    }

    /** What the reader says it knows where it meets {@link #NO_WORD}, which the schema must refuse there. */
    private static Set<String> known(JsonNode scene, String complaint) {
        assertThat(schema.accepts(scene)).as(scene.toString()).isFalse();
        List<Problem> problems = read(scene).sorted();
        assertThat(problems).as(scene.toString()).hasSize(1);
        assertThat(problems.get(0).message()).as(scene.toString()).startsWith(complaint + KNOWN_HERE);
        String list = problems.get(0).message().substring((complaint + KNOWN_HERE).length());
        return new TreeSet<>(Arrays.asList(list.split(", ")));
    }

    @Test
    void schema_givenMappingWithoutRequiredKey_refusesItAsTheReaderDoes() {
        for (SceneSchema.Site site : schema.sites()) {
            for (String key : site.isMapping() ? site.required() : List.<String>of()) {
                ObjectNode mapping = schema.mappingWith(site, key);
                mapping.remove(key);
                JsonNode scene = site.embed().apply(mapping);
                assertThat(schema.accepts(scene)).as(scene.toString()).isFalse();
                assertThat(read(scene).toString())
                        .contains((site.path().isEmpty() ? "" : site.path() + ".") + key + ": is missing");
            }
        }
    }

    @Test
    void schema_givenEachDefault_meansWhatTheReaderTakesForAMissingKey() {
        int defaults = 0;
        for (SceneSchema.Site site : schema.sites()) {
            for (String key : site.isMapping() ? site.keys() : Set.<String>of()) {
                ObjectNode mapping = schema.mappingWith(site, key);
                JsonNode value = schema.property(site.schema(), key).get("default");
                if (value != null) {
                    JsonNode said = site.embed().apply(mapping.deepCopy().set(key, value));
                    JsonNode unsaid = site.embed().apply(mapping.deepCopy().without(key));
                    assertThat(sceneOf(said))
                            .as(said.toString())
                            .usingRecursiveComparison()
                            .withEqualsForType(Double::equals, Double.class)
                            .isEqualTo(sceneOf(unsaid));
                    defaults++;
                }
            }
        }
        assertThat(defaults).isGreaterThan(40);
    }

    @Test
    void schema_givenAnyValueAnywhere_judgesItAsTheReaderDoes() {
        List<String> disagreements = new ArrayList<>();
        int judged = 0;
        for (SceneSchema.Site site : schema.sites()) {
            for (JsonNode value : probes(site)) {
                JsonNode scene = site.embed().apply(value);
                Problems problems = read(scene);
                boolean accepted = schema.accepts(scene);
                if (accepted ? hasFormErrors(problems) : !problems.hasErrors()) {
                    disagreements.add(site.path() + " = " + value + ": schema " + (accepted ? "accepts" : "refuses")
                            + ", reader " + problems);
                }
                judged++;
            }
        }
        assertThat(disagreements).isEmpty();
        assertThat(judged).isGreaterThan(1000);
    }

    /** Values of every form, on and beside the limits that occur; text keys take numbers, but editors need not say so. */
    private static List<JsonNode> probes(SceneSchema.Site site) {
        boolean text = site.schema().path("type").asText().equals("string");
        List<JsonNode> probes = new ArrayList<>();
        probes.add(schema.example(site.schema()));
        for (String json : List.of(
                "-1",
                "0",
                "0.5",
                "1",
                "1.5",
                "9",
                "179",
                "180",
                "181",
                "1048577",
                "3e9",
                "true",
                "'word'",
                "'auto'",
                "[]",
                "[1, 2]",
                "[0.5, 2]",
                "[0, 1, 2]",
                "[1, 2, -3]",
                "[0, 0, 0]",
                "[1, 1, 1, 1]",
                "[[1, 2, 3]]",
                "['word']",
                "{}",
                "{'word': 1}")) {
            JsonNode value = parse(json.replace('\'', '"'));
            if (!text || !value.isValueNode() || value.isTextual()) {
                probes.add(value);
            }
        }
        return probes;
    }

    private static JsonNode parse(String json) {
        try {
            return SceneSchema.JSON.readTree(json);
        } catch (IOException broken) {
            throw new AssertionError(broken);
        }
    }

    /** Whether a value has the wrong form; that values do not fit together, a schema cannot say. */
    private static boolean hasFormErrors(Problems problems) {
        return problems.sorted().stream()
                .filter(problem -> problem.severity() == Problem.Severity.ERROR)
                .map(Problem::message)
                .anyMatch(message -> message.matches("(?s)(expected|unknown|is missing).*"));
    }

    private static Problems read(JsonNode scene) {
        Problems problems = new Problems();
        read(scene, problems);
        return problems;
    }

    private static SceneFile sceneOf(JsonNode scene) {
        Problems problems = new Problems();
        return read(scene, problems).orElseThrow(() -> new AssertionError(scene + ": " + problems));
    }

    private static Optional<SceneFile> read(JsonNode scene, Problems problems) {
        FileScope files = FileScope.inFolderOf(folder.resolve("scene.json"));
        return SceneReader.read(SceneDocument.parse("scene.json", scene.toString(), files, problems), problems);
    }
}
