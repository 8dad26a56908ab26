package org.diacaustic.study;

import java.io.IOException;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.diacaustic.image.Exposure;
import org.diacaustic.image.LinearImage;
import org.diacaustic.parallel.StopSignal;
import org.diacaustic.parallel.Workers;
import org.diacaustic.render.PlanException;
import org.diacaustic.render.ProgressListener;
import org.diacaustic.scene.Scene;
import org.diacaustic.scenefile.SceneFile;

/**
 * Renders one scene with several techniques, budgets and seeds, and holds every picture against a reference. Points that a folder
 * keeps are taken from there, and new ones put there. Runs once, and can be cancelled from any thread.
 */
public final class Study {
    /** The thesis' shading models, which need no forward pass. */
    private static final List<String> SHADERS = List.of("non-transparent", "non-refractive");

    /** Pictures of each technique before the first that counts, and seconds; the first limit that is met ends it. */
    private static final int WARMING_PICTURES = 10;

    private static final double WARMING_SECONDS = 0.5;

    private final StudyRequest request;
    private final StudyFolder folder;
    private final SceneSource source;
    private final Scene scene;
    private final long seed;
    private final Reference reference;
    private final DiffusePixels pixels;
    private final ErrorMeter meter;
    private final Exposure exposure;
    private final StopSignal stop = new StopSignal();
    private final Map<Technique, Contestant> contestants = new LinkedHashMap<>();
    private DirectLightNoise directLight;
    private volatile TechniqueRender running;

    /**
     * @throws IOException if the scene cannot be read
     * @throws IllegalArgumentException if the reference is not of the picture's size
     */
    public Study(SceneSource source, StudyRequest request, Reference reference, StudyFolder folder) throws IOException {
        SceneFile file = source.read(Map.of());
        this.request = request;
        this.folder = folder;
        this.scene = file.scene();
        this.seed = file.settings().seed();
        // All techniques share one scene: it may be large.
        this.source = overrides -> new SceneFile(scene, source.read(overrides).settings());
        this.reference = reference;
        this.pixels = DiffusePixels.of(scene);
        Technique none = new Technique("direct light", Technique.Way.OVER_A_MAP, Map.of(), 0);
        this.meter = new ErrorMeter(
                reference, new TechniqueRender(this.source, none, new Workers(request.threads())).direct(), pixels);
        this.exposure = Exposure.auto(reference.picture());
    }

    /**
     * Finds out whether there is anything to compare, before time is spent on a reference.
     *
     * @throws IOException if the scene cannot be read
     * @throws IllegalArgumentException if there is not
     */
    public static void requireComparable(SceneSource source) throws IOException {
        if (DiffusePixels.of(source.read(Map.of()).scene()).count() == 0) {
            throw new IllegalArgumentException(
                    "no pixel shows one diffuse object and nothing else, so none can be compared");
        }
        Technique random = new Technique(
                "random",
                Technique.Way.OVER_A_MAP,
                Map.of("preprocessor", "random", "map", "photon-map", "estimator", "nearest"),
                0);
        TechniqueRender render = new TechniqueRender(source, random, new Workers(1));
        if (render.plan(1, 1, render.seed()).forward().isEmpty()) {
            throw new IllegalArgumentException(
                    "no light reaches anything after being refracted or mirrored, so there is nothing to compare");
        }
    }

    /** A technique, and how far it came. */
    private static final class Contestant {
        final TechniqueRender render;
        final List<StudyPoint> points = new ArrayList<>();
        String refusal = "";

        Contestant(TechniqueRender render) {
            this.render = render;
        }
    }

    /** Stops the study soon, from any thread; {@link #run} then returns what there is. */
    public void cancel() {
        stop.set();
        TechniqueRender render = running;
        if (render != null) {
            render.cancel();
        }
    }

    /**
     * Runs the study. Apart from times, and from what follows from budgets of time, its results depend on the scene's seed only.
     *
     * @param listener hears which part is done
     * @throws IOException if the scene cannot be read, or the folder cannot be written
     */
    public StudyReport run(ProgressListener listener) throws IOException {
        directLight = new DirectLightNoise(source, reference, seed, workers());
        GatherRadius radius = new GatherRadius(source, request, workers());
        for (Technique technique : request.techniques()) {
            Technique given = radius.givenTo(technique);
            contestants.put(given, enter(given));
        }
        warm();
        Progress progress = new Progress(listener);
        for (Budget budget : request.budgets()) {
            for (Map.Entry<Technique, Contestant> entry : contestants.entrySet()) {
                Optional<StudyPoint> kept = folder.point(entry.getKey(), budget);
                if (kept.isPresent()) {
                    entry.getValue().points.add(kept.get());
                } else if (isRunning(entry.getValue())) {
                    make(entry.getKey(), entry.getValue(), budget);
                    progress.advance(budget, entry.getValue());
                }
            }
        }
        return report(radius.value());
    }

    private Workers workers() {
        return new Workers(request.threads(), stop);
    }

    private Contestant enter(Technique technique) throws IOException {
        Contestant contestant = new Contestant(new TechniqueRender(source, technique, workers()));
        try {
            contestant.render.plan(1, 1, seed);
        } catch (PlanException refused) {
            contestant.refusal = refused.getMessage();
        }
        return contestant;
    }

