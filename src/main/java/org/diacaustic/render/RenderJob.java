package org.diacaustic.render;

import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.BiConsumer;
import org.diacaustic.map.IlluminationMap;
import org.diacaustic.parallel.StopSignal;

/**
 * One render on its way: runs once, on as many threads as wanted, reports progress and can be cancelled from anywhere.
 * The picture is the same to the bit for any number of threads.
 */
public final class RenderJob {
    private final RenderPlan plan;
    private final int threads;
    private final ProgressListener listener;
    private final StopSignal stop = new StopSignal();
    private final AtomicBoolean started = new AtomicBoolean();

    /**
     * @param threads at least 1
     * @param listener hears of every finished part: tiles, and equal parts of forward passes
     * @throws ResourceLimitException if the picture does not fit in memory, or the passes are too many to be counted
     */
    public RenderJob(RenderPlan plan, int threads, ProgressListener listener) {
        PassRun.requireThreads(threads);
        plan.requireMemory(plan.passes() > 1);
        plan.requireCountable(plan.passes());
        this.plan = plan;
        this.threads = threads;
        this.listener = listener;
    }

    /** A job on all cores without a listener. */
    public RenderJob(RenderPlan plan) {
        this(plan, Runtime.getRuntime().availableProcessors(), (done, total) -> {});
    }

    /** Stops the render soon, from any thread; {@link #run()} then returns what there is. */
    public void cancel() {
        stop.set();
    }

    /**
     * Renders, and returns when every thread of the job has ended. An interrupt of the calling thread cancels the job and
     * stays set.
     *
     * @return the picture; not complete if the job was cancelled
     * @throws IllegalStateException if it has run already
     */
    public Rendering run() {
        return run(plan.forward().isPresent(), PassRun::render);
    }

    /** As {@link #run()}, but looks at a map that is there already, in place of forward passes. */
    public Rendering run(IlluminationMap map) {
        Illumination light = new Illumination(map, null);
        return run(false, (passes, progress) -> passes.render(light, progress));
    }

    private Rendering run(boolean hasForward, BiConsumer<PassRun, RenderProgress> render) {
        if (started.getAndSet(true)) {
            throw new IllegalStateException("a job runs once");
        }
        RenderProgress progress = new RenderProgress(plan, plan.passes(), hasForward, listener);
        PassRun passes = new PassRun(plan, threads, stop, plan.passes() > 1);
        for (int pass = 0; pass < plan.passes() && !stop.isSet(); pass++) {
            render.accept(passes, progress);
        }
        return passes.rendering(plan.passes());
    }
}
