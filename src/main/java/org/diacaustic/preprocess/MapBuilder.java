package org.diacaustic.preprocess;

import java.util.List;
import org.diacaustic.map.AmbientCalibration;
import org.diacaustic.map.AmbientChart;
import org.diacaustic.map.AmbientMaps;
import org.diacaustic.map.AmbientOptions;
import org.diacaustic.map.IlluminationMap;
import org.diacaustic.parallel.Workers;
import org.diacaustic.scene.Camera;
import org.diacaustic.scene.EstimatorName;
import org.diacaustic.scene.MapName;
import org.diacaustic.scene.MapSettings;

/** Makes a map of what a forward pass brought. */
public final class MapBuilder {
    private MapBuilder() {}

    /**
     * @param camera that will look at the map
     * @param number of the pass, from 0
     */
    public static IlluminationMap build(
            Camera camera, ForwardPlan plan, ForwardPass pass, int number, Workers workers) {
        return plan.map() == MapName.AMBIENT_MAPS ? ambientMaps(camera, plan, pass, workers) : null;
    }

    private static IlluminationMap ambientMaps(Camera camera, ForwardPlan plan, ForwardPass pass, Workers workers) {
        MapSettings settings = plan.maps();
        ChartSizing sizing = ChartSizing.equal(
                settings.mapColumns() > 0 ? settings.mapColumns() : 140,
                settings.mapRows() > 0 ? settings.mapRows() : 140);
        List<AmbientChart> charts = AmbientCharts.of(plan.index(), sizing, workers);
        boolean counts = plan.estimator() == EstimatorName.EXPECTED_COUNT;
        AmbientOptions options = new AmbientOptions(
                counts ? AmbientCalibration.EXPECTED_COUNT : AmbientCalibration.DENSITY,
                counts && settings.expectedCount() > 0 ? settings.expectedCount() : Double.NaN,
                settings.mapBlur(),
                settings.filtersSides(),
                settings.interpolatesTexels());
        return AmbientMaps.of(pass.photons(), charts, options, workers);
    }
}
