package org.diacaustic.fault;

import java.util.Arrays;
import java.util.List;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import java.util.SplittableRandom;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Supplier;
import org.diacaustic.render.Goal;
import org.diacaustic.render.ProgressListener;
import org.diacaustic.render.Refinement;
import org.diacaustic.render.RenderJob;
import org.diacaustic.render.RenderPlan;
import org.diacaustic.render.Rendering;
import org.diacaustic.scenefile.Problems;
import org.diacaustic.scenefile.SceneDocument;
import org.diacaustic.scenefile.SceneFile;
import org.diacaustic.scenefile.SceneReader;
import org.diacaustic.stability.Checks;

/** The library as other programs use it, in this process. */
final class LibraryFaults {
    private static final int RENDERS = 32;
    private static final int CANCELLATIONS = 1000;

    /** Of the times at which renders are cancelled. */
    private static final long SEED = 31;

    private static final long LATEST_NANOSECONDS = 4_000_000;
    private static final long LONGEST_NANOSECONDS = 200_000_000;
    private static final int PATIENCE_MILLISECONDS = 10_000;
    private static final String ENDLESS = FaultScene.with(FaultScene.RAYS, "samples: 1000000000, rays: 2000");

    private LibraryFaults() {}

    static void addTo(FaultOperations operations) {
        operations
                .add(
                        "concurrent",
                        "32 renders at once in this process, of one plan and of plans of their own of one scene, on one to three threads"
                                + " each: every picture has the bits of one that is rendered alone.",
                        (bench, asked, checks) -> concurrent(checks))
                .add(
                        "cancel",
                        "1000 renders without end in this process, with and without a forward pass, on one to four threads, cancelled by"
                                + " another thread, by interrupt, or through a goal, at random times up to 4 ms (seed 31): each returns within 200 ms (the best of up to three) with"
                                + " what there is, the interrupt stays set, no thread is left.",
                        (bench, asked, checks) -> cancel(checks))
                .add(
                        "listenerthrows",
                        "A listener that throws an exception or an error at the first report, at 10 %, or at the end, on one to eight threads,"
                                + " in the forward pass and in rows, in jobs and in refinements: run() throws it within 2 s, no thread is left, and"
                                + " the plan can be rendered again.",
                        (bench, asked, checks) -> listener(checks));
    }

    private static RenderPlan plan(String text) {
        Problems problems = new Problems();
        SceneFile file = SceneReader.read(SceneDocument.parse("scene", text, problems), problems)
                .orElseThrow(() -> new IllegalStateException(problems.toString()));
        return RenderPlan.of(file.scene(), file.settings());
    }

    private static float[] picture(RenderPlan plan, int threads) {
        return new RenderJob(plan, threads, (done, total) -> {}).run().image().samples();
    }

    private static void concurrent(Checks checks) throws InterruptedException {
        for (String map : List.of("caustic-mesh", "photon-map", "none")) {
            RenderPlan shared = plan(FaultScene.with(FaultScene.RAYS, "rays: 2000, samples: 4, map: " + map));
            float[] alone = picture(shared, 1);
            AtomicInteger same = new AtomicInteger();
            Thread[] renders = new Thread[RENDERS];
            for (int i = 0; i < RENDERS; i++) {
                RenderPlan own = i % 2 == 0 ? shared : RenderPlan.of(shared.scene(), shared.settings());
                int threads = 1 + i % 3;
                renders[i] = new Thread(() -> same.addAndGet(Arrays.equals(alone, picture(own, threads)) ? 1 : 0));
                renders[i].start();
            }
            for (Thread render : renders) {
                render.join();
            }
            checks.same("renders with the bits of one alone, map " + map, RENDERS, same.get());
        }
    }

    /** What became of work that was meant to end early. */
    private static final class Ending {
        private final AtomicReference<Throwable> thrown = new AtomicReference<>();
        private volatile boolean interrupted;
        private volatile boolean complete;
        private volatile long ended;
    }

    /** Runs work in a group of threads of its own. */
    private static Thread start(ThreadGroup group, Ending ending, Supplier<Rendering> work) {
        Thread thread = new Thread(group, () -> {
            try {
                ending.complete = work.get().isComplete();
            } catch (RuntimeException | Error failure) {
                ending.thrown.set(failure);
            }
            ending.ended = System.nanoTime();
            ending.interrupted = Thread.currentThread().isInterrupted();
        });
        thread.setDaemon(true);
        thread.start();
        return thread;
    }

