package org.diacaustic.trial;

import java.util.List;
import org.diacaustic.map.IlluminationMap;
import org.diacaustic.map.PhotonStore;
import org.diacaustic.map.SurfacePoint;
import org.diacaustic.math.Rgb;
import org.diacaustic.parallel.Workers;
import org.diacaustic.preprocess.EnergyLedger;
import org.diacaustic.preprocess.ForwardPass;
import org.diacaustic.preprocess.ForwardPlan;
import org.diacaustic.preprocess.ForwardPlanner;
import org.diacaustic.preprocess.MapBuilder;
import org.diacaustic.preprocess.PreProcessors;
import org.diacaustic.scene.EstimatorName;
import org.diacaustic.scene.MapName;
import org.diacaustic.scene.Scene;
import org.diacaustic.scene.SceneIndex;
import org.diacaustic.scene.Settings;

/** One forward pass over a scene, as a render makes it, with photons: its ledger, and the map of what it stored. */
final class LightRun {
    private final Scene scene;
    private final ForwardPlan plan;
    private final ForwardPass pass;
    private final Workers workers = new Workers(1);

    private LightRun(Scene scene, ForwardPlan plan) {
        this.scene = scene;
        this.plan = plan;
        this.pass = new ForwardPass(plan, 0, workers).run();
    }

    /**
     * Sends light rays.
     *
     * @param settings with the seed, and the radius, kernel and estimator of lookups
     * @param preProcessor by name
     */
    static LightRun of(Scene scene, Settings settings, String preProcessor, long rays) {
        return new LightRun(scene, plan(scene, settings, preProcessor, rays));
    }

    /** What {@link #of} does, before it is done. */
    static ForwardPlan plan(Scene scene, Settings settings, String preProcessor, long rays) {
        SceneIndex index = SceneIndex.of(scene.objects(), settings.usesListOrder());
        EstimatorName estimator = settings.maps().estimator() == EstimatorName.AUTO
                ? EstimatorName.DENSITY
                : settings.maps().estimator();
        return new ForwardPlanner(scene, index, settings)
                .plan(PreProcessors.byName(List.of()).get(preProcessor), rays, MapName.PHOTON_MAP, estimator);
    }

    EnergyLedger ledger() {
        return pass.ledger();
    }

    /** What landed; must be looked at before {@link #lookup}, which takes it over. */
    PhotonStore photons() {
        return pass.photons();
    }

    /** A reader of the photon map. */
    IlluminationMap.Lookup lookup() {
        return new MapBuilder(plan, workers)
                .build(scene.camera(), pass.photons(), 0)
                .lookup();
    }

    /** The irradiance, in W·m⁻², at a point of a surface that faces up. */
    static double irradiance(IlluminationMap.Lookup lookup, int object, double x, double y, double z) {
        SurfacePoint at = new SurfacePoint();
        at.x = x;
        at.y = y;
        at.z = z;
        at.normalY = 1;
        at.object = object;
        at.front = true;
        Rgb irradiance = new Rgb();
        lookup.irradiance(at, irradiance);
        return irradiance.green;
    }
}
