package org.diacaustic.trial;

import java.util.List;
import java.util.Locale;
import org.apache.commons.math3.analysis.integration.gauss.GaussIntegrator;
import org.apache.commons.math3.analysis.integration.gauss.GaussIntegratorFactory;
import org.diacaustic.light.Light;
import org.diacaustic.light.LightPoint;
import org.diacaustic.light.LightSample;
import org.diacaustic.light.PointLight;
import org.diacaustic.material.Material;
import org.diacaustic.material.Medium;
import org.diacaustic.math.Color;
import org.diacaustic.math.Ray;
import org.diacaustic.math.Vector3;
import org.diacaustic.parallel.Workers;
import org.diacaustic.preprocess.Beam;
import org.diacaustic.preprocess.EmissionChart;
import org.diacaustic.preprocess.ForwardPlan;
import org.diacaustic.preprocess.MeshPass;
import org.diacaustic.render.Counters;
import org.diacaustic.render.RenderPlan;
import org.diacaustic.render.Rendering;
import org.diacaustic.scene.Camera;
import org.diacaustic.scene.EstimatorName;
import org.diacaustic.scene.MapName;
import org.diacaustic.scene.Scene;
import org.diacaustic.scene.SceneIndex;
import org.diacaustic.scene.Settings;
import org.diacaustic.shape.Hit;
import org.diacaustic.shape.Plane;
import org.diacaustic.shape.Sphere;
import org.diacaustic.stability.CaseFault;
import org.diacaustic.stability.Checks;
import org.diacaustic.stability.NumericCase;
import org.diacaustic.stability.Operations;

/** What is left out where a scene does not need it. */
final class SpareTrials {
    private static final int SIDE = 200;
    private static final Material MATT = Material.builder().diffuse(Color.WHITE).build();
    private static final Way PHOTONS = new Way("random", MapName.PHOTON_MAP, EstimatorName.DENSITY);

    /** Nodes of a Gauss rule along each side of a chart. */
    private static final int NODES = 48;

    private SpareTrials() {}

    static void addTo(Operations operations) {
        operations.add(
                "spare_counters",
                "Renders a matt floor and ball under a point light with a photon map asked for, and without. Time is read as the work that"
                        + " is counted: intersection tests and nodes of maps.",
                SpareTrials::opaque);
        operations.add(
                "spare_shadow",
                "Renders an opaque scene with both shading models of the thesis.",
                SpareTrials::shadowModels);
        operations.add("spare_dof", "Renders with a lens of radius 0, and with a pinhole.", SpareTrials::pinhole);
        operations.add(
                "spare_emission",
                "The beam that a render plans from a point light at a sphere: the solid angle of its charts by a Gauss rule, the rays that"
                        + " meet the sphere, and the flux that they carry, within 1e-4 for what rays at the very rim lose.",
                SpareTrials::emission);
        operations.add(
                "spare_noop",
                "Renders a ball of index 1 with everything left to the plan, and with straight shadow rays asked for.",
                SpareTrials::bendsNothing);
        operations.add(
                "spare_counters_exact",
                "Renders a picture of so many pixels, one ray each, on one, two and four threads; a hit is lit by a light that is on its side of"
                        + " the surface, whatever is between.",
                SpareTrials::counters);
    }

    private static Camera.Builder camera() {
        return Camera.builder()
                .from(new Vector3(0, 3, 9))
                .to(new Vector3(0, 0.5, 0))
                .size(SIDE, SIDE);
    }

    private static Scene.Builder floor() {
        return Scene.builder()
                .camera(camera().build())
                .light(new PointLight(new Vector3(2, 6, 3), Color.grey(90)))
                .object("floor", new Plane(Vector3.ZERO, Vector3.UNIT_Y), MATT);
    }

    private static Scene.Builder withBall(Material material) {
        return floor().object("ball", new Sphere(new Vector3(0, 1, 0), 1), material);
    }

