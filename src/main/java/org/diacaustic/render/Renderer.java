package org.diacaustic.render;

import org.diacaustic.scene.Scene;
import org.diacaustic.scene.Settings;

/** The main path: a scene becomes a picture. */
public final class Renderer {
    private Renderer() {}

    /**
     * Renders a scene on all cores.
     *
     * @throws PlanException if the settings cannot be rendered
     * @throws ResourceLimitException if the picture does not fit in memory
     */
    public static Rendering render(Scene scene, Settings settings) {
        RenderPlan plan = RenderPlan.of(scene, settings);
        return new RenderJob(plan).run();
    }
}
