package org.diacaustic.study;

import java.io.IOException;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import org.diacaustic.image.LinearImage;
import org.diacaustic.parallel.Workers;
import org.diacaustic.preprocess.ForwardTotals;
import org.diacaustic.preprocess.PreProcessor;
import org.diacaustic.preprocess.PreProcessors;
import org.diacaustic.render.PlanException;
import org.diacaustic.render.RenderJob;
import org.diacaustic.render.RenderPlan;
import org.diacaustic.render.Rendering;
import org.diacaustic.scene.ForwardSettings;
import org.diacaustic.scene.MapName;
import org.diacaustic.scene.MapSettings;
import org.diacaustic.scene.Settings;
import org.diacaustic.scenefile.SceneFile;

/** A scene and a technique, read once, to be rendered with any number of light rays. */
final class TechniqueRender {
    /** What light traced to pixels needs, whatever the scene says: rays that carry their flux, equally likely everywhere. */
    private static final Map<String, String> UNBIASED = Map.of(
            "map", "photon-map",
            "estimator", "nearest",
            "light-weights", "solid-angle",
            "initial-hits", "0",
            "passes", "1");

    /** The most rays of a pass, so that its photons take little memory. */
    private static final long RAYS_A_PASS = 1 << 20;

    /** For so long pictures without a map are rendered, but so many at least; the fastest counts. */
    private static final double SECONDS_WITHOUT_MAP = 0.1;

    private static final int PICTURES_WITHOUT_MAP = 3;

    private final Technique technique;
    private final SceneFile file;
    private final Workers workers;
    private volatile RenderJob running;
    private double secondsWithoutMap = Double.NaN;

    /** @throws IOException if the scene cannot be read */
    TechniqueRender(SceneSource source, Technique technique, Workers workers) throws IOException {
        this.technique = technique;
        this.workers = workers;
        Map<String, String> overrides = technique.overrides();
        if (technique.way() == Technique.Way.INTO_PIXELS) {
            overrides.putAll(UNBIASED);
        }
        this.file = source.read(overrides);
    }

    long seed() {
        return file.settings().seed();
    }

    /**
     * A picture, and what it took.
     *
     * @param passes whose pictures were averaged
     * @param costs all measures that are not errors
     */
    record Made(LinearImage picture, int passes, Map<Measure, Double> costs) {}

    /**
     * Renders the picture. If the workers were stopped meanwhile, it is not whole.
     *
     * @param rays light rays to choose in all passes together, about
     * @throws PlanException if the technique cannot render the scene
     */
    Made render(long rays, long seed) {
        Clock clock = new Clock();
        Map<Measure, Double> costs = new EnumMap<>(Measure.class);
        boolean isOverMap = technique.way() == Technique.Way.OVER_A_MAP;
        LinearImage picture = isOverMap ? overMap(rays, seed, costs) : intoPixels(rays, seed, costs);
        costs.put(Measure.WORK, costs.get(Measure.INTERSECTION_TESTS) + costs.get(Measure.NODES_EXAMINED));
        costs.put(Measure.WALL_SECONDS, clock.wallSeconds());
        costs.put(Measure.PROCESSOR_SECONDS, clock.processorSeconds());
        return new Made(picture, isOverMap ? passes(rays) : 1, costs);
    }

    /** How many passes a picture of so many light rays has. */
    int passes(long rays) {
        if (technique.raysAPass() == 0) {
            return file.settings().forward().passes();
        }
        return (int) Math.max(1, Math.min(Integer.MAX_VALUE, rays / technique.raysAPass()));
    }

    /** Light rays and eye rays of a picture together: about what it costs. */
    double cost(long rays) {
        return rays + pixels() * file.settings().samples() * passes(rays);
    }

    private LinearImage overMap(long rays, long seed, Map<Measure, Double> costs) {
        int passes = passes(rays);
        Rendering rendering = run(plan(Math.max(1, rays / passes), passes, seed));
        ForwardTotals forward = rendering.forward();
        double eyeSeconds = Math.min(rendering.seconds(), passes * secondsWithoutMap());
        costs.put(Measure.LIGHT_RAYS, (double) forward.counters().lightRays());
        costs.put(
                Measure.INTERSECTION_TESTS,
                (double) forward.counters().intersectionTests()
                        + rendering.counters().intersectionTests());
        costs.put(Measure.NODES_EXAMINED, (double) rendering.counters().nodesExamined());
        costs.put(
                Measure.STORED,
                (double) forward.counters().stored() + forward.counters().cells());
        costs.put(Measure.MAP_BYTES, (double) forward.mapBytes());
        costs.put(Measure.FORWARD_SECONDS, forward.traceSeconds());
        costs.put(Measure.BUILD_SECONDS, forward.buildSeconds());
        costs.put(Measure.EYE_SECONDS, eyeSeconds);
        costs.put(Measure.GATHER_SECONDS, rendering.seconds() - eyeSeconds);
        return rendering.image();
    }

