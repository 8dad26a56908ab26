package org.diacaustic.study;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.diacaustic.page.StudyPage;
import org.diacaustic.preprocess.PreProcessor;
import org.diacaustic.scenefile.Problems;
import org.diacaustic.scenefile.SceneDocument;
import org.diacaustic.scenefile.SceneFile;
import org.diacaustic.scenefile.SceneReader;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

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

    /** The same with a ball of nothing. */
    private static final String STRAIGHT = SCENE.replace("ior: 1.5", "ior: 1");

    @TempDir
    Path folder;

    private static SceneSource source(String scene) {
        return overrides -> read(scene, overrides);
    }

    private static SceneFile read(String scene, Map<String, String> overrides) {
        Problems problems = new Problems();
        SceneDocument document = SceneDocument.parse("ball.yaml", scene, problems);
        overrides.forEach((key, value) -> document.override("settings", key, value));
        return SceneReader.read(document, problems).orElseThrow(() -> new AssertionError(problems));
    }

    private static Reference reference(String preProcessor, long rays) throws IOException {
        return new ReferenceRender(source(SCENE), preProcessor, 2)
                .run(new ReferenceBudget.Rays(rays), (done, total) -> {})
                .orElseThrow();
    }

    private static StudyRequest request(String techniques, int seeds, long... rays) {
        List<Budget> budgets = new ArrayList<>();
        for (long count : rays) {
            budgets.add(new Budget.Rays(count));
        }
        Machine machine = new Machine("", "", 1, "", "test");
        return new StudyRequest("ball", "study ball", machine, Techniques.parse(techniques), budgets, seeds, 2);
    }

    private StudyFolder open() throws IOException {
        return StudyFolder.open(folder, Map.of("scene", "ball"), false);
    }

    private StudyReport run(StudyRequest request, Reference reference) throws IOException {
        if (open().reference().isEmpty()) {
            open().keep(reference);
        }
        return new Study(source(SCENE), request, reference, open()).run((done, total) -> {});
    }

    @Test
    void request_givenNothingToCompare_isRefused() {
        assertThatThrownBy(() -> request("caustic-mesh", 1)).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> request("caustic-mesh", 0, 1000)).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> request("caustic-mesh", 1, 1000, 1000)).hasMessageContaining("two budgets of '1000'");
        List<Technique> twice =
                List.of(Techniques.known().get(0), Techniques.known().get(0));
        List<Budget> budgets = List.of(new Budget.Rays(1));
        assertThatThrownBy(() -> new StudyRequest("", "", null, twice, budgets, 1, 1))
                .hasMessageContaining("two techniques named 'caustic-mesh'");
    }

    @Test
    void seedsFor_givenCheapAndDearPoints_isFewerForDearOnes() {
        StudyRequest request = request("caustic-mesh", 20, 1000);
        assertThat(request.seedsFor(1000)).isEqualTo(20);
        assertThat(request.seedsFor(500_000)).isEqualTo(10);
        assertThat(request.seedsFor(1e9)).isEqualTo(3);
        assertThat(request("caustic-mesh", 2, 1000).seedsFor(1e9)).isEqualTo(2);
    }

    @Test
    void run_givenRandomLightTracing_findsTheSlopeOfChance() throws IOException {
        StudyReport report = run(
                request("light-tracing", 4, 64_000, 1000, 4000, 16_000),
                reference(ReferenceRender.PRE_PROCESSOR, 500_000));
        TechniqueStudy study = report.studies().get(0);
        assertThat(study.points()).extracting(StudyPoint::rays).containsExactly(1000L, 4000L, 16_000L, 64_000L);
        PowerFit error = study.errorFit(Measure.LIGHT_RAYS);
        // −1/2, and the scatter of sixteen measured errors.
        assertThat(error.power()).isCloseTo(-0.5, within(0.03));
        for (StudyPoint point : study.points()) {
            // All of it is chance.
            assertThat(Math.abs(point.squaredBias())).isLessThan(0.1 * point.variance());
            assertThat(point.variance()).isCloseTo(point.error() * point.error(), within(0.1 * point.variance()));
        }
        assertThat(report.isComplete()).isTrue();
    }

    @Test
    void run_givenPhotonMaps_findsTheLightTheReferenceHas() throws IOException {
        StudyReport report = run(request("planar-nearest,adaptive-nearest", 2, 100_000), reference("random", 800_000));
        for (TechniqueStudy study : report.studies()) {
            StudyPoint point = study.points().get(0);
            assertThat(point.referenceError()).isBetween(0.001, 0.1);
            assertThat(point.mean(Measure.BRIGHTNESS)).isCloseTo(0, within(0.003));
            // Their kernels blur the edge of the shadow.
            assertThat(point.error()).isLessThan(0.06);
        }
        // What is seen without any of the light.
        StudyRun dark = report.shading().get(0).run();
        assertThat(dark.get(Measure.BRIGHTNESS)).isNegative();
    }

    @Test
    void run_givenASceneThatBendsNothing_findsEveryCalibratedTechniqueRight() throws IOException {
        Reference straight = new ReferenceRender(source(STRAIGHT), ReferenceRender.PRE_PROCESSOR, 2)
                .run(new ReferenceBudget.Rays(400_000), (done, total) -> {})
                .orElseThrow();
        assertThat(straight.origin()).isEqualTo(Reference.Origin.STRAIGHT_RAYS);
        StudyReport report = new Study(
                        source(STRAIGHT), request("caustic-mesh,cube-density", 2, 60_000), straight, open())
                .run((done, total) -> {});
        assertThat(report.studies().get(0).points().get(0).mean(Measure.MEASURED_RMS_ERROR))
                .isLessThan(0.005);
        assertThat(report.studies().get(1).points().get(0).mean(Measure.BRIGHTNESS))
                .isCloseTo(0, within(0.005));
        // The same radius for all that have one.
        assertThat(report.studies().get(1).technique().settings())
                .containsEntry("gather-radius", Double.toString(report.gatherRadius()));
    }

    @Test
    void run_givenTheSameTwice_findsTheSameErrorsToTheLastDigit() throws IOException {
        Reference reference = reference("random", 30_000);
        StudyRequest request = request("caustic-mesh,monte-carlo-progressive,light-tracing", 3, 2000, 20_000);
        StudyReport one = new Study(
                        source(SCENE), request, reference, StudyFolder.open(folder.resolve("a"), Map.of(), false))
                .run((done, total) -> {});
        StudyReport two = new Study(
                        source(SCENE), request, reference, StudyFolder.open(folder.resolve("b"), Map.of(), false))
                .run((done, total) -> {});
        assertThat(repeatable(two)).isEqualTo(repeatable(one)).isNotEmpty();
    }

    private static List<Map<Measure, Double>> repeatable(StudyReport report) {
        return report.studies().stream()
                .flatMap(study -> study.points().stream())
                .flatMap(point -> point.runs().stream())
                .map(run -> run.values().entrySet().stream()
                        .filter(entry -> entry.getKey().isRepeatable())
                        .collect(Collectors.toMap(Map.Entry::getKey, Map.Entry::getValue)))
                .toList();
    }

    @Test
    void run_givenAStopAfterSomePoints_goesOnWhereItWas() throws IOException {
        Reference reference = reference("random", 30_000);
        StudyRequest request = request("random-density,caustic-mesh", 2, 1000, 4000, 8000);
        open().keep(reference);
        Study stopped = new Study(source(SCENE), request, reference, open());
        StudyReport part = stopped.run((done, total) -> {
            if (done > total / 4) {
                stopped.cancel();
            }
        });
        assertThat(part.isComplete()).isFalse();
        assertThat(part.points()).isBetween(1, 5);
        assertThat(part.pointsPlanned()).isEqualTo(6);
        Path first = folder.resolve("points/random-density@1000.json");
        String kept = Files.readString(first);

        StudyReport whole = run(request, reference);
        assertThat(whole.isComplete()).isTrue();
        // With its times, which no second run would give again.
        assertThat(Files.readString(first)).isEqualTo(kept);
        assertThat(whole.studies().get(0).points().get(0))
                .isEqualTo(part.studies().get(0).points().get(0));
    }

    @Test
    void run_givenTheNameWithOtherSettings_rendersItAgain() throws IOException {
        Reference reference = reference("random", 30_000);
        String name = "mine:preprocessor=random:map=photon-map:gather-count=";
        StudyReport few = run(request(name + 5, 2, 1000), reference);
        StudyReport many = run(request(name + 50, 2, 1000), reference);
        assertThat(many.studies().get(0).points())
                .isNotEqualTo(few.studies().get(0).points());
        assertThat(run(request(name + 50, 2, 1000), reference).studies()).isEqualTo(many.studies());
    }

    @Test
    void open_givenAnotherStudy_isRefusedUntilItIsForgotten() throws IOException {
        Reference reference = reference("random", 1000);
        // Nothing is kept before there is a reference.
        StudyFolder.open(folder, Map.of("scene", "cone"), false);
        open().keep(reference);
        Map<String, String> other = Map.of("scene", "cube");
        assertThatThrownBy(() -> StudyFolder.open(folder, other, false))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("holds a study with scene ball, but this one has cube; take another folder, or");
        // Asking to forget forgets nothing yet.
        StudyFolder restarted = StudyFolder.open(folder, other, true);
        assertThat(open().reference()).isPresent();
        Reference bare =
                new Reference(Reference.Origin.GIVEN, reference.picture(), Optional.empty(), Optional.empty(), 0, 0, 0);
        restarted.keep(bare);
        Reference kept = StudyFolder.open(folder, other, false).reference().orElseThrow();
        assertThat(kept.standardError()).as("of the reference before").isEmpty();
        assertThat(kept.halves()).isEmpty();
    }

    @Test
    void run_givenAPointThatWasCutShort_rendersItAgain() throws IOException {
        Reference reference = reference("random", 30_000);
        StudyRequest request = request("random-nearest", 2, 1000);
        StudyReport first = run(request, reference);
        for (String damaged : new String[] {"", "{\"settings\": \"INTO", "[1]"}) {
            Files.writeString(folder.resolve("points/random-nearest@1000.json"), damaged);
            assertThat(repeatable(run(request, reference))).isEqualTo(repeatable(first));
        }
    }

    @Test
    void requireComparable_givenNothingToCompare_isRefused() throws IOException {
        Study.requireComparable(source(SCENE));
        assertThatThrownBy(() -> Study.requireComparable(source(SCENE.replace("transparency: 1, ", "diffuse: 1, "))))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("nothing to compare");
        assertThatThrownBy(
                        () -> Study.requireComparable(source(SCENE.replace("to: [-1.2, 0, 0]", "to: [-2, 12, 5.1]"))))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("no pixel shows");
    }

    @Test
    void run_givenATechniqueThatCannot_saysWhyAndGoesOn() throws IOException {
        StudyReport report = run(
                request("bad:preprocessor=random:map=caustic-mesh,random-nearest", 1, 1000),
                reference("random", 30_000));
        assertThat(report.studies().get(0).refusal()).contains("random");
        assertThat(report.studies().get(0).points()).isEmpty();
        assertThat(report.studies().get(1).points()).hasSize(1);
        assertThat(report.isComplete()).isTrue();
    }

    @Test
    void run_givenABudgetOfTime_findsRaysForIt() throws IOException {
        Machine machine = new Machine("", "", 1, "", "test");
        StudyRequest request = new StudyRequest(
                "ball", "", machine, Techniques.parse("random-nearest"), List.of(new Budget.Seconds(0.2)), 1, 2);
        StudyPoint point = run(request, reference("random", 30_000))
                .studies()
                .get(0)
                .points()
                .get(0);
        // A busy machine may take much longer than the trials said.
        assertThat(point.rays()).isGreaterThan(1000);
        assertThat(point.mean(Measure.WALL_SECONDS)).isBetween(0.002, 10.0);
    }

    @Test
    void write_givenATechniqueThatIsTooBright_exposesItOnThePage() throws IOException {
        Path services = Files.createDirectories(folder.resolve("META-INF/services"));
        Files.writeString(services.resolve(PreProcessor.class.getName()), TooBright.class.getName());
        Thread thread = Thread.currentThread();
        ClassLoader usual = thread.getContextClassLoader();
        try (URLClassLoader withDouble =
                new URLClassLoader(new URL[] {folder.toUri().toURL()}, usual)) {
            thread.setContextClassLoader(withDouble);
            exposesTooBright();
        } finally {
            thread.setContextClassLoader(usual);
        }
    }

    private void exposesTooBright() throws IOException {
        String wrong = "bright:preprocessor=too-bright:map=photon-map:estimator=density";
        StudyReport report = run(request(wrong + ",random-density", 8, 10_000, 100_000), reference("random", 800_000));
        StudyPoint bright = report.studies().get(0).points().get(1);
        StudyPoint right = report.studies().get(1).points().get(1);
        assertThat(bright.distribution(Measure.BRIGHTNESS).meanInterval().contains(0.05))
                .isTrue();
        assertThat(right.distribution(Measure.BRIGHTNESS).meanInterval().contains(0))
                .isTrue();
        String page = Files.readString(StudyPage.write(report, open()));
        assertThat(page)
                .containsPattern("bright is [45](\\.\\d+)?.% too bright at every budget: more rays do not help");
        assertThat(page).doesNotContainPattern("random-density is \\d");
    }

    @Test
    void reference_givenTwoWaysToChooseItsRays_differsByNoMoreThanItsNoise() throws IOException {
        Reference random = reference("random", 800_000);
        Reference even = reference(JitteredPreProcessor.NAME, 400_000);
        DiffusePixels pixels = DiffusePixels.of(read(SCENE, Map.of()).scene());
        ErrorMeter meter = new ErrorMeter(random, random.picture(), pixels);
        double expected = Math.hypot(meter.noise(), new ErrorMeter(even, even.picture(), pixels).noise());
        double measured = meter.measure(even.picture()).get(Measure.MEASURED_RMS_ERROR);
        // About a thousand pixels: the quotient scatters by a few per cent.
        assertThat(measured / expected).isBetween(0.85, 1.15);
    }

    @Test
    void reference_givenItsHalves_differAsItsNoiseSays() throws IOException {
        Reference reference = reference(JitteredPreProcessor.NAME, 400_000);
        DiffusePixels pixels = DiffusePixels.of(read(SCENE, Map.of()).scene());
        double squares = 0;
        double mean = 0;
        for (int i = 0; i < 1600; i++) {
            if (pixels.includes(i % 40, i / 40)) {
                squares += Math.pow(reference.halves().orElseThrow().samples()[3 * i], 2) / pixels.count();
                mean += reference.picture().samples()[3 * i] / pixels.count();
            }
        }
        // Each half has twice the variance of the whole, and their difference four times.
        assertThat(Math.sqrt(squares) / mean / (2 * new ErrorMeter(reference, reference.picture(), pixels).noise()))
                .isBetween(0.85, 1.15);
    }

    @Test
    void reference_givenTheSameRays_isTheSameToTheBitOnAnyThreads() throws IOException {
        ReferenceBudget budget = new ReferenceBudget.Rays(30_000);
        Reference one = new ReferenceRender(source(SCENE), "random", 1)
                .run(budget, (done, total) -> {})
                .orElseThrow();
        Reference three = new ReferenceRender(source(SCENE), "random", 3)
                .run(budget, (done, total) -> {})
                .orElseThrow();
        assertThat(three.picture().samples()).isEqualTo(one.picture().samples());
        assertThat(three.standardError().orElseThrow().samples())
                .isEqualTo(one.standardError().orElseThrow().samples());
        assertThat(three.batches()).isEqualTo(4);
    }
}
