package org.diacaustic.study;

import java.util.LinkedHashMap;
import java.util.Map;

/**
 * A way to render, to be compared with others.
 *
 * @param name short, for tables and files
 * @param way how its light gets into the picture
 * @param settings what it lays over those of the scene
 */
public record Technique(String name, Way way, Map<String, String> settings) {

    /** How light that is traced from the lamps gets into the picture. */
    public enum Way {
        /** As {@code render} does it: over a map that the eye rays ask. */
        OVER_A_MAP,
        /** Photon by photon into the pixel through which it is seen: see {@link LightTracedPicture}. */
        INTO_PIXELS
    }

    public Technique {
        settings = Map.copyOf(settings);
    }

    /** All that is laid over the settings: errors are those of light, so nothing is clamped and no light goes straight. */
    Map<String, String> overrides() {
        Map<String, String> overrides = new LinkedHashMap<>();
        overrides.put("clamp", "false");
        overrides.put("shader", "non-transparent");
        overrides.putAll(settings);
        return overrides;
    }
}
