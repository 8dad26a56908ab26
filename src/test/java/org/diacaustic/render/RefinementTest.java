package org.diacaustic.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.diacaustic.render.Eye.clear;
import static org.diacaustic.render.Eye.matt;
import static org.diacaustic.render.Eye.v;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import org.diacaustic.light.Falloff;
import org.diacaustic.light.PointLight;
import org.diacaustic.light.SphereLight;
import org.diacaustic.math.Color;
import org.diacaustic.render.Refined.End;
import org.diacaustic.scene.Camera;
import org.diacaustic.scene.ForwardSettings;
import org.diacaustic.scene.MapName;
import org.diacaustic.scene.MapSettings;
import org.diacaustic.scene.Scene;
import org.diacaustic.scene.Settings;
import org.diacaustic.shape.Plane;
import org.diacaustic.shape.Sphere;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

@Timeout(60)
class RefinementTest {
    private static final ProgressListener NOBODY = (done, total) -> {};
    private static final int RAYS = 500;
    /** The fewest rays whose error is believed. */
    private static final int TRUSTED_RAYS = 1 << 14;

    private static Scene.Builder glassBall() {
        return Scene.builder()
                .camera(Camera.builder()
                        .from(v(0, 4, -6))
                        .to(v(0, 0, 0))
                        .size(24, 20)
                        .build())
                .light(new PointLight(v(0, 7, 0), Color.grey(50)))
                .object("floor", new Plane(v(0, 0, 0), v(0, 1, 0)), matt(0.8).build())
                .object("ball", new Sphere(v(0, 1.5, 0), 1), clear(1.5).build());
    }

    private static RenderPlan plan(MapName map) {
        return plan(glassBall().build(), map, 1);
    }

    private static RenderPlan plan(Scene scene, MapName map, int samples) {
        return RenderPlan.of(
                scene,
                Settings.physical().toBuilder()
                        .forward(ForwardSettings.builder().rays(RAYS).build())
                        .maps(MapSettings.builder().map(map).build())
                        .samples(samples)
                        .build());
    }

    private static Refined refine(RenderPlan plan, Goal goal) {
        return new Refinement(plan, goal, 2, NOBODY).run();
    }

    private static long in(double seconds) {
        return System.nanoTime() + (long) (1e9 * seconds);
    }

    private static void assertRepeats(Refined refined) {
        Rendering alone = new RenderJob(refined.plan(), 1, NOBODY).run();
        assertThat(alone.image().samples())
                .isEqualTo(refined.rendering().image().samples());
    }

    @Test
    void goal_givenNothingOrNoPositiveError_throws() {
        assertThatThrownBy(() -> new Goal(OptionalDouble.empty(), OptionalLong.empty()))
                .isInstanceOf(IllegalArgumentException.class);
        for (double error : new double[] {0, -1, Double.NaN}) {
            assertThatThrownBy(() -> Goal.ofError(error)).isInstanceOf(IllegalArgumentException.class);
        }
    }

    @Test
    void run_givenNoThreadsOrTwice_throws() {
        RenderPlan plan = plan(MapName.CAUSTIC_MESH);
        assertThatThrownBy(() -> new Refinement(plan, Goal.ofError(1), 0, NOBODY))
                .isInstanceOf(IllegalArgumentException.class);
        Refinement refinement = new Refinement(plan, Goal.ofError(1), 1, NOBODY);
        refinement.run();
        assertThatThrownBy(refinement::run).isInstanceOf(IllegalStateException.class);
    }

    @Test
    void run_givenErrorAndMesh_addsRaysUntilItIsMet() {
        Refined refined = refine(plan(MapName.CAUSTIC_MESH), Goal.ofError(0.0003));
        assertThat(refined.end()).isEqualTo(End.DONE);
        assertThat(refined.shortfall()).isEmpty();
        assertThat(refined.estimate()).isLessThanOrEqualTo(0.0003);
        assertThat(refined.rounds()).hasSizeGreaterThan(1);
        assertThat(refined.rounds().get(0).lightRays()).isEqualTo(TRUSTED_RAYS);
        for (int i = 1; i < refined.rounds().size(); i++) {
            assertThat(refined.rounds().get(i - 1).estimate()).isGreaterThan(0.0003);
            long before = refined.rounds().get(i - 1).lightRays();
            assertThat(refined.rounds().get(i).lightRays()).isBetween(2 * before, 16 * before);
        }
        Round last = refined.rounds().get(refined.rounds().size() - 1);
        assertThat(last.estimate()).isEqualTo(refined.estimate());
        assertThat(refined.plan().settings().forward().rays()).isEqualTo(last.lightRays());
        assertRepeats(refined);
    }

