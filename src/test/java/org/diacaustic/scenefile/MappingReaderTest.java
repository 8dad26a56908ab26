package org.diacaustic.scenefile;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.stream.Stream;
import org.diacaustic.math.Color;
import org.diacaustic.math.Vector3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

class MappingReaderTest {
    private enum Falloff {
        NONE,
        INVERSE_SQUARE
    }

    private final Problems problems = new Problems();

    private MappingReader parse(String text) {
        return SceneDocument.parse("s.yaml", text, problems).root();
    }

    static Arguments wrong(String value, Consumer<MappingReader> ask, String message) {
        return Arguments.of(value, ask, message);
    }

    static Stream<Arguments> wrongValues() {
        Consumer<MappingReader> radius = m -> m.number("x").above(0).required();
        Consumer<MappingReader> number = m -> m.number("x").or(1.0);
        Consumer<MappingReader> samples =
                m -> m.integer("x").atLeast(1).atMost(64).or(16);
        Consumer<MappingReader> flag = m -> m.flag("x").or(false);
        Consumer<MappingReader> point = m -> m.vector3("x").required();
        Consumer<MappingReader> color = m -> m.color("x").atLeast(0).atMost(1).required();
        return Stream.of(
                wrong("one", radius, "expected a number above 0, found 'one'"),
                wrong("'1.5'", radius, "expected a number above 0, found '1.5' in quotes, which make it text"),
                wrong("0", radius, "expected a number above 0, found '0'"),
                wrong("-1", radius, "expected a number above 0, found '-1'"),
                wrong("1e-400", radius, "expected a number above 0, found '1e-400'"),
                wrong(".nan", radius, "expected a number above 0, found '.nan', which is not a finite number"),
                wrong(".inf", radius, "expected a number above 0, found '.inf', which is not a finite number"),
                wrong("1e400", number, "expected a number, found '1e400', which is too large for a double"),
                wrong("1,33", number, "expected a number, found '1,33'; write 1.33, with a point"),
                wrong("0o18", number, "expected a number, found '0o18'"),
                wrong("1_000", number, "expected a number, found '1_000'"),
                wrong("NaN", number, "expected a number, found 'NaN'"),
                wrong("1.5f", number, "expected a number, found '1.5f'"),
                wrong("", number, "expected a number, found nothing"),
                wrong("[1]", number, "expected a number, found a list of 1 value"),
                wrong("{a: 1}", number, "expected a number, found a mapping with 'a'"),
                wrong(
                        "180",
                        m -> m.number("x").above(0).below(180).in("degrees").required(),
                        "expected a number above 0 and below 180, in degrees, found '180'"),
                wrong(
                        "1.5",
                        m -> m.number("x").atLeast(0).atMost(1).required(),
                        "expected a number from 0 to 1, found '1.5'"),
                wrong("0", samples, "expected a whole number from 1 to 64, found '0'"),
                wrong("1.5", samples, "expected a whole number from 1 to 64, found '1.5'"),
                wrong("1e30", samples, "expected a whole number from 1 to 64, found '1e30'"),
                wrong("1e999999999", samples, "expected a whole number from 1 to 64, found '1e999999999'"),
                wrong(
                        "3000000000",
                        m -> m.integer("x").or(1),
                        "expected a whole number, found '3000000000', beyond the largest of 2147483647"),
                wrong("yes", flag, "expected true or false, found 'yes', which is text in YAML 1.2"),
                wrong("Off", flag, "expected true or false, found 'Off', which is text in YAML 1.2"),
                wrong("1", flag, "expected true or false, found '1'"),
                wrong("'true'", flag, "expected true or false, found 'true'"),
                wrong("[1, 2]", point, "expected a list of 3 numbers, found a list of 2 values"),
                wrong("1", point, "expected a list of 3 numbers, found '1'"),
                wrong(
                        "[0, 0, 0]",
                        m -> m.direction("x").required(),
                        "expected a direction, 3 numbers that are not all 0, found the zero vector"),
                wrong(
                        "red",
                        color,
                        "expected a colour, [red, green, blue] or one number for grey, each from 0 to 1, found 'red'"),
                wrong(
                        "2",
                        color,
                        "expected a colour, [red, green, blue] or one number for grey, each from 0 to 1, found '2'"),
                wrong(
                        "inverse-sqare",
                        m -> m.choice("x", Falloff.class).required(),
                        "expected one of none, inverse-square, found 'inverse-sqare'; did you mean 'inverse-square'?"),
                wrong(
                        "sideways",
                        m -> m.choice("x", Falloff.class).required(),
                        "expected one of none, inverse-square, found 'sideways'"),
                wrong(
                        "[[1, 2, 3], [1, 2, 3]]",
                        m -> m.points("x", 3).required(),
                        "expected a list of at least 3 points, each a list of 3 numbers, found a list of 2 values"),
                wrong("{a: 1}", m -> m.text("x").required(), "expected text, found a mapping with 'a'"),
                wrong(
                        "a.obj",
                        m -> m.file("x").required(),
                        "this scene has no folder, so it can name no files, found 'a.obj'"),
                wrong("7", m -> m.mapping("x"), "expected a mapping of keys to values, found '7'"),
                wrong("7", m -> m.variants("x"), "expected a list, found '7'"));
    }

