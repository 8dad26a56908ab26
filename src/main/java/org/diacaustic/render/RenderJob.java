package org.diacaustic.render;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import org.diacaustic.image.LinearImage;

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
    private final AtomicInteger nextTile = new AtomicInteger();
    private final AtomicReference<Throwable> failure = new AtomicReference<>();
    private final Object progressLock = new Object();
    private int tilesDone;

    /**
     * @param threads at least 1
     * @param listener hears of every finished tile
     * @throws ResourceLimitException if the picture does not fit in memory
     */
    public RenderJob(RenderPlan plan, int threads, ProgressListener listener) {
        if (threads < 1) {
            throw new IllegalArgumentException("a render needs at least 1 thread, but has " + threads);
        }
        plan.requireMemory();
        this.plan = plan;
        this.threads = Math.min(threads, plan.tilesAcross() * plan.tilesDown());
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
        if (started.getAndSet(true)) {
            throw new IllegalStateException("a job runs once");
        }
        long start = System.nanoTime();
        LinearImage image = new LinearImage(
                plan.scene().camera().width(), plan.scene().camera().height());
        List<TileRenderer> renderers = new ArrayList<>();
        List<Thread> workers = new ArrayList<>();
        for (int i = 0; i < threads; i++) {
            TileRenderer renderer = new TileRenderer(plan, image);
            renderers.add(renderer);
            Thread worker = new Thread(() -> work(renderer), "diacaustic-" + i);
            worker.setDaemon(true);
            workers.add(worker);
        }
        workers.forEach(Thread::start);
        join(workers);
        rethrowFailure();
        Counters counters = new Counters();
        renderers.forEach(renderer -> counters.add(renderer.counters()));
        double seconds = (System.nanoTime() - start) * 1e-9;
        return new Rendering(image, counters, threads, tilesDone, tileCount(), seconds);
    }

    private int tileCount() {
        return plan.tilesAcross() * plan.tilesDown();
    }

    /** Tiles in an order that jumps over the picture, so that the time left can be told from those that are done. */
    private int scattered(int number) {
        int stride = (int) (tileCount() * 0.618) | 1;
        while (gcd(stride, tileCount()) != 1) {
            stride += 2;
        }
        return (int) ((long) number * stride % tileCount());
    }

    private static int gcd(int a, int b) {
        return b == 0 ? a : gcd(b, a % b);
    }

    private void work(TileRenderer renderer) {
        try {
            for (int tile = nextTile.getAndIncrement(); tile < tileCount(); tile = nextTile.getAndIncrement()) {
                if (!renderer.render(scattered(tile), stop)) {
                    return;
                }
                synchronized (progressLock) {
                    tilesDone++;
                    listener.progressed(tilesDone, tileCount());
                }
            }
        } catch (RuntimeException | Error thrown) {
            failure.compareAndSet(null, thrown);
            stop.set();
        }
    }

    /** Waits for all workers, through interrupts, which cancel the job. */
    private void join(List<Thread> workers) {
        boolean interrupted = false;
        for (Thread worker : workers) {
            while (worker.isAlive()) {
                try {
                    worker.join();
                } catch (InterruptedException wanted) {
                    interrupted = true;
                    stop.set();
                }
            }
        }
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
    }

    private void rethrowFailure() {
        Throwable thrown = failure.get();
        if (thrown instanceof Error error) {
            throw error;
        }
        if (thrown != null) {
            throw (RuntimeException) thrown;
        }
    }
}
