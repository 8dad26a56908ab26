package org.diacaustic.trial;

import java.util.List;
import org.diacaustic.map.CausticMesh;
import org.diacaustic.map.IlluminationMap;
import org.diacaustic.parallel.Workers;
import org.diacaustic.preprocess.ForwardPlan;
import org.diacaustic.preprocess.ForwardPlanner;
import org.diacaustic.preprocess.MeshPass;
import org.diacaustic.preprocess.PreProcessors;
import org.diacaustic.scene.EstimatorName;
import org.diacaustic.scene.MapName;
import org.diacaustic.scene.Scene;
import org.diacaustic.scene.SceneIndex;
import org.diacaustic.scene.Settings;
import org.diacaustic.stability.Checks;

/**
 * The irradiance of an upright floor, object 0, by the caustic mesh of a scene, which finds the light rays that land at a point;
 * and photons held against it.
 */
final class ExactLight {
    /** Few: large cells have room for the wide differences that leave rounding behind. */
    private static final long RAYS = 1 << 12;

    private static final long LIGHT_RAYS = 40_000;
    private static final int RINGS = 6;
    private static final int SPOKES = 24;

    private final Scene scene;
    private final Settings settings;
    private final double floor;
    private final IlluminationMap.Lookup lookup;

    private ExactLight(Scene scene, Settings settings, double floor, IlluminationMap.Lookup lookup) {
        this.scene = scene;
        this.settings = settings;
        this.floor = floor;
        this.lookup = lookup;
    }

    /** @param floor its height */
    static ExactLight of(Scene scene, Settings settings, double floor, String preProcessor) {
        Workers workers = new Workers(1);
        ForwardPlan plan = new ForwardPlanner(scene, SceneIndex.of(scene.objects(), false), settings)
                .plan(
                        PreProcessors.byName(List.of()).get(preProcessor),
                        RAYS,
                        MapName.CAUSTIC_MESH,
                        EstimatorName.DENSITY);
        MeshPass pass =
                new MeshPass(plan, 0, workers, part -> {}).keepingSeeds().run();
        CausticMesh mesh = CausticMesh.movedFrom(pass.cells(), workers);
        return new ExactLight(scene, settings, floor, mesh.lookup(pass.lightPaths()));
    }

    /** The irradiance at a point, in W·m⁻². */
    double at(double x, double z) {
        return LightRun.irradiance(lookup, 0, x, floor, z);
    }

    /** The mean over a disc around (x, 0), over rings of equal area. */
    private double mean(double x, double radius) {
        double sum = 0;
        for (int ring = 0; ring < RINGS; ring++) {
            double r = radius * Math.sqrt((ring + 0.5) / RINGS);
            for (int spoke = 0; spoke < SPOKES; spoke++) {
                double angle = 2 * Math.PI * (spoke + 0.5 * (ring % 2)) / SPOKES;
                sum += at(x + r * StrictMath.cos(angle), r * StrictMath.sin(angle));
            }
        }
        return sum / (RINGS * SPOKES);
    }

    /**
     * Holds photons within discs around points (x, 0), in independent runs, against what is expected at the points; by how much
     * the mean over each disc is another, the mesh tells.
     */
    void checkPhotons(Checks checks, String what, double radius, double[] places, double[] expected) {
        double[][] found = new double[places.length][Estimate.RUNS];
        double power = 0;
        for (int run = 0; run < Estimate.RUNS; run++) {
            Settings seeded = OpticalScenes.gathering(settings, radius, Estimate.FIRST_SEED + run);
            LightRun light = LightRun.of(scene, seeded, "random", LIGHT_RAYS);
            // Of three colours.
            power += light.ledger().stored() / 3 / Math.max(1, light.photons().size()) / Estimate.RUNS;
            IlluminationMap.Lookup photons = light.lookup();
            for (int i = 0; i < places.length; i++) {
                found[i][run] = LightRun.irradiance(photons, 0, places[i], floor, 0);
            }
        }
        for (int i = 0; i < places.length; i++) {
            double bias = mean(places[i], radius) - at(places[i], 0);
            double mean = expected[i] + bias;
            double photonsExpected = Estimate.RUNS * mean * Math.PI * radius * radius / power;
            Estimate.of(found[i]).atLeast(mean / Math.sqrt(photonsExpected)).check(checks, what, mean);
        }
    }
}
