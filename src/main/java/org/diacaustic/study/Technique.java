package org.diacaustic.study;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * A way to render, to be compared with others.
 *
 * @param name short, for tables and files
 * @param way how its light gets into the picture
 * @param settings what it lays over those of the scene
 * @param raysAPass light rays of a pass, if there are to be the more passes the more rays there are; 0 if the passes are those
 *     of the settings
 */
public record Technique(String name, Way way, Map<String, String> settings, long raysAPass) {

    /** How light that is traced from the lamps gets into the picture. */
    public enum Way {
        /** As {@code render} does it: over a map that the eye rays ask. */
        OVER_A_MAP,
        /** Photon by photon into the pixel through which it is seen: see {@link LightTracedPicture}. */
        INTO_PIXELS
    }

    public Technique {
        // In the order in which they were given, wherever they are written.
        settings = Collections.unmodifiableMap(new LinkedHashMap<>(settings));
    }

    /** How the light is kept and read: the name of an estimator of photons, or of another map, or {@code light-tracing}. */
    public String family() {
        if (way == Way.INTO_PIXELS) {
            return "light-tracing";
        }
        String map = settings.getOrDefault("map", "auto");
        return map.equals("photon-map") ? settings.getOrDefault("estimator", "nearest") : map;
    }

    /** How light rays are chosen. */
    public String preProcessor() {
        return settings.getOrDefault("preprocessor", "auto");
    }

    /** Whether {@code render} can do it. */
    public boolean isRendered() {
        return way == Way.OVER_A_MAP;
    }

    /**
     * All that is laid over the settings: errors are those of light, so nothing is clamped and no light goes straight; and rays
     * are spread so that they are right on average, which those of the thesis are not.
     */
    public Map<String, String> overrides() {
        Map<String, String> overrides = new LinkedHashMap<>();
        overrides.put("clamp", "false");
        overrides.put("shader", "non-transparent");
        overrides.put("aim-at-specular", "true");
        overrides.put("uniform-directions", "true");
        overrides.put("lattice-shift", "true");
        // As far as the next base ray is: the thesis' own is as wide as the windows.
        overrides.put("batch-spread", "0");
        overrides.putAll(settings);
        return overrides;
    }
}