    @ParameterizedTest
    @MethodSource("wrongValues")
    void read_givenWrongValue_saysRuleAndValue(String value, Consumer<MappingReader> ask, String message) {
        MappingReader root = parse("x: " + value);
        ask.accept(root);

        assertThat(problems.sorted())
                .singleElement()
                .hasToString("s.yaml:1:" + (value.isEmpty() ? 3 : 4) + ": x: " + message);
        assertThat(root.finish()).isFalse();
    }

    @ParameterizedTest
    @CsvSource({
        "12, 12",
        "+1.5e3, 1500",
        "-.5, -0.5",
        "3., 3",
        "0o17, 15",
        "0x1F, 31",
        "007, 7",
        "-0.0, -0.0",
        "1e6, 1e6"
    })
    void number_givenCoreSchemaNumber_readsIt(String text, double expected) {
        assertThat(parse("x: " + text).number("x").required()).isEqualTo(expected);
        assertThat(problems.sorted()).isEmpty();
    }

    @Test
    void number_givenInfinityWhereAllowed_readsIt() {
        MappingReader root = parse("{x: .inf, y: -.inf}");

        assertThat(root.number("x").above(0).orInfinite().required()).isEqualTo(Double.POSITIVE_INFINITY);
        root.number("y").above(0).orInfinite().required();
        assertThat(problems.toString()).contains("y: expected a number above 0, found '-.inf'");
    }

    @Test
    void longInteger_givenLimitsAndWholeFloats_readsThemExactly() {
        MappingReader root =
                parse("{a: 9223372036854775807, b: -9223372036854775808, c: 1e12, d: 9223372036854775808}");

        assertThat(root.longInteger("a").required()).isEqualTo(Long.MAX_VALUE);
        assertThat(root.longInteger("b").required()).isEqualTo(Long.MIN_VALUE);
        assertThat(root.longInteger("c").required()).isEqualTo(1_000_000_000_000L);
        assertThat(problems.hasErrors()).isFalse();
        root.longInteger("d").required();
        assertThat(problems.hasErrors()).isTrue();
    }

    @Test
    void required_givenWrongOrMissingValue_standsInWithOneThatKeepsTheRule() {
        MappingReader root = parse("{x: one}");

        assertThat(root.number("x").above(3).required()).isGreaterThan(3);
        assertThat(root.number("x").above(0).below(180).required()).isBetween(1.0, 179.0);
        assertThat(root.number("x").atMost(-5).required()).isLessThanOrEqualTo(-5);
        assertThat(root.number("x").below(-5).required()).isLessThan(-5);
        assertThat(root.integer("none").atLeast(4).required()).isGreaterThanOrEqualTo(4);
        assertThat(root.direction("none").required().length()).isPositive();
    }

