package org.diacaustic.render;

import java.util.List;
import java.util.function.DoubleConsumer;
import org.diacaustic.image.LinearImage;
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
 * Passes over one picture: each follows light forward, makes a map of it, and looks at that through every pixel. The picture is
 * the mean of all passes so far. Used by one thread, which has others work for it.
 */
final class PassRun {
    private final RenderPlan plan;
    private final Workers workers;
    private final Tiles tiles;
    private final PassMean picture;
    private final Counters counters = new Counters();
    private final ForwardTotals forward = new ForwardTotals();
    /** Null if it is not kept. */
    private final OtherLight otherLight;

    /** Null if no photons are kept. */
    private final MapBuilder builder;

    private int begun;
    private int tilesDone;
    private double seconds;

    /**
     * @param threads at least 1
     * @param stop ends the run soon
     * @param isMean whether there may be more than one pass
     */
    PassRun(RenderPlan plan, int threads, StopSignal stop, boolean isMean) {
        this(plan, threads, stop, isMean, null);
    }

    /** A run of one pass that keeps what no map brings, or does not look at it if it is there. */
    PassRun(RenderPlan plan, int threads, StopSignal stop, OtherLight otherLight) {
        this(plan, threads, stop, false, otherLight);
    }

    private PassRun(RenderPlan plan, int threads, StopSignal stop, boolean isMean, OtherLight otherLight) {
        this.otherLight = otherLight;
        this.plan = plan;
        this.workers = new Workers(plan.forward().isPresent() ? threads : Math.min(threads, plan.tileCount()), stop);
        this.tiles = new Tiles(plan);
        this.picture = new PassMean(
                plan.scene().camera().width(), plan.scene().camera().height(), isMean, plan.estimatesError());
        this.builder = plan.forward()
                .map(forwardPlan -> new MapBuilder(forwardPlan, workers))
                .orElse(null);
    }

    /** @throws IllegalArgumentException if there is not even one */
    static void requireThreads(int threads) {
        if (threads < 1) {
            throw new IllegalArgumentException("a render needs at least 1 thread, but has " + threads);
        }
    }

    /**
     * Renders the next pass, unless the run has been stopped.
     *
     * @throws ResourceLimitException if what the forward pass brings is more than there is room for
     */
    void render(RenderProgress progress) {
        render(plan.forward().isPresent() ? illuminate(plan.forward().get(), progress) : Illumination.NONE, progress);
    }

    /** As {@link #render(RenderProgress)}, but looks at a map that is there already. */
    void render(Illumination light, RenderProgress progress) {
        int pass = begun++;
        if (workers.stop().isSet()) {
            return;
        }
        long start = System.nanoTime();
        List<TileRenderer> renderers =
                tiles.render(() -> new TileRenderer(plan, light, pass, picture, otherLight), workers, progress);
        for (TileRenderer renderer : renderers) {
            counters.add(renderer.counters());
            tilesDone += renderer.tilesDone();
        }
        seconds += seconds(start, System.nanoTime());
    }

    /**
     * What has been made. What it counts grows with further passes.
     *
     * @param passes that were wanted
     * @param image of the run; it changes with further passes, so whoever goes on needs a copy
     */
    private Rendering rendering(int passes, LinearImage image) {
        boolean wholePasses = tilesDone == begun * plan.tileCount();
        return new Rendering(
                image,
                picture.differences(),
                wholePasses ? picture.noise(begun) : Double.NaN,
                counters,
                forward,
                workers.threads(),
                tilesDone,
                passes * plan.tileCount(),
                seconds);
    }

    /** What has been made of so many passes, if there are to be no more. */
    Rendering rendering(int passes) {
        return rendering(passes, picture.image());
    }

    /** What has been made of so many passes, apart from what further ones will change in the picture. */
    Rendering renderingSoFar(int passes) {
        return rendering(passes, picture.copy());
    }

    /** Runs the forward pass and makes a map of what it brings; nothing if it was stopped. */
    private Illumination illuminate(ForwardPlan forwardPlan, RenderProgress progress) {
        DoubleConsumer listening = progress.forwardPass();
        try {
            Illumination light = forwardPlan.map() == MapName.CAUSTIC_MESH
                    ? mesh(forwardPlan, listening)
                    : photons(forwardPlan, listening);
            if (!workers.stop().isSet()) {
                listening.accept(1);
            }
            return light;
        } catch (ForwardPlanException refused) {
            throw new PlanException(refused.getMessage());
        } catch (PhotonCapacityException full) {
            throw new ResourceLimitException(full.getMessage() + ": give fewer rays, or Java more memory (-Xmx)");
        }
    }

    private Illumination photons(ForwardPlan forwardPlan, DoubleConsumer listening) {
        long start = System.nanoTime();
        ForwardPass pass = new ForwardPass(forwardPlan, begun, workers, listening).run();
        long traced = System.nanoTime();
        IlluminationMap map =
                workers.stop().isSet() ? null : builder.build(plan.scene().camera(), pass.photons(), begun);
        forward.noteGatherRadius(builder.gatherRadius());
        long bytes = map == null ? 0 : map.bytes();
        forward.add(pass.counters(), pass.ledger(), bytes, seconds(start, traced), seconds(traced, System.nanoTime()));
        return new Illumination(map, null);
    }

    private Illumination mesh(ForwardPlan forwardPlan, DoubleConsumer listening) {
        long start = System.nanoTime();
        MeshPass pass = new MeshPass(forwardPlan, begun, workers, listening).run();
        long traced = System.nanoTime();
        Illumination light = workers.stop().isSet()
                ? Illumination.NONE
                : new Illumination(
                        CausticMesh.movedFrom(pass.cells(), workers),
                        CausticMesh.movedFrom(pass.largeCells(), workers));
        long bytes =
                light.map() == null ? 0 : light.map().bytes() + light.coarser().bytes();
        forward.add(pass.counters(), pass.ledger(), bytes, seconds(start, traced), seconds(traced, System.nanoTime()));
        return light;
    }

    private static double seconds(long start, long end) {
        return (end - start) * 1e-9;
    }
}