    /** Lights with random numbers, lights that are seen, mirrors and samples: all that rounds share must be the same. */
    @Test
    void run_givenSoftLightsAndSamples_repeatsTheBitsOfItsPlan() {
        Scene scene = glassBall()
                .light(new SphereLight(v(2, 3, 1), 0.4, Color.grey(3), new Falloff.InverseSquare(), 3))
                .object("mirror", new Sphere(v(-2, 1, 1), 1), Eye.mirror(0.5).build())
                .build();
        Goal goal = new Goal(OptionalDouble.of(0.1), OptionalLong.of(in(1e6)));
        Refined refined = refine(plan(scene, MapName.CAUSTIC_MESH, 3), goal);
        assertThat(refined.rounds()).hasSizeGreaterThan(1);
        assertThat(refined.rendering().counters().shadowRays()).isPositive();
        assertRepeats(refined);
    }

    @Test
    void run_givenAutomaticMap_keepsToTheMapOfThePlan() {
        Settings settings = Settings.physical().toBuilder()
                .forward(ForwardSettings.builder().rays(RAYS).build())
                .build();
        RenderPlan plan = RenderPlan.of(glassBall().build(), settings);
        Refined refined = refine(plan, Goal.ofError(0.3));
        assertThat(refined.plan().forward().get().map())
                .isEqualTo(plan.forward().get().map());
        List<Decision> maps = refined.plan().decisions().stream()
                .filter(decision -> decision.part().equals("map"))
                .toList();
        assertThat(plan.decisions()).containsAll(maps);
        assertThat(maps).hasSize(1);
        assertRepeats(refined);
    }

    @Test
    void run_givenErrorAndPhotons_averagesPassesUntilTheNoiseIsSmall() {
        Refined refined = refine(plan(MapName.PHOTON_MAP), Goal.ofError(0.05));
        assertThat(refined.end()).isEqualTo(End.DONE);
        assertThat(refined.rendering().errorEstimate()).isNaN();
        assertThat(refined.rendering().noiseEstimate()).isLessThanOrEqualTo(0.05);
        assertThat(refined.plan().passes()).isGreaterThanOrEqualTo(8);
        assertRepeats(refined);
    }