    private static void opaque(NumericCase asked, Checks checks) {
        Scene scene = withBall(MATT).build();
        Rendering withMap = Pictures.render(scene, PHOTONS.settings(1_000_000, 1));
        Rendering without = Pictures.render(scene, Way.NONE.settings(0, 1));
        checks.number("photons_traced", withMap.forward().counters().lightRays());
        checks.number("photon_or_map_bytes", withMap.forward().mapBytes());
        checks.same("pixels that differ", 0, Pictures.different(withMap.image(), without.image()));
        checks.atMost(
                "work in relation to that without a map",
                asked.expected().number("render_time_ratio_max", 1.05),
                (double) work(withMap.counters()) / work(without.counters()));
    }

    private static long work(Counters counters) {
        return counters.intersectionTests() + counters.nodesExamined();
    }

    private static void shadowModels(NumericCase asked, Checks checks) {
        Scene scene = withBall(Material.builder()
                        .diffuse(Color.grey(0.5))
                        .reflectivity(Color.grey(0.4))
                        .build())
                .build();
        List<String> models = asked.inputs().texts("models");
        Rendering first = Pictures.render(scene, shader(models.get(0)));
        for (String model : models.subList(1, models.size())) {
            Rendering other = Pictures.render(scene, shader(model));
            checks.same("pixels that differ with " + model, 0, Pictures.different(first.image(), other.image()));
            checks.same(
                    "shadow rays with " + model,
                    first.counters().shadowRays(),
                    other.counters().shadowRays());
            checks.same(
                    "intersection tests with " + model,
                    first.counters().intersectionTests(),
                    other.counters().intersectionTests());
        }
    }

    private static Settings shader(String name) {
        return Way.NONE.settings(0, 1).toBuilder().shader(name).build();
    }

    private static void pinhole(NumericCase asked, Checks checks) {
        Scene pinhole = withBall(MATT).build();
        Scene lens = withBall(MATT).camera(camera().lens(0, 7).build()).build();
        Rendering sharp = Pictures.render(pinhole, Way.NONE.settings(0, 1));
        Rendering through = Pictures.render(lens, Way.NONE.settings(0, 1));
        checks.number("lens_samples_per_pixel", (double) through.counters().eyeRays() / (SIDE * SIDE));
        checks.same("pixels that differ", 0, Pictures.different(sharp.image(), through.image()));
    }

    private static void emission(NumericCase asked, Checks checks) {
        double radius = asked.inputs().number("radius");
        double distance = asked.inputs().number("distance");
        if (!(distance > radius)) {
            throw new CaseFault("inputs.distance " + distance + " is not outside of a sphere of radius " + radius);
        }
        double flux = 4 * Math.PI;
        Scene scene = Scene.builder()
                .camera(camera().build())
                .light(new PointLight(Vector3.ZERO, Color.WHITE))
                .object("floor", new Plane(new Vector3(0, -2 * distance, 0), Vector3.UNIT_Y), MATT)
                .object(
                        "ball",
                        new Sphere(new Vector3(0, 0, -distance), radius),
                        Material.builder()
                                .transparency(Color.WHITE)
                                .inside(Medium.of(1.5))
                                .build())
                .build();
        ForwardPlan plan =
                RenderPlan.of(scene, Way.MESH.settings(20_000, 1)).forward().orElseThrow();
        Beam beam = plan.beams().get(0);
        LightPoint from = new LightPoint();
        beam.light().emitFrom(0, 0, from);
        double solidAngle = 0;
        for (EmissionChart chart : plan.preProcessor().charts(beam, from)) {
            solidAngle += measure(chart);
        }
        double fraction = solidAngle / flux;
        checks.number("solid_angle_fraction", fraction, "fraction");
        checks.number("photons_wasted_if_uniform_percent", 100 * (1 - fraction), "fraction");
        MeshPass pass = new MeshPass(plan, 0, new Workers(1), part -> {}).run();
        double hits = (double) pass.counters().primaryHits() / pass.counters().primaryRays();
        double least = asked.tolerance().number("hit_fraction_min");
        checks.rule(
                "rays that meet the sphere",
                "at least " + least,
                String.format(Locale.ROOT, "%.4f", hits),
                hits >= least);
        double expected = asked.expected().number("solid_angle_fraction");
        checks.number(
                "flux that rays carry, in that of the light",
                expected,
                pass.ledger().emitted() / 3 / flux,
                1e-4 * expected);
    }