    private void make(Technique technique, Contestant contestant, Budget budget) throws IOException {
        running = contestant.render;
        try {
            long rays = rays(budget, contestant);
            List<StudyRun> runs = new ArrayList<>();
            ErrorMeter.Spread spread = meter.spread();
            LinearImage first = null;
            int seeds = request.seedsFor(contestant.render.cost(rays));
            for (int i = 0; i < seeds && !stop.isSet(); i++) {
                TechniqueRender.Made made = contestant.render.render(rays, seed + i);
                first = first == null ? made.picture() : first;
                LinearImage compared = directLight.exchange(made.picture(), contestant.render, seed + i);
                spread.add(compared);
                runs.add(new StudyRun(seed + i, measures(made, compared)));
            }
            if (!stop.isSet()) {
                StudyPoint point = new StudyPoint(
                        budget,
                        rays,
                        contestant.render.passes(rays),
                        spread.squaredBias(),
                        spread.variance(),
                        meter.noise(),
                        runs);
                folder.keep(technique, point, first, exposure);
                contestant.points.add(point);
            }
        } catch (PlanException refused) {
            contestant.refusal = refused.getMessage();
        } finally {
            running = null;
        }
    }

    private Map<Measure, Double> measures(TechniqueRender.Made made, LinearImage compared) {
        Map<Measure, Double> measures = new EnumMap<>(made.costs());
        measures.putAll(meter.measure(compared));
        return measures;
    }

    /** Lets the virtual machine learn from all techniques that have something to do, before any of them is timed. */
    private void warm() throws IOException {
        for (Map.Entry<Technique, Contestant> entry : contestants.entrySet()) {
            for (Budget budget : request.budgets()) {
                if (folder.point(entry.getKey(), budget).isEmpty()) {
                    warm(entry.getValue());
                    break;
                }
            }
        }
    }

    private void warm(Contestant contestant) {
        running = contestant.render;
        long rays = request.budgets().get(0) instanceof Budget.Rays given ? given.count() : RaysForTime.FIRST_TRIAL;
        Clock clock = new Clock();
        try {
            for (int i = 0;
                    i < WARMING_PICTURES && clock.wallSeconds() < WARMING_SECONDS && isRunning(contestant);
                    i++) {
                contestant.render.render(rays, seed);
            }
        } catch (PlanException refused) {
            contestant.refusal = refused.getMessage();
        } finally {
            running = null;
        }
    }

    private boolean isRunning(Contestant contestant) {
        return contestant.refusal.isEmpty() && !stop.isSet();
    }

    private long rays(Budget budget, Contestant contestant) {
        return budget instanceof Budget.Rays given
                ? given.count()
                : RaysForTime.of(((Budget.Seconds) budget).count(), contestant.render, seed, stop);
    }

    private StudyReport report(double gatherRadius) throws IOException {
        List<TechniqueStudy> studies = new ArrayList<>();
        int planned = 0;
        for (Map.Entry<Technique, Contestant> entry : contestants.entrySet()) {
            Contestant contestant = entry.getValue();
            studies.add(new TechniqueStudy(entry.getKey(), contestant.points, contestant.refusal));
            planned += contestant.refusal.isEmpty() ? request.budgets().size() : contestant.points.size();
        }
        return new StudyReport(
                request.scene(),
                request.command(),
                request.machine(),
                request.threads(),
                seed,
                reference,
                pixels.picture(),
                gatherRadius,
                studies,
                shading(),
                Optional.empty(),
                planned);
    }

    /** What the shading models show alone. */
    private List<ShadingStudy> shading() throws IOException {
        List<ShadingStudy> studies = new ArrayList<>();
        for (String shader : SHADERS) {
            if (stop.isSet()) {
                break;
            }
            Technique alone = new Technique(
                    shader,
                    Technique.Way.OVER_A_MAP,
                    Map.of("shader", shader, "preprocessor", "none", "map", "none"),
                    0);
            TechniqueRender render = new TechniqueRender(source, alone, workers());
            render.render(1, seed);
            TechniqueRender.Made made = render.render(1, seed);
            studies.add(new ShadingStudy(shader, new StudyRun(seed, measures(made, made.picture()))));
        }
        return studies;
    }

    /** Tells a listener how much of the work is done, weighed by what pictures cost. */
    private final class Progress {
        private static final int PARTS = 10_000;

        /** What a second is worth, in rays. */
        private static final double RAYS_A_SECOND = 1e6;

        private final ProgressListener listener;
        private final double total;
        private double done;

        Progress(ProgressListener listener) throws IOException {
            double sum = 0;
            for (Map.Entry<Technique, Contestant> entry : contestants.entrySet()) {
                for (Budget budget : request.budgets()) {
                    boolean isToDo = entry.getValue().refusal.isEmpty()
                            && folder.point(entry.getKey(), budget).isEmpty();
                    sum += isToDo ? weight(budget, entry.getValue()) : 0;
                }
            }
            this.listener = listener;
            this.total = sum;
        }

        private double weight(Budget budget, Contestant contestant) {
            double cost = budget instanceof Budget.Rays given
                    ? contestant.render.cost(given.count())
                    : RAYS_A_SECOND * ((Budget.Seconds) budget).count();
            return cost * request.seedsFor(cost);
        }

        void advance(Budget budget, Contestant contestant) {
            done += weight(budget, contestant);
            listener.progressed((int) Math.min(PARTS, Math.rint(PARTS * done / total)), PARTS);
        }
    }
}