    /** Each pass has the lattice of all others: how they differ tells nothing, and more of them bring nothing. */
    @Test
    void run_givenPassesThatAreAlike_saysThatNoiseCannotBeTold() {
        RenderPlan same = RenderPlan.of(
                glassBall().build(),
                Settings.physical().toBuilder()
                        .forward(ForwardSettings.builder()
                                .preProcessor("planar")
                                .shiftLattice(false)
                                .rays(RAYS)
                                .build())
                        .minimumThroughput(0)
                        .maps(MapSettings.builder().map(MapName.PHOTON_MAP).build())
                        .build());
        Refined refined = refine(same, Goal.ofError(0.01));
        assertThat(refined.end()).isEqualTo(End.NO_PROGRESS);
        assertThat(refined.shortfall())
                .hasValue("noise of 1.0 % was asked for, it cannot be told: all passes are alike");
        assertThat(refined.plan().passes()).isEqualTo(8);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.5, 1e-9})
    void run_givenSceneWithoutMap_rendersOnce(double error) {
        Refined refined = refine(plan(MapName.NONE), Goal.ofError(error));
        assertThat(refined.end()).isEqualTo(End.DONE);
        assertThat(refined.shortfall()).isEmpty();
        assertThat(refined.rounds()).hasSize(1);
        assertRepeats(refined);
    }

    @ParameterizedTest
    @ValueSource(strings = {"CAUSTIC_MESH", "PHOTON_MAP"})
    void run_givenTime_isReadyWithAWholePicture(MapName map) {
        long start = System.nanoTime();
        Refined refined = refine(plan(map), Goal.until(in(0.8)));
        double seconds = (System.nanoTime() - start) * 1e-9;
        assertThat(refined.end()).isEqualTo(End.TIME);
        assertThat(refined.shortfall()).isEmpty();
        assertThat(refined.rendering().isComplete()).isTrue();
        // A busy machine may stop a thread for a while.
        assertThat(seconds).isLessThan(0.8 + 0.5);
        assertRepeats(refined);
    }

    @Test
    void run_givenTimeBeforeTheError_saysWhatIsMissing() {
        Refined refined =
                refine(plan(MapName.CAUSTIC_MESH), new Goal(OptionalDouble.of(1e-9), OptionalLong.of(in(0.6))));
        assertThat(refined.end()).isEqualTo(End.TIME);
        assertThat(refined.rendering().isComplete()).isTrue();
        assertThat(refined.shortfall().get())
                .matches("error of 1\\.0e-07 % was asked for, about [0-9.]+ % is reached: "
                        + "there is no time for more light rays");
    }

    @Test
    void run_givenErrorBeforeTheTime_isReadyAtOnce() {
        Refined refined =
                refine(plan(MapName.CAUSTIC_MESH), new Goal(OptionalDouble.of(0.9), OptionalLong.of(in(1e6))));
        assertThat(refined.end()).isEqualTo(End.DONE);
        // The first round is for measuring, and its error is not believed.
        assertThat(refined.rounds()).extracting(Round::lightRays).containsExactly((long) RAYS, (long) TRUSTED_RAYS);
    }

    @Test
    void run_givenTimeThatIsOver_returnsWhatThereIs() {
        Refined refined = refine(plan(MapName.CAUSTIC_MESH), Goal.until(in(-1)));
        assertThat(refined.end()).isEqualTo(End.TIME);
        assertThat(refined.rendering().isComplete()).isFalse();
        assertThat(refined.shortfall()).hasValue("the time is over with 0 % of the first picture done");
    }

    @ParameterizedTest
    @ValueSource(strings = {"CAUSTIC_MESH", "PHOTON_MAP"})
    void cancel_givenLaterRound_returnsTheLastWholePicture(MapName map) {
        AtomicReference<Refinement> job = new AtomicReference<>();
        AtomicInteger begun = new AtomicInteger();
        job.set(new Refinement(plan(map), Goal.ofError(1e-9), 2, (done, total) -> {
            // A mesh tells of each round from its beginning. Of passes the first is told as an eighth, and the second
            // as another.
            if (map == MapName.CAUSTIC_MESH ? done == 1 && begun.incrementAndGet() == 2 : done == 200) {
                job.get().cancel();
            }
        }));
        Refined refined = job.get().run();
        assertThat(refined.end()).isEqualTo(End.CANCELLED);
        assertThat(refined.rendering().isComplete()).isTrue();
        assertThat(refined.shortfall().get()).endsWith("it was cancelled");
        assertRepeats(refined);
    }

    @Test
    void cancel_givenFirstRound_returnsWhatThereIs() {
        Refinement refinement = new Refinement(plan(MapName.CAUSTIC_MESH), Goal.ofError(0.1), 2, NOBODY);
        refinement.cancel();
        Refined refined = refinement.run();
        assertThat(refined.end()).isEqualTo(End.CANCELLED);
        assertThat(refined.rendering().isComplete()).isFalse();
        assertThat(refined.shortfall()).hasValue("it was cancelled before the first picture was done");
    }

    @Test
    void run_givenInterrupt_endsAndKeepsTheStatus() throws Exception {
        boolean[] kept = new boolean[1];
        Thread caller = new Thread(() -> {
            refine(plan(MapName.CAUSTIC_MESH), Goal.ofError(1e-9));
            kept[0] = Thread.currentThread().isInterrupted();
        });
        caller.start();
        Thread.sleep(300);
        caller.interrupt();
        caller.join(10_000);
        assertThat(caller.isAlive()).isFalse();
        assertThat(kept[0]).isTrue();
    }

    @Test
    void listener_givenDeadline_hearsTheTimeInEqualSteps() {
        List<Integer> heard = new ArrayList<>();
        new Refinement(plan(MapName.CAUSTIC_MESH), Goal.until(in(0.7)), 2, (done, total) -> {
                    assertThat(total).isEqualTo(1000);
                    heard.add(done);
                })
                .run();
        for (int i = 0; i < heard.size(); i++) {
            assertThat(heard.get(i)).isEqualTo(i + 1);
        }
        assertThat(heard).hasSize(1000);
    }
}
