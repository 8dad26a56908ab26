package org.diacaustic.scene;

import java.util.Objects;
import org.diacaustic.material.Material;
import org.diacaustic.shape.Shape;

/**
 * A thing in the scene: a shape made of a material, under a name that messages and plans use.
 */
public record SceneObject(String name, Shape shape, Material material) {
    public SceneObject {
        Objects.requireNonNull(name, "name");
        Objects.requireNonNull(shape, "shape");
        Objects.requireNonNull(material, "material");
    }

    /** Whether the object stops all light. */
    public boolean isOpaque() {
        return !material.isTransparent();
    }
}
