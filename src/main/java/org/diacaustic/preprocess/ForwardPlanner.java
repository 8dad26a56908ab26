package org.diacaustic.preprocess;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import org.diacaustic.light.Light;
import org.diacaustic.light.LightPoint;
import org.diacaustic.map.CellStore;
import org.diacaustic.material.TransportMode;
import org.diacaustic.math.Bounds;
import org.diacaustic.math.Rgb;
import org.diacaustic.math.Vector3;
import org.diacaustic.scene.EstimatorName;
import org.diacaustic.scene.ForwardSettings;
import org.diacaustic.scene.MapName;
import org.diacaustic.scene.MediumLocator;
import org.diacaustic.scene.MediumStack;
import org.diacaustic.scene.Scene;
import org.diacaustic.scene.SceneIndex;
import org.diacaustic.scene.SceneObject;
import org.diacaustic.scene.Settings;
import org.diacaustic.transport.PathRules;

/** Resolves scene and settings into a {@link ForwardPlan}. */
public final class ForwardPlanner {
    /** Bytes of memory that a photon may take all in, with the tree over it and what building that needs meanwhile. */
    private static final int BYTES_A_PHOTON = 48;

    /** Bytes of memory that a cell may take all in, with its part of the mesh half as fine, while meshes are built. */
    private static final int BYTES_A_CELL = 192;

    /** Below this fraction of its ray's flux, light is followed by chance, unless the settings follow everything. */
    private static final double ROULETTE_THROUGHPUT = 0.25;

    /** How often a window's flux is looked at along each side. */
    private static final int FLUX_SAMPLES = 8;

    private final Scene scene;
    private final SceneIndex index;
    private final Settings settings;
    private final ForwardSettings forward;
    private final Bounds bounds;

    public ForwardPlanner(Scene scene, SceneIndex index, Settings settings) {
        this.scene = scene;
        this.index = index;
        this.settings = settings;
        this.forward = settings.forward();
        this.bounds = EmissionWindows.finiteBounds(scene);
    }

    /** The lights that have a part in forward passes, in the order of the scene. */
    public static List<Light> emitters(Scene scene) {
        return scene.lights().stream()
                .filter(light -> light.spread() != Light.Spread.NONE)
                .toList();
    }

    /**
     * Plans a pass.
     *
     * @param rays to choose in all
     * @param map what keeps the light, not left to the plan
     * @param estimator how it is read, not left to the plan
     * @throws ForwardPlanException if the pre-processor cannot serve a light of the scene, or the map an object
     */
    public ForwardPlan plan(PreProcessor preProcessor, long rays, MapName map, EstimatorName estimator) {
        boolean isWeighted = estimator != EstimatorName.EXPECTED_COUNT;
        if (map == MapName.AMBIENT_MAPS) {
            AmbientCharts.requireEnds(index);
        }
        if (settings.maps().initialHits() > 0) {
            refuseInitialHitsWithoutEnd();
        }
        // A chart of cells fits one object.
        List<Target> targets = targets(map != MapName.CAUSTIC_MESH);
        List<Beam> beams = new ArrayList<>();
        double powerUnit = 0;
        for (int i = 0; i < targets.size(); i++) {
            Target target = targets.get(i);
            Beam beam = beam(i, target, Math.max(1, Math.round(rays * share(target, targets))));
            boolean isMesh = map == MapName.CAUSTIC_MESH;
            (isMesh ? preProcessor.cellRefusal(beam) : preProcessor.refusal(beam)).ifPresent(reason -> {
                throw new ForwardPlanException("preprocessor '" + preProcessor.name() + "' cannot serve light "
                        + (scene.lights().indexOf(target.light) + 1) + ", because " + reason
                        + (isMesh
                                ? "; take own-map, cube or adaptive"
                                : "; take cube, adaptive, random or monte-carlo"));
            });
            beams.add(beam);
            powerUnit = Math.max(powerUnit, typicalPower(beam, target, isWeighted));
        }
        PathRules rules = new PathRules(
                settings.scatterRules(),
                TransportMode.FLUX,
                forward.maxDepth(),
                0,
                forward.followsReflections(),
                settings.usesListOrder());
        return new ForwardPlan(
                index,
                rules,
                settings.minimumThroughput() > 0 ? ROULETTE_THROUGHPUT : 0,
                preProcessor,
                List.copyOf(beams),
                isWeighted,
                settings.seed(),
                bounds.isEmpty() ? Vector3.ZERO : bounds.centre(),
                !bounds.isEmpty() && bounds.radius() > 0 ? bounds.radius() : 1,
                powerUnit > 0 ? ForwardPlan.unit(powerUnit) : 1,
                capacity(map),
                map,
                estimator,
                forward.passes(),
                settings.maps());
    }

    private static int capacity(MapName map) {
        int bytes = map == MapName.CAUSTIC_MESH ? BYTES_A_CELL : BYTES_A_PHOTON;
        int most = map == MapName.CAUSTIC_MESH ? CellStore.LARGEST_CAPACITY : Integer.MAX_VALUE - 8;
        return (int) Math.min(most, Runtime.getRuntime().maxMemory() / bytes);
    }

