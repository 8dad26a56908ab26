package org.diacaustic.render;

import java.util.List;
import java.util.stream.Stream;
import org.diacaustic.material.Material;
import org.diacaustic.material.Medium;
import org.diacaustic.scene.ForwardSettings;
import org.diacaustic.scene.Scene;
import org.diacaustic.scene.SceneObject;

/** What a scene has and has not: the facts that the plan decides by. */
final class SceneTraits {
    /** The part of a pixel by which light may miss its place unseen. */
    private static final double UNSEEN = 0.01;

    /** The tangent of incidence that all but a thousandth of a silhouette keeps below. */
    private static final double STEEPEST = 32;

    /** How many times farther from where it is bent light may land than the eye is from there. */
    private static final double LEVER = 10;

    private final Scene scene;

    SceneTraits(Scene scene) {
        this.scene = scene;
    }

    boolean hasTransparency() {
        return materials().anyMatch(Material::isTransparent);
    }

    /** Whether anything shows light that lands on it. */
    boolean isDiffuse() {
        return materials().anyMatch(Material::isDiffuse);
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

    /** Whether lamps light surfaces along straight lines only: nothing bends light, and none is mirrored onto surfaces. */
    boolean isStraight(ForwardSettings forward) {
        return refracting().isEmpty()
                && (!forward.followsReflections() || mirroring().isEmpty());
    }

    /**
     * Whether lamps light surfaces as good as straight: a step of the index turns light by the step · the tangent of incidence,
     * and where that is done twice it lands by less than {@link #UNSEEN} of a pixel from where it would have.
     */
    boolean looksStraight(ForwardSettings forward) {
        double largest = Math.sqrt(scene.camera().pixelArea()) * UNSEEN / (2 * STEEPEST * LEVER);
        return scene.objects().stream()
                        .filter(object -> object.material().isTransparent())
                        .allMatch(object -> indexStep(object) <= largest)
                && (!forward.followsReflections() || mirroring().isEmpty());
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

    private boolean bends(SceneObject object) {
        return indexStep(object) > 0;
    }

    /** The largest difference of the object's index and one that may meet it. */
    private double indexStep(SceneObject object) {
        double own = object.material().inside().indexOfRefraction();
        if (!object.shape().isClosed()) {
            return Math.abs(object.material().outside().indexOfRefraction() - own);
        }
        return Stream.concat(
                        Stream.of(Medium.VACUUM),
                        scene.objects().stream()
                                .filter(other -> other.material().isTransparent())
                                .flatMap(other -> mediaAround(other, object)))
                .mapToDouble(medium -> Math.abs(medium.indexOfRefraction() - own))
                .max()
                .orElse(0);
    }

    /** The media of one object that another may lie in: those of open surfaces anywhere, of closed ones that overlap. */
    private static Stream<Medium> mediaAround(SceneObject surrounding, SceneObject object) {
        Material material = surrounding.material();
        if (!surrounding.shape().isClosed()) {
            return Stream.of(material.inside(), material.outside());
        }
        return surrounding.shape().bounds().overlaps(object.shape().bounds())
                ? Stream.of(material.inside())
                : Stream.empty();
    }

    private Stream<Material> materials() {
        return scene.objects().stream().map(SceneObject::material);
    }
}
