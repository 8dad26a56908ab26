package org.diacaustic.preprocess;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.diacaustic.map.AmbientChart;
import org.diacaustic.map.Chart;
import org.diacaustic.map.TexelGrid;
import org.diacaustic.parallel.Workers;
import org.diacaustic.scene.SceneIndex;
import org.diacaustic.scene.SceneObject;

/** Lays charts over the objects of a scene: what ambient maps and initial-hit maps need to know of it. */
public final class AmbientCharts {
    private AmbientCharts() {}

    /**
     * Charts with the true area of every texel, of the objects that can show diffuse light. Maps around a point get an even
     * number of columns: one more if it is odd.
     *
     * @throws ForwardPlanException if such an object has no end
     */
    public static List<AmbientChart> of(SceneIndex scene, ChartSizing sizing, Workers workers) {
        List<AmbientChart> charts = new ArrayList<>();
        for (int i = 0; i < scene.size(); i++) {
            SceneObject object = scene.object(i);
            Optional<SurfaceChart> surface = object.material().isDiffuse() ? SurfaceChart.of(object) : Optional.empty();
            if (surface.isPresent()) {
                TexelGrid grid = grid(surface.get().chart(), sizing.of(i));
                double[] areas = surface.get().polygon() != null
                        ? PolygonAreas.of(surface.get().polygon(), grid)
                        : TexelAreas.of(object.shape(), grid, workers);
                if (Arrays.stream(areas).anyMatch(area -> area > 0)) {
                    charts.add(new AmbientChart(i, grid, areas));
                }
            }
        }
        return charts;
    }

    /**
     * The cells of an initial-hit map: for each object of the scene its cells if it is transparent, null if it is not
     * [Thesis 4.4].
     *
     * @throws ForwardPlanException if such an object has no end
     */
    public static List<TexelGrid> initialHits(SceneIndex scene, ChartSizing sizing) {
        List<TexelGrid> grids = new ArrayList<>();
        for (int i = 0; i < scene.size(); i++) {
            Optional<SurfaceChart> surface = scene.isOpaque(i) ? Optional.empty() : SurfaceChart.of(scene.object(i));
            ChartSize size = surface.isPresent() ? sizing.of(i) : null;
            grids.add(surface.map(found -> grid(found.chart(), size)).orElse(null));
        }
        return grids;
    }

    /**
     * Checks that everything that can show diffuse light can have a map.
     *
     * @throws ForwardPlanException if such an object has no end
     */
    static void requireEnds(SceneIndex scene) {
        for (int i = 0; i < scene.size(); i++) {
            if (scene.object(i).material().isDiffuse()) {
                SurfaceChart.of(scene.object(i));
            }
        }
    }

    static TexelGrid grid(Chart chart, ChartSize size) {
        int columns = chart.goesAround() ? size.columns() + size.columns() % 2 : size.columns();
        return new TexelGrid(chart, columns, size.rows());
    }
}