    private LinearImage intoPixels(long rays, long seed, Map<Measure, Double> costs) {
        Clock clock = new Clock();
        LightTracedPicture traced = traced(rays, seed);
        traced.add(0);
        double tracedSeconds = clock.wallSeconds();
        Rendering direct = runWithoutMap(seed);
        costs.put(Measure.LIGHT_RAYS, (double) traced.lightRays());
        costs.put(
                Measure.INTERSECTION_TESTS,
                (double) traced.tests() + direct.counters().intersectionTests());
        costs.put(Measure.NODES_EXAMINED, 0.0);
        costs.put(Measure.STORED, (double) traced.photonsSeen());
        costs.put(Measure.MAP_BYTES, 0.0);
        costs.put(Measure.FORWARD_SECONDS, traced.traceSeconds());
        costs.put(Measure.BUILD_SECONDS, 0.0);
        costs.put(Measure.GATHER_SECONDS, tracedSeconds - traced.traceSeconds());
        costs.put(Measure.EYE_SECONDS, direct.seconds());
        return sum(direct.image(), traced.picture());
    }

    /** Light traced to pixels, with so many rays a batch and a seed of its own; no batch was run yet. */
    LightTracedPicture traced(long raysABatch, long seed) {
        int strips = (int) ((raysABatch + RAYS_A_PASS - 1) / RAYS_A_PASS);
        JitteredPreProcessor jittered = new JitteredPreProcessor(strips);
        return new LightTracedPicture(plan(raysABatch / strips, 1, seed, jittered), workers, strips, jittered::turnTo);
    }

    /** Whether straight shadow rays tell the light exactly: see {@link RenderPlan#isStraight}. */
    boolean isStraight() {
        return planWithoutMap(seed()).isStraight();
    }

    /** Pixels of the picture. */
    double pixels() {
        return (double) file.scene().camera().width() * file.scene().camera().height();
    }

    /** What is seen without the light that is refracted or mirrored onto surfaces. */
    LinearImage direct() {
        return directWith(seed());
    }

    /** The same with another seed. */
    LinearImage directWith(long seed) {
        return runWithoutMap(seed).image();
    }

    /** What an eye pass takes that asks no map, at its fastest. */
    private double secondsWithoutMap() {
        if (Double.isNaN(secondsWithoutMap)) {
            secondsWithoutMap = Double.POSITIVE_INFINITY;
            Clock clock = new Clock();
            for (int i = 0; i < PICTURES_WITHOUT_MAP || clock.wallSeconds() < SECONDS_WITHOUT_MAP; i++) {
                secondsWithoutMap =
                        Math.min(secondsWithoutMap, runWithoutMap(seed()).seconds());
            }
        }
        return secondsWithoutMap;
    }

    private Rendering runWithoutMap(long seed) {
        return run(planWithoutMap(seed));
    }

    private RenderPlan planWithoutMap(long seed) {
        ForwardSettings forward = file.settings().forward().toBuilder()
                .preProcessor(Settings.NONE)
                .build();
        MapSettings maps = file.settings().maps().toBuilder().map(MapName.NONE).build();
        return RenderPlan.of(
                file.scene(),
                file.settings().toBuilder()
                        .forward(forward)
                        .maps(maps)
                        .seed(seed)
                        .build());
    }

    /**
     * The plan of a picture.
     *
     * @throws PlanException if the technique cannot render the scene
     */
    RenderPlan plan(long raysAPass, int passes, long seed, PreProcessor... own) {
        ForwardSettings forward = file.settings().forward().toBuilder()
                .rays(raysAPass)
                .passes(passes)
                .build();
        Settings settings =
                file.settings().toBuilder().forward(forward).seed(seed).build();
        List<PreProcessor> additional = new ArrayList<>(PreProcessors.installed());
        additional.addAll(List.of(own));
        return RenderPlan.of(file.scene(), settings, List.of(), additional);
    }

    private Rendering run(RenderPlan plan) {
        RenderJob job = new RenderJob(plan, workers.threads(), (done, total) -> {});
        running = job;
        if (workers.stop().isSet()) {
            job.cancel();
        }
        return job.run();
    }

    /** Ends what is being rendered soon, from any thread. */
    void cancel() {
        workers.stop().set();
        RenderJob job = running;
        if (job != null) {
            job.cancel();
        }
    }

    static LinearImage sum(LinearImage a, LinearImage b) {
        LinearImage sum = new LinearImage(a.width(), a.height());
        for (int i = 0; i < sum.samples().length; i++) {
            sum.samples()[i] = a.samples()[i] + b.samples()[i];
        }
        return sum;
    }
}
