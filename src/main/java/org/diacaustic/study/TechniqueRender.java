package org.diacaustic.study;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.diacaustic.image.LinearImage;
import org.diacaustic.parallel.Workers;
import org.diacaustic.preprocess.PreProcessor;
import org.diacaustic.preprocess.PreProcessors;
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
            "aim-at-specular", "true",
            "uniform-directions", "true",
            "lattice-shift", "true",
            "passes", "1");

    /** The most rays of a pass, so that its photons take little memory. */
    private static final long RAYS_A_PASS = 1 << 20;

    private final Technique technique;
    private final SceneFile file;
    private final Workers workers;

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
     * @param lightRays light rays followed, with all that became of them
     */
    record Made(LinearImage picture, long lightRays) {}

    /**
     * Renders the picture.
     *
     * @param rays light rays to choose in all passes together, about
     */
    Made render(long rays) {
        if (technique.way() == Technique.Way.OVER_A_MAP) {
            int passes = file.settings().forward().passes();
            Rendering rendering = job(plan(Math.max(1, rays / passes), seed())).run();
            return new Made(rendering.image(), rendering.forward().counters().lightRays());
        }
        LightTracedPicture traced = traced(rays, seed());
        traced.add(0);
        return new Made(sum(direct(), traced.picture()), traced.lightRays());
    }

    /** Light traced to pixels, with so many rays a batch and a seed of its own; no batch was run yet. */
    LightTracedPicture traced(long raysABatch, long seed) {
        int strips = (int) ((raysABatch + RAYS_A_PASS - 1) / RAYS_A_PASS);
        JitteredPreProcessor jittered = new JitteredPreProcessor(strips);
        return new LightTracedPicture(plan(raysABatch / strips, seed, jittered), workers, strips, jittered::turnTo);
    }

    /** What is seen without the light that is refracted or mirrored onto surfaces. */
    LinearImage direct() {
        ForwardSettings forward = file.settings().forward().toBuilder()
                .preProcessor(Settings.NONE)
                .build();
        MapSettings maps = file.settings().maps().toBuilder().map(MapName.NONE).build();
        Settings settings =
                file.settings().toBuilder().forward(forward).maps(maps).build();
        return job(RenderPlan.of(file.scene(), settings)).run().image();
    }

    private RenderPlan plan(long raysAPass, long seed, PreProcessor... own) {
        ForwardSettings forward =
                file.settings().forward().toBuilder().rays(raysAPass).build();
        Settings settings =
                file.settings().toBuilder().forward(forward).seed(seed).build();
        List<PreProcessor> additional = new ArrayList<>(PreProcessors.installed());
        additional.addAll(List.of(own));
        return RenderPlan.of(file.scene(), settings, List.of(), additional);
    }

    private RenderJob job(RenderPlan plan) {
        return new RenderJob(plan, workers.threads(), (done, total) -> {});
    }

    static LinearImage sum(LinearImage a, LinearImage b) {
        LinearImage sum = new LinearImage(a.width(), a.height());
        for (int i = 0; i < sum.samples().length; i++) {
            sum.samples()[i] = a.samples()[i] + b.samples()[i];
        }
        return sum;
    }
}
