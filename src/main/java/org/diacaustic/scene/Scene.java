package org.diacaustic.scene;

import java.util.ArrayList;
import java.util.List;
import org.diacaustic.light.Light;
import org.diacaustic.material.Material;
import org.diacaustic.math.Color;
import org.diacaustic.shape.Shape;

/**
 * What is to be rendered. Immutable; one scene may be rendered by many threads and jobs at once.
 *
 * @param objects in the order in which the thesis' counters ask them; of two that coincide the first is seen
 * @param background the radiance that arrives from where there is nothing, in W·m⁻²·sr⁻¹
 */
public record Scene(Camera camera, List<Light> lights, List<SceneObject> objects, Color background) {
    public Scene {
        lights = List.copyOf(lights);
        objects = List.copyOf(objects);
        if (!background.isFinite() || background.smallest() < 0) {
            throw new IllegalArgumentException("a background must be finite and not negative, but is " + background);
        }
    }

    public static Builder builder() {
        return new Builder();
    }

    /** Collects the parts of a scene. */
    public static final class Builder {
        private Camera camera;
        private final List<Light> lights = new ArrayList<>();
        private final List<SceneObject> objects = new ArrayList<>();
        private Color background = Color.BLACK;

        private Builder() {}

        public Builder camera(Camera value) {
            camera = value;
            return this;
        }

        public Builder light(Light light) {
            lights.add(light);
            return this;
        }

        public Builder object(String name, Shape shape, Material material) {
            return object(new SceneObject(name, shape, material));
        }

        public Builder object(SceneObject object) {
            objects.add(object);
            return this;
        }

        public Builder background(Color radiance) {
            background = radiance;
            return this;
        }

        /** @throws IllegalStateException if there is no camera */
        public Scene build() {
            if (camera == null) {
                throw new IllegalStateException("a scene needs a camera");
            }
            return new Scene(camera, lights, objects, background);
        }
    }
}