    private static void cancel(Checks checks) throws InterruptedException {
        List<RenderPlan> plans = List.of(
                plan(ENDLESS),
                plan(ENDLESS.replace("rays: 2000}", "rays: 2000, map: none}")),
                plan(FaultScene.with(FaultScene.RAYS, "rays: 20000000, map: photon-map")));
        SplittableRandom random = new SplittableRandom(SEED);
        ThreadGroup group = new ThreadGroup("cancelled");
        long slowest = 0;
        int returned = 0;
        int kept = 0;
        int interrupts = 0;
        for (int i = 0; i < CANCELLATIONS; i++) {
            long delay = random.nextLong(LATEST_NANOSECONDS);
            Cancellation fastest = null;
            // A busy machine is no fault of the program: what takes too long is tried again.
            for (int attempt = 0;
                    attempt < 3 && (fastest == null || fastest.nanoseconds > LONGEST_NANOSECONDS);
                    attempt++) {
                Cancellation cancellation = cancelled(group, plans.get(i % plans.size()), i, delay);
                fastest = fastest == null || cancellation.nanoseconds < fastest.nanoseconds ? cancellation : fastest;
            }
            slowest = Math.max(slowest, fastest.nanoseconds);
            returned += fastest.returned ? 1 : 0;
            interrupts += fastest.interrupts ? 1 : 0;
            kept += fastest.kept ? 1 : 0;
        }
        checks.same("cancelled renders that return what there is", CANCELLATIONS, returned);
        checks.atMost(
                "milliseconds from cancel() to the return of run(), the slowest",
                LONGEST_NANOSECONDS * 1e-6,
                slowest * 1e-6);
        checks.same("interrupts that are kept", interrupts, kept);
        checks.same("threads that are left", 0, left(group));
    }

    /**
     * One render that was cancelled.
     *
     * @param nanoseconds to its return
     * @param returned whether it returned what there was
     * @param interrupts whether it was cancelled by interrupt
     * @param kept whether that was kept
     */
    private record Cancellation(long nanoseconds, boolean returned, boolean interrupts, boolean kept) {}

    /** @param number chooses how it is cancelled, and on how many threads it runs */
    private static Cancellation cancelled(ThreadGroup group, RenderPlan plan, int number, long delay)
            throws InterruptedException {
        Ending ending = new Ending();
        int threads = 1 + number % 4;
        boolean hasGoal = number % 5 == 0;
        RenderJob job = new RenderJob(plan, threads, (done, total) -> {});
        Refinement refinement = new Refinement(
                plan, new Goal(OptionalDouble.of(1e-9), OptionalLong.empty()), threads, (done, total) -> {});
        Thread thread = start(group, ending, hasGoal ? () -> refinement.run().rendering() : job::run);
        TimeUnit.NANOSECONDS.sleep(delay);
        long asked = System.nanoTime();
        boolean interrupts = number % 3 == 0;
        if (interrupts) {
            thread.interrupt();
        } else if (hasGoal) {
            refinement.cancel();
        } else {
            job.cancel();
        }
        thread.join(PATIENCE_MILLISECONDS);
        boolean ended = !thread.isAlive();
        return new Cancellation(
                ended ? ending.ended - asked : Long.MAX_VALUE,
                ended && ending.thrown.get() == null && !ending.complete,
                interrupts,
                interrupts && ending.interrupted);
    }

    /** Threads of a group that do not end within two seconds. */
    private static int left(ThreadGroup group) throws InterruptedException {
        for (int i = 0; i < 200 && group.activeCount() > 0; i++) {
            TimeUnit.MILLISECONDS.sleep(10);
        }
        return group.activeCount();
    }

    private static void listener(Checks checks) throws InterruptedException {
        RenderPlan plan = plan(FaultScene.with("size: [20, 16]", "size: [100, 80]"));
        float[] alone = picture(plan, 1);
        ThreadGroup group = new ThreadGroup("listened to");
        for (double part : new double[] {0, 0.1, 0.95, 1}) {
            for (int threads : new int[] {1, 2, 8}) {
                for (Throwable thrown : List.of(new IllegalStateException("meant"), new AssertionError("meant"))) {
                    String what =
                            thrown.getClass().getSimpleName() + " at " + 100 * part + " %, " + threads + " threads";
                    ProgressListener listener = (done, total) -> throwAt(part, done, total, thrown);
                    RenderJob job = new RenderJob(plan, threads, listener);
                    fails(checks, group, what, thrown, job::run);
                }
            }
        }
        IllegalStateException thrown = new IllegalStateException("meant");
        Refinement refinement = new Refinement(
                plan,
                new Goal(OptionalDouble.of(1e-9), OptionalLong.empty()),
                2,
                (done, total) -> throwAt(0.1, done, total, thrown));
        fails(checks, group, "in a refinement", thrown, () -> refinement.run().rendering());
        checks.same("threads that are left", 0, left(group));
        checks.holds("the plan can be rendered again", Arrays.equals(alone, picture(plan, 2)));
    }

    private static void throwAt(double part, int done, int total, Throwable thrown) {
        if (done >= part * total) {
            if (thrown instanceof Error error) {
                throw error;
            }
            throw (RuntimeException) thrown;
        }
    }

    private static void fails(
            Checks checks, ThreadGroup group, String what, Throwable expected, Supplier<Rendering> work)
            throws InterruptedException {
        Ending ending = new Ending();
        Thread thread = start(group, ending, work);
        thread.join(PATIENCE_MILLISECONDS);
        checks.rule(
                what,
                "run() throws it",
                thread.isAlive() ? "no end" : String.valueOf(ending.thrown.get()),
                ending.thrown.get() == expected);
    }
}
