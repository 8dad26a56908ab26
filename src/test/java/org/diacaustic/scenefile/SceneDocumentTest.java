package org.diacaustic.scenefile;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Random;
import java.util.stream.Stream;
import org.diacaustic.scenefile.Problem.Kind;
import org.junit.jupiter.api.Assertions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

class SceneDocumentTest {
    private final Problems problems = new Problems();

    @TempDir
    Path folder;

    private MappingReader parse(String text) {
        return SceneDocument.parse("s.yaml", text, problems).root();
    }

    static Stream<Arguments> refusedTexts() {
        return Stream.of(
                Arguments.of("", "s.yaml:1:1: holds no scene: the document is empty"),
                Arguments.of("# only a comment\n", "s.yaml:1:1: holds no scene: the document is empty"),
                Arguments.of("[1, 2]", "s.yaml:1:1: expected a mapping of keys to values, found a list of 2 values"),
                Arguments.of("text", "s.yaml:1:1: expected a mapping of keys to values, found 'text'"),
                Arguments.of(
                        "a: 1\nb: [1, 2\nc: 3\n",
                        "s.yaml:2:4: the bracket opened here is not closed: expected ',' or ']', but got : at line 3,"
                                + " column 2"),
                Arguments.of(
                        "a:\n\t- 1\n", "s.yaml:2:1: is not YAML: a tab cannot begin a value or indent it; use spaces"),
                Arguments.of("a: 1\n---\nb: 2\n", "s.yaml:2:1: a second document begins here; a scene file holds one"),
                Arguments.of("a: *b\n", "s.yaml:1:4: *b is not defined; write &b before the value it names"),
                Arguments.of("a: &a {b: &b [*a]}\n", "s.yaml:1:15: *a stands inside what it names: a -> b -> a"),
                Arguments.of("a: &a [*a]\n", "s.yaml:1:8: *a stands inside what it names: a -> a"),
                Arguments.of(
                        "a: !!javax.script.ScriptEngineManager [1]\n",
                        "s.yaml:1:4: the tag tag:yaml.org,2002:javax.script.ScriptEngineManager is not allowed: a scene"
                                + " file names no types"),
                Arguments.of("{[1]: 2}\n", "s.yaml:1:2: a key must be text, found a list of 1 value"),
                Arguments.of("a: 1\nb: \u0007\n", "s.yaml:2:4: the character U+0007 is not allowed in YAML"));
    }

    @ParameterizedTest
    @MethodSource("refusedTexts")
    void parse_givenBrokenText_saysWhatAndWhereInOneLine(String text, String expected) {
        MappingReader root = parse(text);

        assertThat(problems).hasToString(expected);
        assertThat(problems.exitCode()).isEqualTo(2);
        // A document that was refused is not blamed for what it lacks as well.
        root.vector3("at").required();
        root.mapping("camera").number("field-of-view").required();
        assertThat(root.finish()).isFalse();
        assertThat(problems.sorted()).hasSize(1);
    }

    @Test
    void parse_givenNestingAtTheLimit_acceptsItAndOneMoreNot() {
        parse("a: " + "[".repeat(49) + "]".repeat(49));
        assertThat(problems.sorted()).isEmpty();

        parse("a: " + "[".repeat(50) + "]".repeat(50));
        assertThat(problems).hasToString("s.yaml:1:53: nested deeper than the limit of 50 levels");
    }

    @Test
    void parse_givenDeepNestingOfEveryKind_refusesItAtOnce() {
        for (String bracket : new String[] {"[", "{a: ", "- ", "? "}) {
            Problems found = new Problems();
            Assertions.assertTimeout(
                    Duration.ofSeconds(2), () -> SceneDocument.parse("s.yaml", bracket.repeat(100_000), found));
            assertThat(found.toString()).contains("nested deeper than the limit of 50 levels");
        }
    }

