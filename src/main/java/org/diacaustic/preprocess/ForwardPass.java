package org.diacaustic.preprocess;

import java.util.Arrays;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.DoubleConsumer;
import org.diacaustic.light.Light;
import org.diacaustic.map.InitialHits;
import org.diacaustic.map.PhotonSlice;
import org.diacaustic.map.PhotonStore;
import org.diacaustic.math.SampleStream;
import org.diacaustic.parallel.Workers;

/**
 * One forward pass on its way: has the pre-processor choose rays beam after beam, and follows them on all cores. What it
 * stores, and in which order, does not depend on the number of threads.
 */
public final class ForwardPass {
    private static final int RAYS_A_TASK = 4096;
    private static final int LAST_STAGE = Integer.MAX_VALUE;
    private static final int TASKS_A_ROUND = 1024;

    private final ForwardPlan plan;
    private final int pass;
    private final Workers workers;
    private final PhotonStore store;
    private final EnergyLedger ledger = new EnergyLedger();
    private final ForwardCounters counters = new ForwardCounters();
    private final DoubleConsumer progress;
    private final long raysPlanned;
    private final AtomicLong raysDone = new AtomicLong();
    private InitialHits initialHits;
    private Beam beam;
    private final AtomicInteger stage = new AtomicInteger();

    /**
     * @param pass the number of the pass: passes are independent of each other
     * @param workers who do the work; if they are stopped, what was done by then is there
     * @param progress hears about which part of the pass is done, 0 to 1, from several threads
     */
    public ForwardPass(ForwardPlan plan, int pass, Workers workers, DoubleConsumer progress) {
        this.progress = progress;
        this.raysPlanned = plan.rays();
        this.plan = plan;
        this.pass = pass;
        this.workers = plan.isSequential() ? new Workers(1, workers.stop()) : workers;
        this.store = new PhotonStore(plan.origin(), plan.lengthUnit(), plan.powerUnit(), plan.capacity());
    }

    /** A pass that reports to nobody. */
    public ForwardPass(ForwardPlan plan, int pass, Workers workers) {
        this(plan, pass, workers, part -> {});
    }

    /** Runs the pass, once. */
    public ForwardPass run() {
        Light light = null;
        for (Beam next : plan.beams()) {
            beam = next;
            stage.set(0);
            if (plan.isSequential() && beam.light() != light) {
                light = beam.light();
                initialHits = initialHits();
            }
            plan.preProcessor().run(beam, this);
        }
        counters.nonFinite += store.rejectedCount();
        return this;
    }

    private InitialHits initialHits() {
        ChartSizing sizing =
                ChartSizing.equal(plan.maps().initialHitColumns(), plan.maps().initialHitRows());
        return new InitialHits(
                AmbientCharts.initialHits(plan.index(), sizing), plan.maps().initialHits());
    }

    /**
     * Runs a stage of a pre-processor: rays 0 to {@code rays} − 1, in any order. The photons are stored in the order of the
     * rays.
     *
     * @throws ForwardPlanException if the rays are more than can be numbered
     */
    public void shootRays(long rays, RaySource source) {
        int tasks = tasks(rays, RAYS_A_TASK);
        shootTasks(tasks, (task, emitter) -> {
            long end = Math.min(rays, (task + 1L) * RAYS_A_TASK);
            for (long ray = (long) task * RAYS_A_TASK;
                    ray < end && !workers.stop().isSet();
                    ray++) {
                source.shoot(ray, emitter);
            }
        });
    }

    /**
     * The tasks that so many rays are cut into.
     *
     * @throws ForwardPlanException if they are more than can be numbered
     */
    static int tasks(long rays, int raysATask) {
        long tasks = (rays + raysATask - 1) / raysATask;
        if (tasks > Integer.MAX_VALUE) {
            throw new ForwardPlanException(rays + " light rays at once are more than can be numbered; give fewer");
        }
        return (int) tasks;
    }

    /**
     * Runs a stage of a pre-processor whose tasks are cut by the pre-processor itself. A task may be run twice, with the same
     * random numbers: what it writes, apart from what it stores, is to be the same then.
     */
    public void shootTasks(int tasks, Body body) {
        long streams = streams(stage.getAndIncrement());
        if (raysPlanned > plan.capacity() && !plan.isSequential()) {
            requireRoom(tasks, streams, body);
        }
        for (int first = 0; first < tasks && !workers.stop().isSet(); first += TASKS_A_ROUND) {
            shootRound(first, Math.min(TASKS_A_ROUND, tasks - first), streams, body);
        }
    }

    private void requireRoom(int tasks, long streams, Body body) {
        PhotonStore tried = new PhotonStore(plan.origin(), plan.lengthUnit(), plan.powerUnit(), plan.capacity());
        StoreForecast.requireRoom("photons", plan.capacity(), store.size(), tasks, workers, () -> {
            LightTracer tracer = new LightTracer(plan, workers.stop(), initialHits);
            LightEmitter emitter = new LightEmitter(tracer, beam, streams);
            return task -> {
                ForwardCounters counts = new ForwardCounters();
                tracer.startTask(tried.slice(), new EnergyLedger(), counts);
                body.run(task, emitter);
                return counts.stored();
            };
        });
    }

    /** Runs some of a stage's tasks, and puts together what they brought, so that it is not kept apart for long. */
    private void shootRound(int first, int tasks, long streams, Body body) {
        PhotonSlice[] slices = new PhotonSlice[tasks];
        EnergyLedger[] ledgers = new EnergyLedger[tasks];
        ForwardCounters[] counts = new ForwardCounters[tasks];
        workers.run(tasks, () -> {
            LightTracer tracer = new LightTracer(plan, workers.stop(), initialHits);
            LightEmitter emitter = new LightEmitter(tracer, beam, streams);
            return task -> {
                slices[task] = store.slice();
                ledgers[task] = new EnergyLedger();
                counts[task] = new ForwardCounters();
                tracer.startTask(slices[task], ledgers[task], counts[task]);
                body.run(first + task, emitter);
                long done = raysDone.addAndGet(counts[task].primaryRays);
                progress.accept(Math.min(1, (double) done / raysPlanned));
            };
        });
        Arrays.stream(slices).filter(slice -> slice != null).forEach(store::append);
        Arrays.stream(ledgers).filter(part -> part != null).forEach(ledger::add);
        Arrays.stream(counts).filter(part -> part != null).forEach(counters::add);
    }

    /** Random numbers that belong to the beam as a whole. */
    public SampleStream random() {
        SampleStream random = new SampleStream();
        random.start(plan.seed(), streams(LAST_STAGE), 0);
        return random;
    }

    private long streams(int ofStage) {
        // Far apart for any numbers of passes, beams and stages.
        return (((pass + 1L) * 0x9E3779B97F4A7C15L + beam.number()) * 0xD1B54A32D192ED03L) + ofStage;
    }

    /** Whether rays carry flux; otherwise each carries as much as any other. */
    public boolean isWeighted() {
        return plan.isWeighted();
    }

    /** The photons. */
    public PhotonStore photons() {
        return store;
    }

    public EnergyLedger ledger() {
        return ledger;
    }

    public ForwardCounters counters() {
        return counters;
    }

    /** Chooses the ray of a number, and sends it. */
    @FunctionalInterface
    public interface RaySource {
        void shoot(long ray, LightEmitter emitter);
    }

    /** Chooses and sends the rays of a task. */
    @FunctionalInterface
    public interface Body {
        void run(int task, LightEmitter emitter);
    }
}
