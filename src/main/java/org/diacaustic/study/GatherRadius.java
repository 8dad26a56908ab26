package org.diacaustic.study;

import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.diacaustic.parallel.Workers;
import org.diacaustic.preprocess.ForwardPass;
import org.diacaustic.preprocess.ForwardPlan;
import org.diacaustic.preprocess.ForwardPlanException;
import org.diacaustic.preprocess.MapBuilder;
import org.diacaustic.render.PlanException;
import org.diacaustic.render.RenderPlan;

/**
 * One radius for all techniques that look for photons within a fixed reach, whatever their budget: else it would follow from
 * the photons, and be neither fixed nor the same. It is that which follows from random light rays of the middle budget, unless
 * the scene or the technique has one of its own.
 */
final class GatherRadius {
    private static final List<String> FAMILIES = List.of("density", "progressive", "expected-count");

    private static final Technique MEASURED = new Technique(
            "radius",
            Technique.Way.OVER_A_MAP,
            Map.of("preprocessor", "random", "map", "photon-map", "estimator", "density"),
            0);

    /** Rays by which it is found if budgets are times. */
    private static final long RAYS = 30_000;

    private final SceneSource source;
    private final StudyRequest request;
    private final Workers workers;
    private double value;

    GatherRadius(SceneSource source, StudyRequest request, Workers workers) {
        this.source = source;
        this.request = request;
        this.workers = workers;
    }

    /** The technique, with the radius if it needs one. */
    Technique givenTo(Technique technique) throws IOException {
        if (!FAMILIES.contains(technique.family()) || technique.settings().containsKey("gather-radius")) {
            return technique;
        }
        if (value == 0) {
            value = find();
        }
        if (value == 0) {
            return technique;
        }
        Map<String, String> settings = new LinkedHashMap<>(technique.settings());
        settings.put("gather-radius", Double.toString(value));
        return new Technique(technique.name(), technique.way(), settings, technique.raysAPass());
    }

    /** The radius; 0 if no technique needs one. */
    double value() {
        return value;
    }

    private double find() throws IOException {
        double own = source.read(Map.of()).settings().maps().gatherRadius();
        if (own > 0) {
            return own;
        }
        try {
            TechniqueRender render = new TechniqueRender(source, MEASURED, workers);
            Budget middle = request.budgets().get(request.budgets().size() / 2);
            long rays = middle instanceof Budget.Rays given ? given.count() : RAYS;
            RenderPlan plan = render.plan(rays, 1, render.seed());
            if (plan.forward().isEmpty()) {
                return 0;
            }
            ForwardPlan forward = plan.forward().get();
            MapBuilder builder = new MapBuilder(forward, workers);
            builder.build(
                    plan.scene().camera(),
                    new ForwardPass(forward, 0, workers).run().photons(),
                    0);
            return builder.gatherRadius();
        } catch (PlanException | ForwardPlanException refused) {
            // Then no technique that needs it can render the scene, and each says so itself.
            return 0;
        }
    }
}
