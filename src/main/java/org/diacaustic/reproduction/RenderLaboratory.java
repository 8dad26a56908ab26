package org.diacaustic.reproduction;

import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.diacaustic.map.IlluminationMap;
import org.diacaustic.map.PhotonStore;
import org.diacaustic.map.SurfacePoint;
import org.diacaustic.math.Rgb;
import org.diacaustic.parallel.Workers;
import org.diacaustic.preprocess.ForwardCounters;
import org.diacaustic.preprocess.ForwardPass;
import org.diacaustic.preprocess.ForwardPlan;
import org.diacaustic.preprocess.MapBuilder;
import org.diacaustic.render.Counters;
import org.diacaustic.render.RenderJob;
import org.diacaustic.render.RenderPlan;
import org.diacaustic.render.Rendering;
import org.diacaustic.scenefile.SceneFile;

/** Carries out experiments by rendering in the thesis' way, each on one thread. May be asked from several threads. */
final class RenderLaboratory implements Laboratory {
    private static final Workers ALONE = new Workers(1);

    private final Map<ThesisScene, List<SurfacePoint>> eyeHits = new EnumMap<>(ThesisScene.class);

    @Override
    public Measurement measure(Experiment experiment, long seed, boolean withPicture) {
        SceneFile file = experiment.scene().read();
        RenderPlan plan = RenderPlan.of(file.scene(), ThesisParameters.settings(experiment, file.settings(), seed));
        Map<Quantity, Double> counts = new EnumMap<>(Quantity.class);
        if (experiment.method().isShadingModel()) {
            Rendering rendering = job(plan).run();
            addEyeCounts(rendering.counters(), counts);
            return new Measurement(counts, Optional.of(rendering.image()));
        }
        ForwardPlan forwardPlan = plan.forward().orElseThrow();
        PhotonStore photons = trace(forwardPlan, counts);
        boolean isPhotonMap = experiment.map() == MapKind.PHOTON_MAP;
        InsertionTree tree = isPhotonMap ? insert(photons, counts) : null;
        if (!isPhotonMap && !withPicture) {
            return new Measurement(counts, Optional.empty());
        }
        IlluminationMap map =
                new MapBuilder(forwardPlan, ALONE).build(plan.scene().camera(), photons, 0);
        if (isPhotonMap) {
            addRetrievalCounts(tree, map, eyeHits(experiment.scene(), plan), experiment.scene(), counts);
        }
        return new Measurement(
                counts, withPicture ? Optional.of(job(plan).run(map).image()) : Optional.empty());
    }

    private static RenderJob job(RenderPlan plan) {
        return new RenderJob(plan, 1, (done, total) -> {});
    }

    private static void addEyeCounts(Counters counters, Map<Quantity, Double> counts) {
        counts.put(Quantity.EYE_TESTS, (double) counters.intersectionTests());
        counts.put(Quantity.SHADOW_RAYS, (double) counters.shadowRays());
        counts.put(Quantity.REFLECTION_RAYS, (double) counters.reflectionRays());
        counts.put(Quantity.REFRACTION_RAYS, (double) counters.refractionRays());
    }

    private static PhotonStore trace(ForwardPlan plan, Map<Quantity, Double> counts) {
        long start = System.nanoTime();
        ForwardPass forward = new ForwardPass(plan, 0, ALONE).run();
        counts.put(Quantity.PREPROCESSING_SECONDS, (System.nanoTime() - start) * 1e-9);
        addForwardCounts(forward.counters(), counts);
        return forward.photons();
    }

    private static void addForwardCounts(ForwardCounters counters, Map<Quantity, Double> counts) {
        double rays = counters.lightRays();
        // The thesis counts hits of the rays that it chose, and of those that it stored, in all of its tables.
        double intersections = counters.primaryHits() + counters.stored();
        counts.put(Quantity.LIGHT_TESTS, (double) counters.intersectionTests());
        counts.put(Quantity.OBJECT_INTERSECTIONS, intersections);
        counts.put(Quantity.STORED, (double) counters.stored());
        counts.put(Quantity.RAYS_TRACED, rays);
        counts.put(Quantity.PERCENT_INTERSECTING, 100 * intersections / rays);
        counts.put(Quantity.PERCENT_STORED, 100 * counters.stored() / rays);
        counts.put(Quantity.PRIMARY_RAYS, (double) counters.primaryRays());
        counts.put(Quantity.PRIMARY_HITS, (double) counters.primaryHits());
        counts.put(Quantity.LIGHT_HITS, (double) counters.objectIntersections());
    }

    private static InsertionTree insert(PhotonStore photons, Map<Quantity, Double> counts) {
        long start = System.nanoTime();
        InsertionTree tree = new InsertionTree();
        SurfacePoint at = new SurfacePoint();
        for (int i = 0; i < photons.size(); i++) {
            photons.position(i, at);
            tree.insert((float) at.x, (float) at.y, (float) at.z, EyeHits.place(at));
        }
        counts.merge(Quantity.PREPROCESSING_SECONDS, (System.nanoTime() - start) * 1e-9, Double::sum);
        counts.put(Quantity.TREE_HEIGHT, (double) tree.height());
        counts.put(Quantity.INSERTION_STEPS, (double) tree.insertionSteps());
        return tree;
    }

    private static void addRetrievalCounts(
            InsertionTree tree,
            IlluminationMap balanced,
            List<SurfacePoint> points,
            ThesisScene scene,
            Map<Quantity, Double> counts) {
        float radius = (float) ThesisParameters.of(scene).gatherRadius();
        IlluminationMap.Lookup lookup = balanced.lookup();
        Rgb irradiance = new Rgb();
        for (SurfacePoint at : points) {
            tree.lookUp((float) at.x, (float) at.y, (float) at.z, radius, EyeHits.place(at));
            lookup.irradiance(at, irradiance);
        }
        counts.put(Quantity.LOOKUPS, (double) points.size());
        counts.put(Quantity.NODES_EXAMINED, (double) tree.nodesExamined());
        counts.put(Quantity.PHOTONS_USED, (double) tree.photonsUsed());
        counts.put(Quantity.FOREIGN_PHOTONS, (double) tree.foreignPhotonsUsed());
        counts.put(Quantity.MOST_NODES, (double) tree.mostNodes());
        counts.put(Quantity.BALANCED_NODES, (double) lookup.nodesExamined());
    }

    private synchronized List<SurfacePoint> eyeHits(ThesisScene scene, RenderPlan plan) {
        return eyeHits.computeIfAbsent(scene, key -> {
            EyeHits hits = new EyeHits();
            job(plan).run(hits);
            return hits.points();
        });
    }
}
