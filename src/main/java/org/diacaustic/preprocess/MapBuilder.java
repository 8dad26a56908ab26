package org.diacaustic.preprocess;

import java.util.List;
import org.diacaustic.map.AmbientCalibration;
import org.diacaustic.map.AmbientChart;
import org.diacaustic.map.AmbientMaps;
import org.diacaustic.map.AmbientOptions;
import org.diacaustic.map.Estimator;
import org.diacaustic.map.GatherStatistics;
import org.diacaustic.map.IlluminationMap;
import org.diacaustic.map.Kernel;
import org.diacaustic.map.PhotonFilter;
import org.diacaustic.map.PhotonMap;
import org.diacaustic.map.PhotonStore;
import org.diacaustic.map.PhotonTree;
import org.diacaustic.parallel.Workers;
import org.diacaustic.scene.Camera;
import org.diacaustic.scene.EstimatorName;
import org.diacaustic.scene.MapName;
import org.diacaustic.scene.MapSettings;

/** Makes a map of the photons of a forward pass. What settings leave open it finds from the photons and the camera. */
public final class MapBuilder {
    /** The memory that ambient maps may take, in bytes: a number of its own, so that pictures do not depend on the machine. */
    private static final long AMBIENT_MAP_BYTES = 1 << 28;

    /** Photons that are asked about their neighbours. */
    private static final int SAMPLES = 1024;

    /** How many times farther than is usual among the photons the nearest ones are looked for. */
    private static final double FARTHEST = 4;

    /** The reach where photons do not say, as a part of the extent of the scene. */
    private static final double LEAST_REACH = 0x1p-6;

    private final ForwardPlan plan;
    private final MapSettings settings;
    private final Workers workers;
    private double firstRadius;
    private boolean isRadiusChecked;
    /** Of the first pass, for all; null before. */
    private List<AmbientChart> charts;

    /** @param plan of the passes whose photons are to be kept */
    public MapBuilder(ForwardPlan plan, Workers workers) {
        this.plan = plan;
        this.settings = plan.maps();
        this.workers = workers;
        this.firstRadius = settings.gatherRadius();
    }

    /**
     * Makes the map of one pass. The store may be empty afterwards.
     *
     * @param camera that will look at the map
     * @param pass its number, from 0; the passes of a render are built by one builder, in order
     * @return null if the workers were stopped
     */
    public IlluminationMap build(Camera camera, PhotonStore photons, int pass) {
        return plan.map() == MapName.AMBIENT_MAPS ? ambientMaps(camera, photons) : photonMap(photons, pass);
    }

    /**
     * How far photons are looked for: as given, or as the first pass' photons say, which it is too if densities are asked for and
     * half of those have no other within what is given; 0 if there was no pass yet, or none of photons.
     */
    public double gatherRadius() {
        return firstRadius;
    }

    private IlluminationMap ambientMaps(Camera camera, PhotonStore photons) {
        if (charts == null) {
            charts = AmbientCharts.of(plan.index(), sizing(camera, photons), workers);
        }
        if (workers.stop().isSet()) {
            return null;
        }
        boolean counts = plan.estimator() == EstimatorName.EXPECTED_COUNT;
        AmbientOptions options = new AmbientOptions(
                counts ? AmbientCalibration.EXPECTED_COUNT : AmbientCalibration.DENSITY,
                counts && settings.expectedCount() > 0 ? settings.expectedCount() : Double.NaN,
                settings.mapBlur(),
                settings.filtersSides(),
                settings.interpolatesTexels());
        return AmbientMaps.of(photons, charts, options, workers);
    }

    /** As given; what is not, as the camera needs it. */
    private ChartSizing sizing(Camera camera, PhotonStore photons) {
        int columns = settings.mapColumns();
        int rows = settings.mapRows();
        if (columns > 0 && rows > 0) {
            return ChartSizing.equal(columns, rows);
        }
        ChartSizing needed = CameraSizing.of(plan.index(), camera, photons.size(), AMBIENT_MAP_BYTES);
        return object -> {
            ChartSize size = needed.of(object);
            return new ChartSize(columns > 0 ? columns : size.columns(), rows > 0 ? rows : size.rows());
        };
    }

    private IlluminationMap photonMap(PhotonStore photons, int pass) {
        PhotonFilter filter = settings.filtersSides() ? PhotonFilter.TWO_SIDED_NORMAL : PhotonFilter.NONE;
        PhotonTree tree = PhotonTree.movedFrom(photons, workers);
        if (workers.stop().isSet()) {
            return null;
        }
        return PhotonMap.over(tree, estimator(tree, filter, pass), filter);
    }

    private Estimator estimator(PhotonTree tree, PhotonFilter filter, int pass) {
        Kernel kernel = settings.kernel();
        double radius = radius(tree, filter);
        return switch (plan.estimator()) {
            case EXPECTED_COUNT -> new Estimator.ExpectedCount(radius, expectedCount(tree, filter, radius));
            case DENSITY -> new Estimator.Density(radius, kernel);
            case PROGRESSIVE -> new Estimator.Density(Estimator.progressiveRadius(radius, pass + 1), kernel);
            default ->
                new Estimator.Nearest(
                        settings.gatherCount(), radius == settings.gatherRadius() ? radius : FARTHEST * radius, kernel);
        };
    }

    /** What is given, or the reach within which half of the first pass' photons have as many others as are to be gathered. */
    private double radius(PhotonTree tree, PhotonFilter filter) {
        boolean isArea = plan.estimator() != EstimatorName.EXPECTED_COUNT;
        if (!isRadiusChecked && isArea && firstRadius > 0 && tree.size() > 1) {
            // Discs that hold no two photons show specks, and no light.
            firstRadius =
                    GatherStatistics.medianNeighbourDistance(tree, 1, filter, SAMPLES) > firstRadius ? 0 : firstRadius;
        }
        isRadiusChecked = true;
        if (firstRadius == 0 && tree.size() > 1) {
            int count = Math.min(settings.gatherCount(), tree.size() - 1);
            double median = GatherStatistics.medianNeighbourDistance(tree, count, filter, SAMPLES);
            firstRadius = median < Double.POSITIVE_INFINITY ? median : 0;
        }
        // Photons that are few, or all in one place, do not say how far light is spread.
        return firstRadius > 0 ? firstRadius : plan.extent() * LEAST_REACH;
    }

    private double expectedCount(PhotonTree tree, PhotonFilter filter, double radius) {
        if (settings.expectedCount() > 0) {
            return settings.expectedCount();
        }
        double mean = GatherStatistics.expectedCount(tree, radius, filter, SAMPLES);
        return mean > 0 ? mean : 1;
    }
}