    @Test
    void parse_givenBillionLaughs_refusesItBeforeItGrows() {
        StringBuilder bomb = new StringBuilder("a: &a [x, x, x, x, x, x, x, x, x]\n");
        for (char level = 'b'; level <= 'i'; level++) {
            String alias = "*" + (char) (level - 1);
            bomb.append(level).append(": &").append(level).append(" [").append(alias);
            bomb.append((", " + alias).repeat(8)).append("]\n");
        }
        Assertions.assertTimeout(Duration.ofSeconds(2), () -> parse(bomb.toString()));

        assertThat(problems.toString()).contains("more values than the limit of 500000");
    }

    @Test
    void parse_givenAliases_sharesWhatTheyName() {
        MappingReader root = parse("a: &there [1, 2, 3]\nb: *there\n");

        assertThat(root.vector3("b").required()).isEqualTo(root.vector3("a").required());
        assertThat(problems.sorted()).isEmpty();
    }

    @Test
    void parse_givenJson_readsIt() {
        assertThat(parse("{\"a\": {\"b\": [1, -2.5e1, 3]}}")
                        .mapping("a")
                        .vector3("b")
                        .required()
                        .y())
                .isEqualTo(-25);
        assertThat(problems.sorted()).isEmpty();
    }

    @Test
    void parse_givenOneLongLine_staysFast() {
        // A reader with a small window copies the rest of a line again for each refill: minutes for this one.
        Assertions.assertTimeout(Duration.ofSeconds(2), () -> parse(" ".repeat(8_000_000) + "\na: 1"));

        assertThat(problems.sorted()).isEmpty();
    }

    @Test
    void parse_givenDamagedText_neverThrows() {
        String sound = """
                %YAML 1.2
                ---
                camera: &c {from: [0, 4, -9], "to\\u0041": 'x', ? k : !!str v}
                list:
                  - >-
                    folded
                  - *c
                  - "\\U0001F600 \\x41"
                  - |
                    literal # no comment
                ...
                """;
        String spice = "[]{}:,-?!&*#|>'\"%@`\\\t\n \u0000\u0085\ud83dUxu09.<~";
        Random random = new Random(5);
        int accepted = 0;
        for (int trial = 0; trial < 20_000; trial++) {
            StringBuilder text = new StringBuilder(sound);
            for (int i = random.nextInt(6); i > 0; i--) {
                int at = random.nextInt(text.length());
                text.replace(at, at + random.nextInt(3), "" + spice.charAt(random.nextInt(spice.length())));
            }
            Problems found = new Problems();
            MappingReader root =
                    SceneDocument.parse("s.yaml", text.toString(), found).root();
            accepted += found.hasErrors() ? 0 : 1;
            root.mapping("camera").vector3("from").required();
            root.texts("list").required();
            assertThat(root.finish()).isNotEqualTo(found.hasErrors());
            assertThat(found.toString().lines()).allMatch(line -> line.startsWith("s.yaml:"));
        }
        assertThat(accepted).isPositive();
    }

    @Test
    void read_givenBomAndCarriageReturns_placesAreThoseOfAnEditor() throws IOException {
        Path file = folder.resolve("dos.yaml");
        Files.writeString(file, "\ufeffa: 1\r\nb: x\r\n");
        MappingReader root = SceneDocument.read(file, problems).root();

        assertThat(root.number("a").required()).isEqualTo(1);
        root.number("b").required();
        assertThat(problems).hasToString(file + ":2:4: b: expected a number, found 'x'");
    }

    @Test
    void read_givenBytesThatAreNotUtf8_namesTheByteAndItsPlace() throws IOException {
        Path file = folder.resolve("latin1.yaml");
        Files.write(file, "a: 1\nb: \u00fcber\n".getBytes(StandardCharsets.ISO_8859_1));
        SceneDocument.read(file, problems);

        assertThat(problems).hasToString(file + ":2:4: is not UTF-8 text: byte 0xFC at offset 8");
    }