    private List<Target> targets(boolean joins) {
        List<Target> targets = new ArrayList<>();
        EmissionWindows windows = new EmissionWindows(scene, settings, joins);
        for (Light light : emitters(scene)) {
            if (light.spread() == Light.Spread.PARALLEL) {
                refuseEndless(light);
            }
            for (EmissionWindow window : windows.of(light)) {
                targets.add(new Target(light, window));
            }
        }
        return targets;
    }

    private void refuseInitialHitsWithoutEnd() {
        for (SceneObject object : scene.objects()) {
            if (object.material().isTransparent() && Beam.isEndless(object.shape())) {
                throw new ForwardPlanException(
                        "'" + object.name()
                                + "' has no end, and no areas that could let 'initial-hits' through; give it bounds, or leave those out");
            }
        }
    }

    /** Refuses parallel light where it would have to be followed from surfaces that have no end. */
    private void refuseEndless(Light light) {
        for (SceneObject object : scene.objects()) {
            if (EmissionWindows.isSpecular(object, forward) && Beam.isEndless(object.shape())) {
                throw new ForwardPlanException("light " + (scene.lights().indexOf(light) + 1)
                        + " has parallel rays and '" + object.name()
                        + "' has no bounds, so there is no end to what they meet; give it bounds, as a polygon has");
            }
        }
    }

    private Beam beam(int number, Target target, long rays) {
        LightPoint middle = middle(target.light);
        double startDistance = 0;
        Vector3 start = new Vector3(middle.x, middle.y, middle.z);
        if (target.light.spread() == Light.Spread.PARALLEL) {
            Vector3 centre = target.window.bounds().centre();
            startDistance = 2 * bounds.radius() + centre.minus(bounds.centre()).length();
            start = centre.minus(new Vector3(middle.normalX, middle.normalY, middle.normalZ).times(startDistance));
        }
        MediumStack media = MediumLocator.locate(index, start);
        Beam beam = new Beam(
                number,
                index,
                target.light,
                target.window,
                names(target.window),
                rays,
                forward,
                media,
                startDistance,
                depositFactor(target, middle));
        target.flux = flux(beam, middle) * beam.typicalDepositFactor();
        return beam;
    }

    private static LightPoint middle(Light light) {
        LightPoint middle = new LightPoint();
        light.emitFrom(0.5, 0.5, middle);
        return middle;
    }

    private String names(EmissionWindow window) {
        if (!forward.aimsAtSpecular()) {
            return "the whole scene";
        }
        return window.objects().stream()
                .mapToObj(i -> "'" + scene.objects().get(i).name() + "'")
                .collect(Collectors.joining(", "));
    }

    /** Rays by flux, so that photons are about equal; but no window gets less than a quarter of an equal part. */
    private double share(Target target, List<Target> all) {
        double least = 0.25 / all.size();
        double total = 0;
        double sum = 0;
        for (Target each : all) {
            total += fluxOf(each);
        }
        for (Target each : all) {
            sum += Math.max(least, fluxOf(each) / total);
        }
        return Math.max(least, fluxOf(target) / total) / sum;
    }

    private double fluxOf(Target target) {
        if (Double.isNaN(target.flux)) {
            beam(0, target, 1);
        }
        return Math.max(Double.MIN_NORMAL, target.flux);
    }

    /** About the flux, in W, that the light sends into the window. */
    private static double flux(Beam beam, LightPoint middle) {
        Lattice samples = new Lattice(beam.uniformChart(middle), FLUX_SAMPLES, FLUX_SAMPLES, 0.5, 0.5);
        LightRay ray = new LightRay();
        Rgb intensity = new Rgb();
        double sum = 0;
        for (int i = 0; i < samples.size(); i++) {
            samples.aim(i, ray);
            beam.light().emit(middle, ray.directionX, ray.directionY, ray.directionZ, intensity);
            sum += intensity.largest() * ray.measure;
        }
        return sum / samples.size();
    }

    private double depositFactor(Target target, LightPoint middle) {
        return target.light.spread() == Light.Spread.PARALLEL
                ? 1
                : target.light.depositFactor(typicalDistance(target, middle));
    }

    private double typicalDistance(Target target, LightPoint middle) {
        Vector3 towards = target.window.bounds().isFinite()
                ? target.window.bounds().centre()
                : bounds.isEmpty() ? Vector3.ZERO : bounds.centre();
        return Math.max(
                towards.minus(new Vector3(middle.x, middle.y, middle.z)).length(),
                bounds.isEmpty() ? 1 : bounds.radius());
    }

    private double typicalPower(Beam beam, Target target, boolean isWeighted) {
        if (isWeighted) {
            return target.flux / beam.rays();
        }
        if (target.light.spread() == Light.Spread.PARALLEL) {
            return 1;
        }
        double distance = typicalDistance(target, middle(target.light));
        return target.flux / (distance * distance);
    }

    /** A light, a window of it, and about what the one brings to where the light of the other lands, in W. */
    private static final class Target {
        final Light light;
        final EmissionWindow window;
        double flux = Double.NaN;

        Target(Light light, EmissionWindow window) {
            this.light = light;
            this.window = window;
        }
    }
}
