package org.diacaustic.trial;

import java.util.List;
import org.diacaustic.scene.EstimatorName;
import org.diacaustic.scene.ForwardSettings;
import org.diacaustic.scene.MapName;
import org.diacaustic.scene.MapSettings;
import org.diacaustic.scene.Settings;

/** A way to trace light forward and to keep it: how light rays are chosen, what keeps them, how that is read. */
record Way(String preProcessor, MapName map, EstimatorName estimator) {
    static final Way NONE = new Way(Settings.NONE, MapName.NONE, EstimatorName.AUTO);

    static final Way MESH = new Way("own-map", MapName.CAUSTIC_MESH, EstimatorName.AUTO);

    static final List<Way> ALL = List.of(
            MESH,
            new Way("random", MapName.PHOTON_MAP, EstimatorName.DENSITY),
            new Way("monte-carlo", MapName.PHOTON_MAP, EstimatorName.NEAREST),
            new Way("adaptive", MapName.CAUSTIC_MESH, EstimatorName.AUTO),
            new Way("own-map", MapName.AMBIENT_MAPS, EstimatorName.AUTO),
            new Way("cube", MapName.PHOTON_MAP, EstimatorName.DENSITY));

    /** One after the other. */
    static Way of(long number) {
        return ALL.get((int) Math.floorMod(number, (long) ALL.size()));
    }

    /** Whether it has a map on each object, so that none may be endless. */
    boolean needsEnds() {
        return map == MapName.AMBIENT_MAPS;
    }

    Settings settings(long rays, long seed) {
        return Settings.physical().toBuilder()
                .seed(seed)
                .forward(ForwardSettings.builder()
                        .preProcessor(preProcessor)
                        .rays(rays)
                        .build())
                .maps(MapSettings.builder().map(map).estimator(estimator).build())
                .build();
    }

    @Override
    public String toString() {
        return preProcessor + " " + map.label() + (estimator == EstimatorName.AUTO ? "" : " " + estimator.label());
    }
}