    /** How much of light space a chart is, over the four triangles in which a disc's chart is smooth. */
    private static double measure(EmissionChart chart) {
        GaussIntegratorFactory rules = new GaussIntegratorFactory();
        GaussIntegrator outward = rules.legendre(NODES, 0, 1);
        GaussIntegrator across = rules.legendre(NODES, -1, 1);
        return outward.integrate(r -> r
                        * across.integrate(w -> density(chart, r, r * w)
                                + density(chart, -r, r * w)
                                + density(chart, r * w, r)
                                + density(chart, r * w, -r)))
                / 4;
    }

    private static double density(EmissionChart chart, double a, double b) {
        return chart.density(0.5 * (1 + a), 0.5 * (1 + b));
    }

    private static void bendsNothing(NumericCase asked, Checks checks) {
        Scene scene = withBall(Material.builder()
                        .transparency(Color.grey(0.8))
                        .inside(Medium.of(1))
                        .build())
                .build();
        Settings left = Settings.physical().toBuilder().fresnel(false).build();
        Rendering planned = Pictures.render(scene, left);
        Rendering straight = Pictures.render(
                scene, shader("non-refractive").toBuilder().fresnel(false).build());
        checks.same("photons_traced", 0L, planned.forward().counters().lightRays());
        checks.same(
                "pixels that differ from straight shadow rays",
                0,
                Pictures.different(planned.image(), straight.image()));
        checks.note("no light rays are sent");
    }

    private static void counters(NumericCase asked, Checks checks) {
        int eyeRays = Math.toIntExact(asked.inputs().integer("eye_rays"));
        if (eyeRays < 1) {
            throw new CaseFault("inputs.eye_rays should be at least 1, but is " + eyeRays);
        }
        int rows = (int) Math.sqrt(eyeRays);
        while (eyeRays % rows != 0) {
            rows--;
        }
        Scene scene = withBall(MATT)
                .camera(camera().size(eyeRays / rows, rows).build())
                .light(new PointLight(new Vector3(-3, 5, 2), Color.grey(20)))
                .build();
        Rendering one = Pictures.render(scene, Way.NONE.settings(0, 1));
        checks.number("eye_rays", one.counters().eyeRays());
        checks.same("shadow rays", litHits(scene), one.counters().shadowRays());
        for (int threads : new int[] {2, 4}) {
            Counters other =
                    Pictures.render(scene, Way.NONE.settings(0, 1), threads).counters();
            String of = " of " + threads + " threads";
            checks.same("eye rays" + of, one.counters().eyeRays(), other.eyeRays());
            checks.same("shadow rays" + of, one.counters().shadowRays(), other.shadowRays());
            checks.same("intersection tests" + of, one.counters().intersectionTests(), other.intersectionTests());
        }
    }

    /** Pairs of a hit that an eye ray makes and a light that is on the same side of the surface there. */
    private static long litHits(Scene scene) {
        SceneIndex index = SceneIndex.of(scene.objects(), false);
        Camera camera = scene.camera();
        Ray ray = new Ray();
        Hit hit = new Hit();
        LightSample sample = new LightSample();
        long pairs = 0;
        for (int y = 0; y < camera.height(); y++) {
            for (int x = 0; x < camera.width(); x++) {
                camera.aim(x + 0.5, y + 0.5, 0, 0, ray);
                int object = index.nearest(ray, SceneIndex.NONE, Ray.FREE);
                if (object != SceneIndex.NONE) {
                    hit.take(ray);
                    index.object(object).shape().complete(ray, hit);
                    for (Light light : scene.lights()) {
                        boolean shines = light.sample(hit.x, hit.y, hit.z, 0, 0, sample);
                        double cosine = sample.directionX * hit.normalX
                                + sample.directionY * hit.normalY
                                + sample.directionZ * hit.normalZ;
                        pairs += shines && cosine > 0 ? 1 : 0;
                    }
                }
            }
        }
        return pairs;
    }
}
