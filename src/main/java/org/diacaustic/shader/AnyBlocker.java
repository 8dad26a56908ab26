package org.diacaustic.shader;

import org.diacaustic.math.Ray;
import org.diacaustic.scene.SceneIndex;

/** Stops at the first object found on a shadow ray, transparent or not. */
final class AnyBlocker implements SceneIndex.Visitor {
    private final ShadowRay shadow;

    AnyBlocker(ShadowRay shadow) {
        this.shadow = shadow;
    }

    @Override
    public boolean stopsAt(int object, Ray ray) {
        if (!shadow.scene.object(object).shape().occludes(ray)) {
            return false;
        }
        shadow.remember(object);
        return true;
    }
}
