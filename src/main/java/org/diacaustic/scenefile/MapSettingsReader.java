package org.diacaustic.scenefile;

import java.util.Map;
import org.diacaustic.map.Kernel;
import org.diacaustic.scene.EstimatorName;
import org.diacaustic.scene.MapName;
import org.diacaustic.scene.MapSettings;

/** Reads the keys of {@code settings} that say how the light of the forward pass is kept and read. */
final class MapSettingsReader {
    private static final Map<String, Boolean> FILTERS = new Kinds<Boolean>()
            .with("two-sided-normal", true)
            .with("none", false)
            .map();

    /** Texels along the side of a blur; a wider one would be better served by larger texels. */
    private static final int WIDEST_BLUR = 255;

    private MapSettingsReader() {}

    /** @param start what holds where nothing is said */
    static MapSettings read(MappingReader in, MapSettings start) {
        MapSettings.Builder maps = start.toBuilder();
        in.choice("map", MapName.class).optional().ifPresent(maps::map);
        in.choice("estimator", EstimatorName.class).optional().ifPresent(maps::estimator);
        in.choice("filter", FILTERS).optional().ifPresent(maps::filterSides);
        in.choice("kernel", Kernel.class).optional().ifPresent(maps::kernel);
        in.number("gather-radius").atLeast(1e-150).atMost(1e150).optional().ifPresent(maps::gatherRadius);
        in.integer("gather-count").atLeast(2).optional().ifPresent(maps::gatherCount);
        in.number("expected-count").above(0).optional().ifPresent(maps::expectedCount);
        in.integer("map-columns").atLeast(1).optional().ifPresent(maps::mapColumns);
        in.integer("map-rows").atLeast(1).optional().ifPresent(maps::mapRows);
        in.integer("map-blur").atLeast(1).atMost(WIDEST_BLUR).optional().ifPresent(maps::mapBlur);
        in.flag("map-interpolation").optional().ifPresent(maps::interpolateTexels);
        in.integer("initial-hits").atLeast(0).optional().ifPresent(maps::initialHits);
        in.integer("initial-hit-columns").atLeast(1).optional().ifPresent(maps::initialHitColumns);
        in.integer("initial-hit-rows").atLeast(1).optional().ifPresent(maps::initialHitRows);
        return maps.build();
    }
}
