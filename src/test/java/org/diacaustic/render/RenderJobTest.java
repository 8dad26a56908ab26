package org.diacaustic.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import org.diacaustic.image.LinearImage;
import org.diacaustic.light.PointLight;
import org.diacaustic.material.Material;
import org.diacaustic.material.Medium;
import org.diacaustic.math.Color;
import org.diacaustic.math.Vector3;
import org.diacaustic.scene.Camera;
import org.diacaustic.scene.Scene;
import org.diacaustic.scene.Settings;
import org.diacaustic.shape.Plane;
import org.diacaustic.shape.Sphere;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class RenderJobTest {
    private static final ProgressListener NOBODY = (done, total) -> {};
    private static final int SAMPLES_FOR_HOURS = 1_000_000_000;
    /** A cancelled job takes milliseconds; a busy machine may add some. */
    private static final int WAIT_MILLISECONDS = 1000;

    private static RenderPlan plan(int width, int height, int samples) {
        Material glass = Material.builder()
                .transparency(Color.grey(0.9))
                .inside(Medium.of(1.5))
                .build();
        Material grey = Material.builder().diffuse(Color.grey(0.5)).build();
        Scene scene = Scene.builder()
                .camera(Camera.builder()
                        .from(new Vector3(0, 2, 6))
                        .to(Vector3.ZERO)
                        .size(width, height)
                        .build())
                .light(new PointLight(new Vector3(0, 9, 0), Color.grey(100)))
                .background(Color.grey(0.1))
                .object("ball", new Sphere(Vector3.ZERO, 1), glass)
                .object("floor", new Plane(new Vector3(0, -1, 0), Vector3.UNIT_Y), grey)
                .build();
        return RenderPlan.of(
                scene,
                Eye.withoutMap(Settings.physical().toBuilder()).samples(samples).build());
    }

    private static float[] alone(RenderPlan plan) {
        return new RenderJob(plan, 1, NOBODY).run().image().samples();
    }

    private static long jobThreads() {
        return Thread.getAllStackTraces().keySet().stream()
                .filter(thread -> thread.getName().startsWith("diacaustic-"))
                .count();
    }

    @ParameterizedTest
    @ValueSource(ints = {0, -1})
    void constructor_givenNoThreads_throws(int threads) {
        RenderPlan plan = plan(8, 8, 1);
        assertThatThrownBy(() -> new RenderJob(plan, threads, NOBODY))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("at least 1 thread");
    }

    @ParameterizedTest
    @ValueSource(ints = {2, 5, 1000})
    void run_givenAnyThreadCount_givesTheSameBits(int threads) {
        RenderPlan plan = plan(70, 50, 4);
        Rendering one = new RenderJob(plan, 1, NOBODY).run();
        Rendering many = new RenderJob(plan, threads, NOBODY).run();
        assertThat(many.image().samples()).isEqualTo(one.image().samples());
        assertThat(many.counters().intersectionTests()).isEqualTo(one.counters().intersectionTests());
    }

    @Test
    void run_givenOneSceneInManyJobsAtOnce_givesEachTheSameBits() throws Exception {
        RenderPlan plan = plan(40, 30, 4);
        float[] expected = alone(plan);
        ExecutorService callers = Executors.newFixedThreadPool(32);
        try {
            List<Callable<float[]>> jobs = new ArrayList<>();
            for (int i = 0; i < 32; i++) {
                int threads = 1 + i % 3;
                jobs.add(() -> new RenderJob(RenderPlan.of(plan.scene(), plan.settings()), threads, NOBODY)
                        .run()
                        .image()
                        .samples());
            }
            for (Future<float[]> image : callers.invokeAll(jobs)) {
                assertThat(image.get()).isEqualTo(expected);
            }
        } finally {
            callers.shutdownNow();
        }
    }

    /** What a cancelled job hands over is whole pixels of the picture, and black where it did not come. */
    @Test
    void cancel_givenRandomTimes_returnsSoonWithWholePixelsAndLeavesNoThread() throws Exception {
        RenderPlan plan = plan(48, 48, 16);
        float[] whole = alone(plan);
        Random random = new Random(7);
        int slow = 0;
        for (int round = 0; round < 200; round++) {
            RenderJob job = new RenderJob(plan, 1 + round % 4, NOBODY);
            LinearImage[] image = new LinearImage[1];
            Thread caller = new Thread(() -> image[0] = job.run().image());
            caller.start();
            TimeUnit.MICROSECONDS.sleep(random.nextInt(20_000));
            long start = System.nanoTime();
            job.cancel();
            caller.join(10_000);
            slow += System.nanoTime() - start > 200_000_000 ? 1 : 0;
            for (int i = 0; i < whole.length; i++) {
                float sample = image[0].samples()[i];
                assertThat(sample == 0 || sample == whole[i]).as("sample %d", i).isTrue();
            }
        }
        // A busy machine may keep a thread waiting for longer, but not often.
        assertThat(slow).as("rounds over 200 ms").isLessThan(5);
        assertThat(jobThreads()).isZero();
    }

    @Test
    void cancel_givenOnePixelOfManySamples_returnsSoon() throws Exception {
        RenderJob job = new RenderJob(plan(1, 1, SAMPLES_FOR_HOURS), 1, NOBODY);
        Thread caller = new Thread(job::run);
        caller.start();
        Thread.sleep(50);
        job.cancel();
        caller.join(WAIT_MILLISECONDS);
        assertThat(caller.isAlive()).isFalse();
    }

    @Test
    void cancel_givenRayBetweenMirrors_returnsSoon() throws Exception {
        Material mirror = Material.builder().reflectivity(Color.WHITE).build();
        Scene mirrors = Scene.builder()
                .camera(Camera.builder().size(1, 1).build())
                .object("front", new Plane(new Vector3(0, 0, -1), new Vector3(0, 0, 1)), mirror)
                .object("back", new Plane(new Vector3(0, 0, 1), new Vector3(0, 0, -1)), mirror)
                .build();
        Settings settings =
                Settings.physical().toBuilder().maxDepth(Integer.MAX_VALUE).build();
        RenderJob job = new RenderJob(RenderPlan.of(mirrors, settings), 1, NOBODY);
        Rendering[] rendering = new Rendering[1];
        Thread caller = new Thread(() -> rendering[0] = job.run());
        caller.start();
        Thread.sleep(50);
        assertThat(caller.isAlive()).isTrue();
        job.cancel();
        caller.join(WAIT_MILLISECONDS);
        assertThat(caller.isAlive()).isFalse();
        assertThat(rendering[0].isComplete()).isFalse();
    }

    @Test
    void cancel_givenBeforeRun_rendersNothing() {
        RenderJob job = new RenderJob(plan(8, 8, 1), 1, NOBODY);
        job.cancel();
        Rendering rendering = job.run();
        assertThat(rendering.isComplete()).isFalse();
        assertThat(rendering.tilesDone()).isZero();
    }

    @Test
    void run_givenInterrupt_returnsSoonAndKeepsTheStatus() throws Exception {
        RenderJob job = new RenderJob(plan(16, 16, SAMPLES_FOR_HOURS), 2, NOBODY);
        boolean[] kept = new boolean[1];
        Thread caller = new Thread(() -> {
            job.run();
            kept[0] = Thread.currentThread().isInterrupted();
        });
        caller.start();
        Thread.sleep(50);
        caller.interrupt();
        caller.join(WAIT_MILLISECONDS);
        assertThat(caller.isAlive()).isFalse();
        assertThat(kept[0]).isTrue();
        assertThat(jobThreads()).isZero();
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 4})
    void run_givenListenerThatThrows_throwsThatAndLeavesNoThread(int threads) {
        IllegalStateException mine = new IllegalStateException("no more, please");
        RenderJob job = new RenderJob(plan(160, 160, 4), threads, (done, total) -> {
            if (done == total / 10) {
                throw mine;
            }
        });
        assertThatThrownBy(job::run).isSameAs(mine);
        assertThat(jobThreads()).isZero();
    }

    @Test
    void run_givenJobThatHasRun_throws() {
        RenderJob job = new RenderJob(plan(8, 8, 1), 1, NOBODY);
        job.run();
        assertThatThrownBy(job::run).isInstanceOf(IllegalStateException.class).hasMessage("a job runs once");
    }

    @Test
    void run_givenListener_tellsEveryTileOnce() {
        List<Integer> heard = new ArrayList<>();
        new RenderJob(plan(70, 50, 1), 3, (done, total) -> {
                    assertThat(total).isEqualTo(5 * 4);
                    heard.add(done);
                })
                .run();
        // 70 x 50 pixels are 5 x 4 tiles of 16.
        assertThat(heard).containsExactly(1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20);
    }
}