    @Test
    void read_givenTextThatEndsInsideACharacter_saysSo() throws IOException {
        Path file = folder.resolve("cut.yaml");
        Files.write(file, new byte[] {'a', ':', ' ', (byte) 0xC3});
        SceneDocument.read(file, problems);

        assertThat(problems).hasToString(file + ":1:4: is not UTF-8 text: byte 0xC3 at offset 3");
    }

    @Test
    void read_givenUtf16_asksForUtf8() throws IOException {
        Path file = folder.resolve("wide.yaml");
        Files.write(file, "\ufeffa: 1\n".getBytes(StandardCharsets.UTF_16LE));
        SceneDocument.read(file, problems);

        assertThat(problems).hasToString(file + ":1:1: is UTF-16; save it as UTF-8");
    }

    @Test
    void read_givenNoSuchFile_isAFileProblemWithThePathLookedAt() {
        Path file = folder.resolve("a/../none.yaml");
        SceneDocument.read(file, problems);

        assertThat(problems).hasToString(file + ": no such file: " + folder.resolve("none.yaml"));
        assertThat(problems.exitCode()).isEqualTo(3);
    }

    @Test
    void read_givenFolder_isAFileProblem() {
        SceneDocument.read(folder, problems);

        assertThat(problems.toString()).contains("expected a file, found a folder");
        assertThat(problems.sorted()).extracting(Problem::kind).containsExactly(Kind.UNREADABLE_FILE);
    }

    @Test
    void read_givenHugeFile_refusesItByItsLimitWithoutReadingItAll() throws IOException {
        Path file = folder.resolve("huge.yaml");
        try (RandomAccessFile sparse = new RandomAccessFile(file.toFile(), "rw")) {
            sparse.setLength(200L << 20);
        }
        Assertions.assertTimeout(Duration.ofSeconds(2), () -> SceneDocument.read(file, problems));

        assertThat(problems).hasToString(file + ": is larger than the limit of 16 MiB for a scene file");
        assertThat(problems.exitCode()).isEqualTo(4);
    }

    @Test
    void override_givenKeys_replacesAddsAndGoesDeeper() {
        SceneDocument document = SceneDocument.parse("s.yaml", "settings: {seed: 1, adaptive: {depth: 2}}", problems);
        document.override("settings", "seed", "7");
        document.override("settings", "adaptive.depth", "5");
        document.override("settings", "size", "[3, 4]");
        document.override("more", "new.key", "text");

        MappingReader settings = document.root().mapping("settings");
        assertThat(settings.integer("seed").required()).isEqualTo(7);
        assertThat(settings.mapping("adaptive").integer("depth").required()).isEqualTo(5);
        assertThat(settings.vector2("size").required()).containsExactly(3, 4);
        assertThat(document.root().mapping("more").mapping("new").text("key").required())
                .isEqualTo("text");
        assertThat(settings.finish()).isTrue();
        assertThat(problems.sorted()).isEmpty();
    }

    @Test
    void override_givenWrongValue_placesTheProblemAtTheOption() {
        SceneDocument document = SceneDocument.parse("s.yaml", "settings: {seed: 1}", problems);
        document.override("settings", "seed", "many");
        document.override("settings", "sed", "2");
        document.override("settings", "seed.x", "2");
        document.override("settings", "a..b", "2");
        document.override("settings", "list", "[1");
        MappingReader settings = document.root().mapping("settings");
        settings.longInteger("seed").required();
        settings.finish();

        assertThat(problems.sorted())
                .extracting(Problem::toString)
                .containsExactly(
                        "-D a..b: expected a key such as seed or adaptive.depth",
                        "-D list:1:1: the bracket opened here is not closed: expected ',' or ']', but got <stream end>"
                                + " at line 1, column 3",
                        "-D sed: settings.sed: unknown key; did you mean 'seed'?",
                        "-D seed: settings.seed: expected a whole number, found 'many'",
                        "-D seed.x: settings.seed: is not a mapping that a value can be put into: 'many'");
    }
}
