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
        try (Stream<Path> files = Files.walk(Path.of("scenes"))) {
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
            Rendering rendering = Renderer.render(small(file), settings);
            assertAccounted(rendering, preProcessor);
            // A lattice on the water's surface has no point as near to the lamp as most of its light lands.
            boolean isHopeless = path.endsWith("light-on-water.yaml") && preProcessor.equals("planar");
            assertThat(rendering.forward().ledger().stored() > 0 || isHopeless)
                    .as(preProcessor)
                    .isTrue();
        }
    }

    @ParameterizedTest
    @MethodSource("scenes")
    void render_givenMesh_findsAllItsFluxAgainAndNothingThatIsNoNumber(Path path) {
        for (String preProcessor : List.of("own-map", "planar", "cube", "adaptive")) {
            SceneFile file = read(path);
            Rendering rendering = Renderer.render(small(file), mesh(file, preProcessor));
            assertAccounted(rendering, preProcessor);
            assertThat(rendering.forward().ledger().stored()).as(preProcessor).isPositive();
        }
    }

    @ParameterizedTest
    @MethodSource("scenes")
    void render_givenMeshAndAnyNumberOfThreads_givesTheSameBits(Path path) {
        SceneFile file = read(path);
        RenderPlan plan = RenderPlan.of(small(file), mesh(file, "own-map"));
        Rendering one = new RenderJob(plan, 1, (done, total) -> {}).run();
        for (int threads : new int[] {2, 5}) {
            Rendering many = new RenderJob(plan, threads, (done, total) -> {}).run();
            assertThat(many.image().samples()).isEqualTo(one.image().samples());
            assertThat(many.errorEstimate()).isEqualTo(one.errorEstimate()).isPositive();
        }
    }

    private static void assertAccounted(Rendering rendering, String preProcessor) {
        EnergyLedger ledger = rendering.forward().ledger();
        ForwardCounters counters = rendering.forward().counters();
        double found = ledger.stored() + ledger.absorbed() + ledger.escaped() + ledger.cut();
        assertThat(Math.abs(ledger.emitted() - found)).as(preProcessor).isLessThan(1e-12 * ledger.emitted());
        assertThat(counters.nonFinite()).as(preProcessor).isZero();
        assertThat(rendering.counters().nonFiniteSamples()).as(preProcessor).isZero();
    }

    private static Scene small(SceneFile file) {
        Scene whole = file.scene();
        return new Scene(whole.camera().withSize(20, 20), whole.lights(), whole.objects(), whole.background());
    }

    private static Settings mesh(SceneFile file, String preProcessor) {
        return file.settings().toBuilder()
                .forward(file.settings().forward().toBuilder()
                        .preProcessor(preProcessor)
                        .rays(3000)
                        .build())
                .maps(file.settings().maps().toBuilder()
                        .map(MapName.CAUSTIC_MESH)
                        .build())
                .samples(1)
                .build();
    }

    private static SceneFile read(Path path) {
        Problems problems = new Problems();
        SceneDocument document = SceneDocument.read(path, FileScope.inFolderOf(path), problems);
        return SceneReader.read(document, problems).orElseThrow(() -> new AssertionError(problems.toString()));
    }
}
