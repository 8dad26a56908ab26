package org.diacaustic.render;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.DoubleConsumer;
import java.util.function.IntFunction;
import org.diacaustic.map.CausticMesh;
import org.diacaustic.map.IlluminationMap;
import org.diacaustic.map.PhotonCapacityException;
import org.diacaustic.parallel.StopSignal;
import org.diacaustic.parallel.Workers;
import org.diacaustic.preprocess.ForwardPass;
import org.diacaustic.preprocess.ForwardPlan;
import org.diacaustic.preprocess.ForwardPlanException;
import org.diacaustic.preprocess.ForwardTotals;
import org.diacaustic.preprocess.MapBuilder;
import org.diacaustic.preprocess.MeshPass;
import org.diacaustic.scene.MapName;

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
    private final Object progressLock = new Object();
    private int tilesDone;
    private int partsDone;
    /** How many parts a forward pass has; 0 if none is run. */
    private int forwardParts;

    /**
     * @param threads at least 1
     * @param listener hears of every finished part: tiles, and equal parts of forward passes
     * @throws ResourceLimitException if the picture does not fit in memory, or the passes are too many to be counted
     */
    public RenderJob(RenderPlan plan, int threads, ProgressListener listener) {
        if (threads < 1) {
            throw new IllegalArgumentException("a render needs at least 1 thread, but has " + threads);
        }
        plan.requireMemory();
        if ((long) plan.passes() * plan.tilesAcross() * plan.tilesDown() > Integer.MAX_VALUE) {
            throw new ResourceLimitException(
                    plan.passes() + " passes over a picture of this size are too many to be counted");
        }
        this.plan = plan;
        this.threads = plan.forward().isPresent() ? threads : Math.min(threads, plan.tilesAcross() * plan.tilesDown());
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
        forwardParts = forwardParts();
        Workers workers = new Workers(threads, stop);
        ForwardTotals forward = new ForwardTotals();
        MapBuilder builder = plan.forward()
                .map(forwardPlan -> new MapBuilder(forwardPlan, workers))
                .orElse(null);
        return render(
                workers,
                forward,
                pass -> builder == null
                        ? Illumination.NONE
                        : illuminate(plan.forward().get(), builder, pass, workers, forward));
    }

    /** As {@link #run()}, but looks at a map that is there already, in place of forward passes. */
    public Rendering run(IlluminationMap map) {
        return render(new Workers(threads, stop), new ForwardTotals(), pass -> new Illumination(map, null));
    }

    private Rendering render(Workers workers, ForwardTotals forward, IntFunction<Illumination> lights) {
        if (started.getAndSet(true)) {
            throw new IllegalStateException("a job runs once");
        }
        PassMean picture = new PassMean(
                plan.scene().camera().width(), plan.scene().camera().height(), plan.passes(), plan.estimatesError());
        Counters counters = new Counters();
        double seconds = 0;
        for (int pass = 0; pass < plan.passes() && !stop.isSet(); pass++) {
            Illumination light = lights.apply(pass);
            if (!stop.isSet()) {
                long start = System.nanoTime();
                renderPass(pass, light, picture, workers, counters);
                seconds += seconds(start);
            }
        }
        return new Rendering(
                picture.image(),
                picture.differences(),
                counters,
                forward,
                threads,
                tilesDone,
                plan.passes() * tileCount(),
                seconds);
    }

    /** Runs the forward pass and makes a map of what it brings; nothing if it was stopped. */
    private Illumination illuminate(
            ForwardPlan forwardPlan, MapBuilder builder, int pass, Workers workers, ForwardTotals totals) {
        int before = partsDone;
        DoubleConsumer listening = part -> progress(before + (int) (part * forwardParts));
        try {
            Illumination light = forwardPlan.map() == MapName.CAUSTIC_MESH
                    ? mesh(forwardPlan, pass, workers, totals, listening)
                    : photons(forwardPlan, builder, pass, workers, totals, listening);
            if (!stop.isSet()) {
                progress(before + forwardParts);
            }
            return light;
        } catch (ForwardPlanException refused) {
            throw new PlanException(refused.getMessage());
        } catch (PhotonCapacityException full) {
            throw new ResourceLimitException(full.getMessage() + ": give fewer rays, or Java more memory (-Xmx)");
        }
    }

    private Illumination photons(
            ForwardPlan forwardPlan,
            MapBuilder builder,
            int pass,
            Workers workers,
            ForwardTotals totals,
            DoubleConsumer listening) {
        long start = System.nanoTime();
        ForwardPass forward = new ForwardPass(forwardPlan, pass, workers, listening).run();
        long traced = System.nanoTime();
        IlluminationMap map = stop.isSet() ? null : builder.build(plan.scene().camera(), forward.photons(), pass);
        long bytes = map == null ? 0 : map.bytes();
        totals.add(forward.counters(), forward.ledger(), bytes, seconds(start, traced), seconds(traced));
        return new Illumination(map, null);
    }

    private Illumination mesh(
            ForwardPlan forwardPlan, int pass, Workers workers, ForwardTotals totals, DoubleConsumer listening) {
        long start = System.nanoTime();
        MeshPass forward = new MeshPass(forwardPlan, pass, workers, listening).run();
        long traced = System.nanoTime();
        Illumination light = stop.isSet()
                ? Illumination.NONE
                : new Illumination(
                        CausticMesh.movedFrom(forward.cells(), workers),
                        CausticMesh.movedFrom(forward.largeCells(), workers));
        long bytes =
                light.map() == null ? 0 : light.map().bytes() + light.coarser().bytes();
        totals.add(forward.counters(), forward.ledger(), bytes, seconds(start, traced), seconds(traced));
        return light;
    }

    private static double seconds(long start) {
        return seconds(start, System.nanoTime());
    }

    private static double seconds(long start, long end) {
        return (end - start) * 1e-9;
    }

    private void renderPass(int pass, Illumination light, PassMean picture, Workers workers, Counters counters) {
        List<TileRenderer> renderers = Collections.synchronizedList(new ArrayList<>());
        workers.run(tileCount(), () -> {
            TileRenderer renderer = new TileRenderer(plan, light, pass, picture);
            renderers.add(renderer);
            return number -> render(number, renderer);
        });
        renderers.forEach(renderer -> counters.add(renderer.counters()));
    }

    private void render(int number, TileRenderer renderer) {
        if (renderer.render(scattered(number), stop)) {
            synchronized (progressLock) {
                tilesDone++;
                progress(partsDone + 1);
            }
        }
    }

    /** How many tiles' worth of work a forward pass is, if a light ray is as much as an eye ray. */
    private int forwardParts() {
        long lightRays = plan.forward().map(ForwardPlan::rays).orElse(0L);
        double eyeRays = (double) plan.scene().camera().width()
                * plan.scene().camera().height()
                * plan.settings().samples();
        int most = Math.min(1 << 20, Integer.MAX_VALUE / plan.passes() - tileCount());
        return (int) Math.min(most, Math.rint(tileCount() * (lightRays / eyeRays)));
    }

    /** Tells the listener of every part up to this number. */
    private void progress(int done) {
        int total = plan.passes() * (tileCount() + forwardParts);
        synchronized (progressLock) {
            while (partsDone < done) {
                partsDone++;
                listener.progressed(partsDone, total);
            }
        }
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
}