    @Test
    void optionalValues_givenNoKey_takeTheDefaultWithoutProblem() {
        MappingReader root = parse("{}");

        assertThat(root.number("a").above(0).or(1.5)).isEqualTo(1.5);
        assertThat(root.integer("b").optional()).isEmpty();
        assertThat(root.color("c").or(Color.WHITE)).isEqualTo(Color.WHITE);
        assertThat(root.optionalMapping("d")).isEmpty();
        assertThat(root.mappings("e")).isEmpty();
        assertThat(root.has("f")).isFalse();
        assertThat(root.finish()).isTrue();
        assertThat(problems.sorted()).isEmpty();
    }

    @Test
    void required_givenMissingKeys_namesThemAtTheMapping() {
        MappingReader camera = parse("camera:\n  size: [1, 1]\n").mapping("camera");
        camera.vector3("from").required();

        assertThat(problems).hasToString("s.yaml:2:3: camera.from: is missing: expected a list of 3 numbers");
    }

    @Test
    void readers_givenAllForms_giveTheirValues() {
        MappingReader root = parse("""
                name: Ball
                at: [1, 2.5, -3]
                diffuse: 0.5
                specular: [0, 0.25, 1]
                falloff: inverse-square
                shadows: false
                vertices: [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
                labels: [a, 'b', 3]
                polynomial: [1, 0, 2, 5]
                """);

        assertThat(root.text("name").required()).isEqualTo("Ball");
        assertThat(root.vector3("at").required()).isEqualTo(new Vector3(1, 2.5, -3));
        assertThat(root.color("diffuse").required()).isEqualTo(Color.grey(0.5));
        assertThat(root.color("specular").atLeast(0).atMost(1).required()).isEqualTo(new Color(0, 0.25, 1));
        assertThat(root.choice("falloff", Falloff.class).required()).isEqualTo(Falloff.INVERSE_SQUARE);
        assertThat(root.flag("shadows").or(true)).isFalse();
        assertThat(root.points("vertices", 3).required())
                .contains(Vector3.UNIT_Y)
                .hasSize(3);
        assertThat(root.texts("labels").required()).containsExactly("a", "b", "3");
        assertThat(root.numbers("polynomial").required()).containsExactly(1, 0, 2, 5);
        assertThat(root.form("name")).isEqualTo(Form.TEXT);
        assertThat(root.form("diffuse")).isEqualTo(Form.NUMBER);
        assertThat(root.form("at")).isEqualTo(Form.LIST);
        assertThat(root.form("absent")).isEqualTo(Form.ABSENT);
        assertThat(root.finish()).isTrue();
        assertThat(problems.sorted()).isEmpty();
    }

    @Test
    void vector3_givenSeveralWrongComponents_reportsEachAtItsPlace() {
        parse("at: [1, x, .nan]").vector3("at").required();

        assertThat(problems.sorted())
                .extracting(Problem::toString)
                .containsExactly(
                        "s.yaml:1:9: at[1]: expected a number, found 'x'",
                        "s.yaml:1:12: at[2]: expected a number, found '.nan', which is not a finite number");
    }

    @Test
    void finish_givenUnknownKeys_suggestsTheNearestThatWasAskedFor() {
        MappingReader root = parse("materal: glass\nfieldOfView: 40\nzzz: 1\n");
        root.text("material").or("");
        root.number("field-of-view").or(40.0);
        root.finish();

        assertThat(problems.sorted())
                .extracting(Problem::toString)
                .containsExactly(
                        "s.yaml:1:1: materal: unknown key; did you mean 'material'?",
                        "s.yaml:2:1: fieldOfView: unknown key; did you mean 'field-of-view'?",
                        "s.yaml:3:1: zzz: unknown key; known here: material, field-of-view");
    }

