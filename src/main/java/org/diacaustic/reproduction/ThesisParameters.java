package org.diacaustic.reproduction;

import org.diacaustic.scene.EstimatorName;
import org.diacaustic.scene.ForwardSettings;
import org.diacaustic.scene.MapName;
import org.diacaustic.scene.MapSettings;
import org.diacaustic.scene.Settings;
import org.diacaustic.shader.NonTransparentShader;

/**
 * The numbers behind the thesis' techniques. It gives but few of them; its counts give most: lattices are squares that fit
 * the counts of rays and of hits exactly, and so are the areas that take a single initial hit.
 *
 * @param planarSize points along the side of the planar lattice
 * @param hitColumns areas across a refracting object, each of which lets one primary ray through
 * @param hitRows areas up such an object
 * @param gatherRadius of the volume of interest, in scene units: so large that as many photons of the planar map are used as
 *     the thesis says
 * @param litArea about the area on which photons land, in square scene units
 */
record ThesisParameters(int planarSize, int hitColumns, int hitRows, double gatherRadius, double litArea) {
    /** Texels along the sides of every individual ambient map; chosen for the pictures, as no count tells it. */
    private static final int MAP_SIZE = 100;

    /** The sheet, 5 units wide, as its shadow on the floor: 4 below it, 70 below the light. */
    private static final double SHEET_SHADOW = 25.0 * (70 * 70) / (66 * 66);

    /** The floor of the box. */
    private static final double BOX_FLOOR = 100;

    private static final int CUBE_SIZE = 447;
    private static final int ADAPTIVE_SIZE = 283;
    private static final long RANDOM_RAYS = 1_000_000;
    private static final long BASE_RAYS = 200_000;
    private static final long BATCH_RAYS = 1_000;

    static ThesisParameters of(ThesisScene scene) {
        return scene == ThesisScene.COMPLEX
                ? new ThesisParameters(461, 311, 311, 0.0777, BOX_FLOOR)
                : new ThesisParameters(421, 140, 141, 0.0697, SHEET_SHADOW);
    }

    /** @param thesis the settings of the scene, in thesis mode */
    static Settings settings(Experiment experiment, Settings thesis, long seed) {
        Settings.Builder settings = thesis.toBuilder().seed(seed);
        if (experiment.method().isShadingModel()) {
            return settings.shader(experiment.method().key()).build();
        }
        ThesisParameters parameters = of(experiment.scene());
        return settings.shader(NonTransparentShader.NAME)
                .forward(parameters.forward(experiment.method(), thesis.forward()))
                .maps(parameters.maps(experiment))
                .build();
    }

    private ForwardSettings forward(Method method, ForwardSettings thesis) {
        ForwardSettings.Builder forward = thesis.toBuilder().preProcessor(method.key());
        return switch (method) {
            case RANDOM -> forward.rays(RANDOM_RAYS).build();
            case MONTE_CARLO ->
                forward.baseRays(BASE_RAYS).batchRays(BATCH_RAYS).build();
            case PLANAR -> forward.latticeSize(planarSize).build();
            case CUBE -> forward.latticeSize(CUBE_SIZE).build();
            default -> forward.latticeSize(ADAPTIVE_SIZE).build();
        };
    }

    private MapSettings maps(Experiment experiment) {
        MapSettings.Builder maps = MapSettings.builder()
                .map(MapName.valueOf(experiment.map().name()))
                .estimator(EstimatorName.EXPECTED_COUNT)
                .filterSides(false)
                .interpolateTexels(false);
        return experiment.map() == MapKind.PHOTON_MAP
                ? maps.gatherRadius(gatherRadius)
                        .expectedCount(expectedCount(experiment))
                        .build()
                : maps.mapColumns(MAP_SIZE)
                        .mapRows(MAP_SIZE)
                        .initialHits(1)
                        .initialHitColumns(hitColumns)
                        .initialHitRows(hitRows)
                        .build();
    }

    /** As many as each light would put within the radius if the photons that the thesis stores were spread evenly; at least 1. */
    private double expectedCount(Experiment experiment) {
        double stored = PublishedTables.number(experiment, Quantity.STORED);
        int lights = experiment.scene() == ThesisScene.COMPLEX ? 2 : 1;
        double count = stored / lights * Math.PI * gatherRadius * gatherRadius / litArea;
        return Math.max(1, count);
    }
}
