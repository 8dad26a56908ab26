package org.diacaustic.render;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.diacaustic.preprocess.EnergyLedger;
import org.diacaustic.preprocess.ForwardCounters;
import org.diacaustic.scene.ForwardSettings;
import org.diacaustic.scene.MapName;
import org.diacaustic.scene.MapSettings;
import org.diacaustic.scene.Scene;
import org.diacaustic.scene.Settings;
import org.diacaustic.scenefile.FileScope;
import org.diacaustic.scenefile.Problems;
import org.diacaustic.scenefile.SceneDocument;
import org.diacaustic.scenefile.SceneFile;
import org.diacaustic.scenefile.SceneReader;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** What holds for every scene in {@code scenes}, whatever traces its light. */
class BundledScenesTest {
    static List<Path> scenes() throws IOException {
        try (Stream<Path> files = Files.list(Path.of("scenes"))) {
            return files.filter(file -> file.toString().endsWith(".yaml"))
                    .sorted()
                    .toList();
        }
    }

    @ParameterizedTest
    @MethodSource("scenes")
    void render_givenAnyPreProcessor_findsAllItsFluxAgainAndNothingThatIsNoNumber(Path path) {
        for (String preProcessor : List.of("random", "monte-carlo", "planar", "cube", "adaptive")) {
            SceneFile file = read(path);
            ForwardSettings forward = file.settings().forward().toBuilder()
                    .preProcessor(preProcessor)
                    .rays(3000)
                    .baseRays(1000)
                    .batchRays(20)
                    .build();
            MapSettings maps =
                    file.settings().maps().toBuilder().map(MapName.PHOTON_MAP).build();
            Settings settings = file.settings().toBuilder()
                    .forward(forward)
                    .maps(maps)
                    .samples(1)
                    .build();
            Scene small = new Scene(
                    file.scene().camera().withSize(20, 20),
                    file.scene().lights(),
                    file.scene().objects(),
                    file.scene().background());

            Rendering rendering = Renderer.render(small, settings);

            EnergyLedger ledger = rendering.forward().ledger();
            ForwardCounters counters = rendering.forward().counters();
            double found = ledger.stored() + ledger.absorbed() + ledger.escaped() + ledger.cut();
            assertThat(Math.abs(ledger.emitted() - found)).as(preProcessor).isLessThan(1e-12 * ledger.emitted());
            assertThat(counters.lightRays()).as(preProcessor).isPositive();
            assertThat(counters.nonFinite()).as(preProcessor).isZero();
            assertThat(rendering.counters().nonFiniteSamples()).as(preProcessor).isZero();
        }
    }

    private static SceneFile read(Path path) {
        Problems problems = new Problems();
        SceneDocument document = SceneDocument.read(path, FileScope.inFolderOf(path), problems);
        return SceneReader.read(document, problems).orElseThrow(() -> new AssertionError(problems.toString()));
    }
}
