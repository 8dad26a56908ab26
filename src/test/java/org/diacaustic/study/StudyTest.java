package org.diacaustic.study;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.util.List;
import java.util.Map;
import org.diacaustic.scenefile.Problems;
import org.diacaustic.scenefile.SceneDocument;
import org.diacaustic.scenefile.SceneFile;
import org.diacaustic.scenefile.SceneReader;
import org.junit.jupiter.api.Test;

class StudyTest {
    /** The light of the ball is spread wide, without a fold, so that every technique can be right. */
    private static final String SCENE = """
            camera: {from: [-2, 6, 5], to: [-1.2, 0, 0], size: [40, 40], field-of-view: 20}
            lights:
              - point: {at: [3, 9, 0], intensity: 100}
            materials:
              grey: {diffuse: 0.5}
              glass: {transparency: 1, ior: 1.5}
            objects:
              - polygon: {name: floor, vertices: [[-5, 0, 5], [5, 0, 5], [5, 0, -5], [-5, 0, -5]], material: grey}
              - sphere: {name: ball, at: [0, 2.6, 0], radius: 1, material: glass}
            """;

    private static SceneFile read(Map<String, String> overrides) {
        Problems problems = new Problems();
        SceneDocument document = SceneDocument.parse("ball.yaml", SCENE, problems);
        overrides.forEach((key, value) -> document.override("settings", key, value));
        return SceneReader.read(document, problems).orElseThrow(() -> new AssertionError(problems));
    }

    private static Reference reference(String preProcessor, long rays) throws IOException {
        return new ReferenceRender(StudyTest::read, preProcessor, 2)
                .run(new ReferenceBudget.Rays(rays), (done, total) -> {});
    }

    @Test
    void constructor_givenNoRays_isRefused() throws IOException {
        Reference reference = reference(ReferenceRender.PRE_PROCESSOR, 1000);
        List<Technique> techniques = Techniques.known();
        assertThatThrownBy(() -> new Study(StudyTest::read, reference, techniques, List.of()))
                .isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> new Study(StudyTest::read, reference, techniques, List.of(0L)))
                .isInstanceOf(IllegalArgumentException.class);
    }

    @Test
    void run_givenRandomLightTracing_findsTheSlopeOfChance() throws IOException {
        StudyReport report = new Study(
                        StudyTest::read,
                        reference(ReferenceRender.PRE_PROCESSOR, 800_000),
                        Techniques.parse("light-tracing"),
                        List.of(64_000L, 1000L, 4000L, 16_000L))
                .run(2, (done, total) -> {});
        TechniqueStudy study = report.studies().get(0);
        assertThat(study.runs()).extracting(StudyRun::rays).containsExactly(1000L, 4000L, 16_000L, 64_000L);
        // −1/2, and the scatter of four measured errors.
        assertThat(study.slope().value()).isCloseTo(-0.5, within(0.06));
        assertThat(report.table()).contains("error falls like light rays to the power -0.");
    }

    @Test
    void run_givenPhotonMaps_findsTheLightTheReferenceHas() throws IOException {
        StudyReport report = new Study(
                        StudyTest::read,
                        reference("random", 800_000),
                        Techniques.parse("planar-photons,adaptive-photons"),
                        List.of(100_000L))
                .run(2, (done, total) -> {});
        for (TechniqueStudy study : report.studies()) {
            PictureError error = study.runs().get(0).error();
            assertThat(error.noiseRms()).isBetween(0.001, 0.1);
            assertThat(error.bias()).isCloseTo(0, within(0.003));
            // Their kernels blur the edge of the shadow.
            assertThat(error.rms()).isLessThan(0.06);
        }
    }

    @Test
    void reference_givenTwoWaysToChooseItsRays_differsByNoMoreThanItsNoise() throws IOException {
        Reference random = reference("random", 800_000);
        Reference even = reference(JitteredPreProcessor.NAME, 400_000);
        DiffusePixels pixels = DiffusePixels.of(read(Map.of()).scene());
        double expected = Math.hypot(
                PictureError.of(even.picture(), random, pixels).noiseRms(),
                PictureError.of(random.picture(), even, pixels).noiseRms());
        double measured = PictureError.of(even.picture(), random, pixels).measuredRms();
        // About a thousand pixels: the quotient scatters by a few per cent.
        assertThat(measured / expected).isBetween(0.85, 1.15);
    }

    @Test
    void reference_givenTheSameRays_isTheSameToTheBitOnAnyThreads() throws IOException {
        ReferenceBudget budget = new ReferenceBudget.Rays(30_000);
        Reference one = new ReferenceRender(StudyTest::read, "random", 1).run(budget, (done, total) -> {});
        Reference three = new ReferenceRender(StudyTest::read, "random", 3).run(budget, (done, total) -> {});
        assertThat(three.picture().samples()).isEqualTo(one.picture().samples());
        assertThat(three.standardError().orElseThrow().samples())
                .isEqualTo(one.standardError().orElseThrow().samples());
        assertThat(three.batches()).isEqualTo(16);
    }
}
