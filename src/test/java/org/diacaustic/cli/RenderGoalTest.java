package org.diacaustic.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** {@code render --error} and {@code --time}. */
class RenderGoalTest {
    /** The options that give the same picture again, at the end of what a render says. */
    private static final Pattern AGAIN =
            Pattern.compile(" about ([0-9.e-]+) %, (--map \\S+ --(?:rays|passes) [0-9]+)$");

    @TempDir
    Path folder;

    private Path scene;
    private Path picture;

    @BeforeEach
    void writeScene() throws IOException {
        scene = SmallScene.in(folder);
        picture = folder.resolve("out.pfm");
    }

    private Cli.Result render(String options) {
        List<Object> arguments = new ArrayList<>(List.of("render", scene, "-o", picture));
        arguments.addAll(List.of(options.split(" ")));
        return Cli.run(arguments.toArray());
    }

    private JsonNode statistics(String options) throws IOException {
        Path file = folder.resolve("s.json");
        render(options + " --stats " + file);
        return new ObjectMapper().readTree(file.toFile());
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
                    --time 10    | Invalid value for option '--time': expected a number above 0 with a unit ms, s, m or h, such as 10s, found '10'
                    --time 0s    | Invalid value for option '--time': expected a number above 0 with a unit ms, s, m or h, such as 10s, found '0s'
                    --time -1s   | Invalid value for option '--time': expected a number above 0 with a unit ms, s, m or h, such as 10s, found '-1s'
                    --error 0%   | Invalid value for option '--error': expected an error above 0 and up to 100%, such as 1% or 0.01, found '0%'
                    --error 101% | Invalid value for option '--error': expected an error above 0 and up to 100%, such as 1% or 0.01, found '101%'
                    --error 2    | Invalid value for option '--error': expected an error above 0 and up to 100%, such as 1% or 0.01, found '2'
                    --error little | Invalid value for option '--error': expected an error above 0 and up to 100%, such as 1% or 0.01, found 'little'
                    --error 1% --passes 4 | --passes and --error exclude each other
                    --time 1s --passes 4  | --passes and --time exclude each other
                    """)
    void render_givenBadGoal_saysWhyInOneLine(String options, String line) {
        Cli.Result result = render(options);
        assertThat(result.errorLines())
                .containsExactly("diacaustic render: " + line + "; see diacaustic render --help");
        assertThat(result.code()).isEqualTo(2);
        assertThat(picture).doesNotExist();
    }

    @ParameterizedTest
    @CsvSource({
        "--error 0.5%, caustic-mesh, error",
        "--error 0.005, caustic-mesh, error",
        "--error 20%, photon-map, noise",
        "--time 900ms, caustic-mesh, error",
        "--time 900ms, photon-map, noise"
    })
    void render_givenGoal_tellsTheOptionsThatRepeatTheBits(String goal, String map, String what) throws IOException {
        Cli.Result result = render(goal + " --map " + map);
        assertThat(result.code()).as(result.err()).isZero();
        String line = result.out().strip();
        Matcher again = AGAIN.matcher(line);
        assertThat(again.find()).as(line).isTrue();
        assertThat(line).contains(what + " about ").contains("--map " + map);
        byte[] bytes = Files.readAllBytes(picture);
        assertThat(render(again.group(2)).code()).isZero();
        assertThat(Files.readAllBytes(picture)).isEqualTo(bytes);
    }

    @Test
    void render_givenErrorOutOfReach_writesThePictureAndSaysWhatIsMissing() {
        Cli.Result result = render("--time 700ms --error 1e-15");
        assertThat(result.code()).isEqualTo(4);
        assertThat(picture).exists();
        assertThat(result.out()).contains("error about ");
        assertThat(result.errorLines())
                .singleElement()
                .asString()
                .matches("diacaustic: error of 1\\.0e-13 % was asked for, about [0-9.]+ % is reached: "
                        + "there is no time for more light rays");
    }

    @Test
    void render_givenTooLittleTimeForOnePicture_savesWhatThereIsUnderAnotherName() {
        Cli.Result result = render("--time 1ms");
        assertThat(result.code()).isEqualTo(4);
        assertThat(picture).doesNotExist();
        assertThat(folder.resolve("out.partial.pfm")).exists();
        assertThat(result.errorLines())
                .singleElement()
                .asString()
                .startsWith(
                        "diacaustic: the time is over before the first picture is done; saved 0 % of the picture as ");
    }

    @Test
    void render_givenSceneWithoutMap_isDoneAtOnce() {
        Cli.Result result = render("--error 0.001% --map none");
        assertThat(result.code()).isZero();
        assertThat(result.out())
                .startsWith(picture + ": 20 x 16, linear radiance, ")
                .doesNotContain("about");
    }

    @Test
    void render_givenStats_writesGoalAndRounds() throws IOException {
        JsonNode root = statistics("--error 0.5%");
        assertThat(root.get("errorEstimate").asDouble()).isBetween(0.0, 0.005);
        assertThat(root.get("noiseEstimate").isNull()).isTrue();
        assertThat(root.get("end").asText()).isEqualTo("done");
        assertThat(root.get("shortfall").isNull()).isTrue();
        JsonNode rounds = root.get("rounds");
        JsonNode last = rounds.get(rounds.size() - 1);
        // The scene's own number of rays is too small to be believed.
        assertThat(rounds.get(0).get("lightRays").asLong()).isEqualTo(1 << 14);
        assertThat(last.get("seconds").asDouble()).isPositive();
        assertThat(last.get("passes").asInt()).isEqualTo(1);
        assertThat(last.get("estimate")).isEqualTo(root.get("errorEstimate"));
        assertThat(root.at("/counters/plannedLightRays").asLong())
                .isEqualTo(last.get("lightRays").asLong());
        // Of each cell at least three vertices and a power as single precision, and two numbers.
        assertThat(root.at("/memory/bytesPerCell").asDouble()).isBetween(56.0, 200.0);
    }

    @Test
    void render_givenStatsOfPasses_writesTheirNoise() throws IOException {
        JsonNode root = statistics("--error 30% --map photon-map");
        assertThat(root.get("errorEstimate").isNull()).isTrue();
        assertThat(root.get("noiseEstimate").asDouble()).isBetween(0.0, 0.3);
        // Rounds of 1, 2, 4 and 8 passes.
        assertThat(root.at("/rounds/3/passes").asInt()).isEqualTo(8);
        assertThat(root.at("/memory/bytesPerCell").asDouble()).isZero();
    }

    @Test
    void render_givenNoGoal_hasNoRounds() throws IOException {
        JsonNode root = statistics("--rays 500");
        assertThat(root.get("rounds")).isEmpty();
        assertThat(root.get("end").asText()).isEqualTo("done");
    }
}
