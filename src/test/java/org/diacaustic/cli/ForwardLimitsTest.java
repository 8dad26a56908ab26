package org.diacaustic.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Numbers of the forward pass that are beyond what can be counted: one line that says which, and exit code 2 or 4. */
class ForwardLimitsTest {
    @TempDir
    Path folder;

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
                    rays: 10000000000000 | 2 | settings.rays: expected a whole number
                    rays: 2000, map: ambient-maps, map-blur: 2 | 2 | map-blur must be odd
                    map: photon-map, preprocessor: adaptive, lattice-size: 100000 | 2 | smaller lattice-size
                    map: photon-map, preprocessor: adaptive, lattice-size: 725, split: 64 | 2 | 2152960000 cells, which are too many
                    preprocessor: adaptive, lattice-size: 100000, estimator: expected-count | 2 | smaller lattice-size
                    preprocessor: monte-carlo, base-rays: 600000000 | 2 | give fewer rays or base-rays
                    rays: 2000, initial-hits: 1 | 2 | take estimator 'expected-count'
                    rays: 2000, passes: 2000000000 | 4 | passes over a picture of this size
                    """)
    void render_givenTooMany_saysSoInOneLine(String settings, int code, String words) throws IOException {
        Path scene = SmallScene.in(folder, "rays: 2000", settings);
        Cli.Result result = Cli.run("render", scene, "-o", folder.resolve("out.png"), "--progress", "none");
        assertThat(result.errorLines()).singleElement().asString().contains(words);
        assertThat(result.code()).isEqualTo(code);
    }
}