    @Test
    void finish_givenDecimalCommaInBraces_explainsTheStrayKey() {
        MappingReader root = parse("{ior: 1,33}");
        root.number("ior").required();
        root.finish();

        assertThat(problems)
                .hasToString(
                        "s.yaml:1:9: 33: unknown key; if it belongs to a number before it, write that with a point,"
                                + " not a comma");
    }

    @Test
    void duplicateKey_isReportedWithBothLinesAndTheFirstHolds() {
        MappingReader root = parse("radius: 1\nradius: 2\n");

        assertThat(root.number("radius").required()).isEqualTo(1);
        assertThat(root.finish()).isFalse();
        assertThat(problems).hasToString("s.yaml:2:1: radius: the key is there twice; the first is at line 1");
    }

    @Test
    void variants_givenKinds_readsEachAndTellsOfEachWrongOne() {
        MappingReader root = parse("""
                objects:
                  - sphere: {radius: 1}
                  - sphere: {radius: one}
                  - shpere: {radius: 1}
                  - {sphere: {}, box: {}}
                  - box:
                  - 7
                  - sphere: {radius: 2, colour: red}
                """);
        Map<String, Function<MappingReader, Double>> kinds = new LinkedHashMap<>();
        kinds.put("sphere", sphere -> sphere.number("radius").above(0).required());
        kinds.put("box", box -> box.number("edge").or(3.0));
        List<Optional<Double>> read =
                root.variants("objects").stream().map(v -> v.read(kinds)).toList();

        // A mistake in one object leaves the others as they are.
        assertThat(read.get(0)).contains(1.0);
        assertThat(read.get(4)).contains(3.0);
        assertThat(read.stream().filter(Optional::isPresent)).hasSize(2);
        assertThat(problems.sorted())
                .extracting(Problem::toString)
                .containsExactly(
                        "s.yaml:3:22: objects[1].sphere.radius: expected a number above 0, found 'one'",
                        "s.yaml:4:5: objects[2]: unknown kind 'shpere'; did you mean 'sphere'?",
                        "s.yaml:5:5: objects[3]: expected a mapping with one key, one of sphere, box, found a mapping"
                                + " with 'sphere'",
                        "s.yaml:7:5: objects[5]: expected a mapping with one key, one of sphere, box, found '7'",
                        "s.yaml:8:25: objects[6].sphere.colour: unknown key; known here: radius");
    }

    @Test
    void namedMappings_givenOneWrong_keepsTheOthersSound() {
        Map<String, MappingReader> materials =
                parse("materials: {water: {ior: x}, glass: {ior: 1.5}}").namedMappings("materials");
        materials.values().forEach(material -> material.number("ior").atLeast(1).required());

        assertThat(materials.keySet()).containsExactly("water", "glass");
        assertThat(materials.get("water").finish()).isFalse();
        assertThat(materials.get("glass").finish()).isTrue();
    }

    @Test
    void problems_givenMixedKinds_exitCodeIsThatOfTheInputFirst() {
        Problems mixed = new Problems();
        mixed.warning(Place.of("b"), "", "odd");
        assertThat(mixed.exitCode()).isZero();
        mixed.limit(Place.of("b"), "", "too large");
        assertThat(mixed.exitCode()).isEqualTo(4);
        mixed.unreadable(Place.of("a"), "", "gone");
        mixed.error(new Place("a", 2, 1), "k", "wrong\n\u001b[31m");

        assertThat(mixed.exitCode()).isEqualTo(2);
        assertThat(mixed).hasToString("a: gone\na:2:1: k: wrong\ufffd\ufffd[31m\nb: warning: odd\nb: too large");
    }

    @Test
    void problems_givenMany_keepsAThousandAndCountsTheRest() {
        for (int i = 0; i < 1500; i++) {
            problems.error(new Place("s.yaml", i + 1, 1), "", "wrong");
        }

        assertThat(problems.sorted()).hasSize(1000);
        assertThat(problems.toString()).endsWith("and 500 more problems");
    }
}
