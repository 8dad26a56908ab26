package org.diacaustic.reproduction;

import java.util.Locale;
import java.util.Objects;

/** One technique on one scene: a row of the thesis' tables and one of its figures. */
record Experiment(ThesisScene scene, Method method, MapKind map) {

    /** @throws IllegalArgumentException if a shading model is to have a map, or a pre-processor none */
    Experiment {
        Objects.requireNonNull(scene, "scene");
        if (method.isShadingModel() != (map == MapKind.NONE)) {
            throw new IllegalArgumentException(method + " does not go with " + map);
        }
    }

    /** What it is, in words. */
    String title() {
        return method.isShadingModel() ? method.title() : method.title() + ", " + map.title();
    }

    @Override
    public String toString() {
        return scene.key() + ": " + title().toLowerCase(Locale.ROOT);
    }
}
