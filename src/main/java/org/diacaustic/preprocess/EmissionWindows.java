package org.diacaustic.preprocess;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import org.diacaustic.light.Light;
import org.diacaustic.light.LightPoint;
import org.diacaustic.math.Bounds;
import org.diacaustic.math.Vector3;
import org.diacaustic.scene.ForwardSettings;
import org.diacaustic.scene.Scene;
import org.diacaustic.scene.SceneObject;
import org.diacaustic.scene.Settings;

/** Finds where light rays are worth it: the windows of a scene, as a light sees them. */
final class EmissionWindows {
    private final Scene scene;
    private final Settings settings;
    private final boolean joins;

    /** @param joins whether objects share a window where that is no larger than theirs together */
    EmissionWindows(Scene scene, Settings settings, boolean joins) {
        this.scene = scene;
        this.settings = settings;
        this.joins = joins;
    }

    /**
     * The windows of a light: one for each specular object or, if they may be joined, for several where one window around them
     * is no larger than theirs together. One for the whole scene if rays are not to be aimed.
     */
    List<EmissionWindow> of(Light light) {
        if (!settings.forward().aimsAtSpecular()) {
            BitSet all = new BitSet();
            all.set(0, scene.objects().size());
            return List.of(new EmissionWindow(all, finiteBounds(scene)));
        }
        List<EmissionWindow> windows = new ArrayList<>();
        for (int i = 0; i < scene.objects().size(); i++) {
            if (isSpecular(scene.objects().get(i), settings.forward())) {
                BitSet one = new BitSet();
                one.set(i);
                windows.add(
                        new EmissionWindow(one, scene.objects().get(i).shape().bounds()));
            }
        }
        while (joins && joinTwo(windows, light)) {
            // Until no two are better joined.
        }
        return windows;
    }

    /** Whether light goes on from the object that the forward pass follows. */
    static boolean isSpecular(SceneObject object, ForwardSettings settings) {
        return object.material().isTransparent() || (object.material().isReflective() && settings.followsReflections());
    }

    private static boolean joinTwo(List<EmissionWindow> windows, Light light) {
        for (int i = 0; i < windows.size(); i++) {
            for (int j = 0; j < i; j++) {
                EmissionWindow joined = windows.get(i).union(windows.get(j));
                if (size(joined, light) <= size(windows.get(i), light) + size(windows.get(j), light)) {
                    windows.remove(i);
                    windows.set(j, joined);
                    return true;
                }
            }
        }
        return false;
    }

    /** The part of light space that the window takes: a solid angle, or an area across parallel rays. */
    private static double size(EmissionWindow window, Light light) {
        LightPoint middle = new LightPoint();
        light.emitFrom(0.5, 0.5, middle);
        if (light.spread() == Light.Spread.PARALLEL) {
            Vector3 across = new Vector3(middle.normalX, middle.normalY, middle.normalZ);
            return window.bounds().isFinite() ? window.areaAcross(across) : Double.POSITIVE_INFINITY;
        }
        return new View(middle, window).versine;
    }

    /** The box around all objects that have bounds; {@link Bounds#EMPTY} if there are none. */
    static Bounds finiteBounds(Scene scene) {
        return scene.objects().stream()
                .map(object -> object.shape().bounds())
                .filter(Bounds::isFinite)
                .reduce(Bounds.EMPTY, Bounds::union);
    }
}
