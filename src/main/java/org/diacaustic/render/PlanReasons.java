package org.diacaustic.render;

import java.util.ArrayList;
import java.util.List;
import org.diacaustic.material.Medium;
import org.diacaustic.scene.Scene;
import org.diacaustic.scene.SceneIndex;
import org.diacaustic.scene.Settings;
import org.diacaustic.shader.NonRefractiveShader;
import org.diacaustic.shader.NonTransparentShader;

/** Looks at a scene and says what it needs, what it does not, and why. */
final class PlanReasons {
    private final Scene scene;
    private final Settings settings;
    private final SceneIndex index;
    private final SceneTraits traits;
    private final boolean hasForwardPass;

    PlanReasons(Scene scene, Settings settings, SceneIndex index, SceneTraits traits, boolean hasForwardPass) {
        this.scene = scene;
        this.settings = settings;
        this.index = index;
        this.traits = traits;
        this.hasForwardPass = hasForwardPass;
    }

    /** The shading model that is right, or least wrong, for the scene. */
    String bestShader() {
        return traits.hasTransparency() && !hasForwardPass ? NonRefractiveShader.NAME : NonTransparentShader.NAME;
    }

    List<Decision> decisions(String shader, Medium atEye) {
        List<Decision> list = new ArrayList<>();
        list.add(shader(shader));
        list.add(filterWalk(shader));
        list.add(tree());
        list.add(mediumAtEye(atEye));
        list.add(lens());
        list.add(optional(
                "map coordinates",
                traits.needsMaps(),
                "inverse mapping of hits",
                "a texture or bump is laid on a map",
                "no texture or bump is laid on a map"));
        list.add(optional(
                "bump maps", traits.hasBumps(), "tilted normals", "a material is bumped", "no material is bumped"));
        list.add(optional(
                "absorption",
                traits.hasAbsorption(),
                "attenuation along rays",
                "a medium absorbs",
                "no medium absorbs"));
        list.add(optional(
                "highlights",
                traits.hasHighlights() && reflects(),
                "specular term",
                "a light has a highlight exponent and something reflects",
                "no light has a highlight exponent, or nothing reflects"));
        list.add(supersampling());
        return List.copyOf(list);
    }

    private Decision filterWalk(String shader) {
        boolean used = traits.hasTransparency() && !shader.equals(NonTransparentShader.NAME);
        return optional(
                "filter walk",
                used,
                "shadow rays through transparent objects",
                "the scene has transparent objects",
                traits.hasTransparency() ? "the shading model stops at any object" : "nothing is transparent");
    }

    private static Decision mediumAtEye(Medium medium) {
        boolean vacuum = medium.equals(Medium.VACUUM);
        return optional(
                "medium at the eye",
                !vacuum,
                vacuum ? "a medium to start in" : "index of refraction " + medium.indexOfRefraction(),
                "transparent objects say so",
                "the eye is in empty space");
    }

    private boolean reflects() {
        return !traits.mirroring().isEmpty()
                || (settings.scatterRules().fresnel() && !traits.refracting().isEmpty());
    }

    private Decision shader(String name) {
        if (!settings.shader().equals(Settings.AUTO)) {
            return new Decision("shader", true, name, "asked for");
        }
        if (!traits.hasTransparency()) {
            return new Decision("shader", true, name, "nothing is transparent, so nothing passes a blocker");
        }
        if (hasForwardPass) {
            return new Decision("shader", true, name, "the map brings what comes through glass");
        }
        List<String> bending = traits.refracting();
        if (bending.isEmpty()) {
            return new Decision(
                    "shader",
                    true,
                    name,
                    "no transparent object bends light, so straight shadow rays are exact for what passes through");
        }
        return new Decision(
                "shader",
                true,
                name,
                "approximate: light through " + String.join(", ", bending) + " is taken to go straight");
    }

    private Decision tree() {
        if (index.hasTree()) {
            return new Decision(
                    "top-level tree",
                    true,
                    "hierarchy of boxes",
                    scene.objects().size() + " objects");
        }
        String reason = settings.usesListOrder()
                ? "counters are to mean what the thesis' do"
                : scene.objects().size() + " objects are few, or unbounded";
        return new Decision("top-level tree", false, "objects are asked one by one", reason);
    }

    private Decision lens() {
        boolean lens = scene.camera().lensRadius() > 0;
        return lens
                ? new Decision("lens", true, "depth of field", "the lens has a radius")
                : new Decision("lens", false, "lens samples", "the lens radius is 0");
    }

    private Decision supersampling() {
        int samples = settings.samples();
        return samples > 1
                ? new Decision("supersampling", true, samples + " rays a pixel", "asked for")
                : new Decision("supersampling", false, "one ray through the middle of each pixel", "samples is 1");
    }

    private static Decision optional(String part, boolean used, String choice, String why, String whyNot) {
        return new Decision(part, used, choice, used ? why : whyNot);
    }
}
