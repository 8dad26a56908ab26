package org.diacaustic.render;

import java.util.List;
import java.util.stream.Stream;
import org.diacaustic.material.Material;
import org.diacaustic.material.Medium;
import org.diacaustic.scene.Scene;
import org.diacaustic.scene.SceneObject;

/** What a scene has and has not: the facts that the plan decides by. */
final class SceneTraits {
    private final Scene scene;

    SceneTraits(Scene scene) {
        this.scene = scene;
    }

    boolean hasTransparency() {
        return materials().anyMatch(Material::isTransparent);
    }

    /** Names of the transparent objects whose inside and outside differ in index: what bends light. */
    List<String> refracting() {
        return scene.objects().stream()
                .filter(object -> object.material().isTransparent() && bends(object))
                .map(SceneObject::name)
                .toList();
    }

    /** Names of the objects that mirror by their own reflectivity. */
    List<String> mirroring() {
        return scene.objects().stream()
                .filter(object -> object.material().isReflective())
                .map(SceneObject::name)
                .toList();
    }

    boolean hasAbsorption() {
        return materials()
                .filter(Material::isTransparent)
                .anyMatch(material ->
                        material.inside().absorbs() || material.outside().absorbs());
    }

    boolean needsMaps() {
        return materials().anyMatch(Material::needsMap);
    }

    boolean hasBumps() {
        return materials().anyMatch(Material::isBumped);
    }

    boolean hasHighlights() {
        return scene.lights().stream().anyMatch(light -> light.highlightExponent() > 0);
    }

    private static boolean bends(SceneObject object) {
        double around = object.shape().isClosed()
                ? Medium.VACUUM.indexOfRefraction()
                : object.material().outside().indexOfRefraction();
        return object.material().inside().indexOfRefraction() != around;
    }

    private Stream<Material> materials() {
        return scene.objects().stream().map(SceneObject::material);
    }
}
