package org.diacaustic.trial;

import java.util.Arrays;
import java.util.List;
import java.util.function.ToDoubleFunction;
import org.diacaustic.light.PointLight;
import org.diacaustic.math.Color;
import org.diacaustic.math.Vector3;
import org.diacaustic.parallel.Workers;
import org.diacaustic.preprocess.EnergyLedger;
import org.diacaustic.preprocess.ForwardPlanner;
import org.diacaustic.preprocess.MeshPass;
import org.diacaustic.preprocess.PreProcessors;
import org.diacaustic.scene.EstimatorName;
import org.diacaustic.scene.MapName;
import org.diacaustic.scene.Scene;
import org.diacaustic.scene.SceneIndex;
import org.diacaustic.scene.Settings;
import org.diacaustic.shape.Box;
import org.diacaustic.shape.Shape;
import org.diacaustic.shape.Sphere;
import org.diacaustic.stability.CaseFault;
import org.diacaustic.stability.Checks;
import org.diacaustic.stability.NumericCase;
import org.diacaustic.stability.Operations;

/** Where the light of forward passes goes. */
final class LedgerTrials {
    /** Light is mirrored so often before what is left is nothing. */
    private static final int ALL = 100_000;

    private static final long RADIAL_RAYS = 20;
    private static final long RANDOM_RAYS = 10_000;
    private static final long FEW_RAYS = 100;

    private LedgerTrials() {}

    static void addTo(Operations operations) {
        operations.add(
                "ledger",
                "Forward passes over the scene, with random rays and with cells of a caustic mesh: emitted − (stored + absorbed +"
                        + " escaped + cut) of the ledger, relative. What a roulette takes or gives is cut.",
                LedgerTrials::ledger);
        operations.add(
                "light_in_sphere",
                "Forward passes with a lamp in the middle of a ball of glass, by the ledger: with light refracted once and not"
                        + " mirrored, and with all of it followed. And without Fresnel, against exp(−sigma R).",
                LedgerTrials::lightInSphere);
        operations.add(
                "escape_halfspace",
                "Forward passes with a lamp under an endless flat surface, in 16 runs: the part of its light that escapes, with and"
                        + " without Fresnel. The critical angle as in snell_window.",
                LedgerTrials::escapeHalfspace);
        operations.add(
                "sphere_flux_split",
                "Forward passes over a ball in parallel light, in 16 runs, each with the same rays followed less or more far: what"
                        + " of the light that meets the ball is neither absorbed nor cut.",
                LedgerTrials::sphereFluxSplit);
        operations.add(
                "roulette",
                "Forward passes with a lamp between mirrors on all sides, which keep 1 − reflectance at each visit, in 16 runs: so"
                        + " all visits together are what is kept ÷ (1 − reflectance). The roulette is the pass' own, which begins at"
                        + " a quarter of a ray's flux and lets survive in proportion to it.",
                LedgerTrials::roulette);
        operations.add(
                "furnace",
                "Not run: light that a matt surface sends on to others is no part of what is rendered.",
                (asked, checks) -> checks.notApplicable(
                        "it asks for light between matt surfaces, after a diffuse bounce, which is no part of what is rendered"));
    }

    private static EnergyLedger random(Scene scene, Settings settings, long seed, long rays) {
        return LightRun.of(scene, settings.toBuilder().seed(seed).build(), "random", rays)
                .ledger();
    }

    /** Weak light is followed by chance, as it is if nothing is said. */
    private static Settings withRoulette(Settings settings) {
        return settings.toBuilder()
                .minimumThroughput(Settings.physical().minimumThroughput())
                .build();
    }

    private static double sum(EnergyLedger ledger) {
        return ledger.stored() + ledger.absorbed() + ledger.escaped() + ledger.cut();
    }

    private static void ledger(NumericCase asked, Checks checks) {
        long rays = asked.inputs().integer("photons");
        double flux = asked.inputs().number("flux");
        Settings settings =
                withRoulette(OpticalScenes.settings((int) asked.inputs().integer("max_depth"), true, true));
        Scene scene = Scene.builder()
                .camera(OpticalScenes.above(0, 8, 0))
                .light(new PointLight(new Vector3(0.3, 6, -0.2), Color.grey(flux / (4 * Math.PI))))
                .object("floor", OpticalScenes.level(0), OpticalScenes.MATT)
                .object("ball", new Sphere(new Vector3(0, 3, 0), 1), OpticalScenes.clear(1.5))
                .object(
                        "slab",
                        new Box(new Vector3(0.5, 1, -1), new Vector3(3, 1.4, 2)),
                        OpticalScenes.clear(1.33, 0.7))
                .build();
        EnergyLedger photons = random(scene, settings, 1, rays);
        EnergyLedger cells = cells(scene, settings, rays);
        checks.holds(
                "cells stand for some light",
                cells.emitted() > 0 || flux == 0 || settings.forward().maxDepth() == 0);
        for (EnergyLedger each : List.of(photons, cells)) {
            double gap = Math.abs(each.emitted() - sum(each));
            double relative = gap == 0 ? 0 : gap / each.emitted();
            String what = each.equals(photons) ? "relative_gap, photons" : "relative_gap, cells";
            checks.number(what, 0, relative, asked.tolerance().number("relative_gap"));
        }
    }

    private static EnergyLedger cells(Scene scene, Settings settings, long rays) {
        var plan = new ForwardPlanner(scene, SceneIndex.of(scene.objects(), false), settings)
                .plan(PreProcessors.byName(List.of()).get("cube"), rays, MapName.CAUSTIC_MESH, EstimatorName.DENSITY);
        return new MeshPass(plan, 0, new Workers(1), part -> {}).run().ledger();
    }

    private static void lightInSphere(NumericCase asked, Checks checks) {
        double radius = asked.inputs().number("R");
        double sigma = asked.inputs().number("sigma");
        Scene scene = element(new Sphere(Vector3.ZERO, radius), asked.inputs().number("n"), sigma, radius);
        EnergyLedger first = random(scene, OpticalScenes.through(1, true), 1, RADIAL_RAYS);
        EnergyLedger all = random(scene, OpticalScenes.settings(ALL, true, true), 1, RADIAL_RAYS);
        EnergyLedger bare = random(scene, OpticalScenes.through(1, false), 1, RADIAL_RAYS);
        checks.size(1).number("first_pass_escaped_fraction", first.escaped() / first.emitted(), "");
        checks.number("all_passes_escaped_fraction", all.escaped() / all.emitted(), "");
        double absorbed = asked.expected().number("absorbed_fraction");
        double tolerance = asked.tolerance().number("rel") * (absorbed == 0 ? 1 : absorbed);
        checks.number("absorbed_fraction", absorbed, all.absorbed() / all.emitted(), tolerance);
        double straight = StrictMath.exp(-sigma * radius);
        checks.number("escaped without Fresnel", straight, bare.escaped() / bare.emitted(), 1e-12 * straight);
    }

    /** Glass about the middle, with a lamp in it. */
    private static Scene element(Shape shape, double n, double sigma, double size) {
        return Scene.builder()
                .camera(OpticalScenes.above(0, 3 * size, 0))
                .light(OpticalScenes.lamp(0, 1))
                .object("element", shape, OpticalScenes.clear(n, sigma))
                .build();
    }

    private static void escapeHalfspace(NumericCase asked, Checks checks) {
        double n = asked.inputs().number("n");
        Scene scene = Scene.builder()
                .camera(OpticalScenes.above(0, 3, 0))
                .light(OpticalScenes.lamp(-1, 1))
                .object("floor", OpticalScenes.level(-2), OpticalScenes.MATT)
                .object("surface", OpticalScenes.level(0), OpticalScenes.clear(n))
                .build();
        for (boolean fresnel : new boolean[] {true, false}) {
            String name = fresnel ? "fresnel" : "no_fresnel";
            Settings settings = OpticalScenes.settings(1, true, fresnel);
            // Of the light of the whole lamp, 1 in each of three colours.
            Estimate.over(seed -> random(scene, settings, seed, RANDOM_RAYS).escaped() / 3)
                    .check(checks, name, asked.expected().number(name));
        }
        checks.number("critical_angle_deg", WalkTrials.criticalDegrees(n), "");
    }

    private static void sphereFluxSplit(NumericCase asked, Checks checks) {
        double radius = asked.inputs().number("R");
        Scene scene = Scene.builder()
                .camera(OpticalScenes.above(0, 3 * radius, 0))
                .light(OpticalScenes.sun())
                .object(
                        "ball",
                        new Sphere(Vector3.ZERO, radius),
                        OpticalScenes.clear(
                                asked.inputs().number("n"), asked.inputs().number("sigma")))
                .build();
        double[][] splits = new double[Estimate.RUNS][];
        for (int run = 0; run < splits.length; run++) {
            splits[run] = split(scene, Estimate.FIRST_SEED + run);
        }
        String[] names = {
            "reflected_first", "transmitted_two_refractions", "absorbed_all_orders", "leaves_after_more_reflections"
        };
        for (int i = 0; i < names.length; i++) {
            int part = i;
            ToDoubleFunction<double[]> its = split -> split[part];
            Estimate.of(Arrays.stream(splits).mapToDouble(its).toArray())
                    .check(checks, names[i], asked.expected().number(names[i]));
        }
    }

    /** The parts of the light that meets a ball: all of it is cut if nothing is followed. */
    private static double[] split(Scene scene, long seed) {
        double met = random(scene, OpticalScenes.settings(0, true, true), seed, RANDOM_RAYS)
                .cut();
        EnergyLedger once = random(scene, OpticalScenes.settings(1, true, true), seed, RANDOM_RAYS);
        EnergyLedger through = random(scene, OpticalScenes.through(2, true), seed, RANDOM_RAYS);
        EnergyLedger all = random(scene, withRoulette(OpticalScenes.settings(ALL, true, true)), seed, RANDOM_RAYS);
        double reflected = 1 - (once.cut() + once.absorbed()) / met;
        double transmitted = 1 - (through.cut() + through.absorbed()) / met;
        double absorbed = all.absorbed() / met;
        return new double[] {reflected, transmitted, absorbed, 1 - reflected - transmitted - absorbed - all.cut() / met
        };
    }

    private static void roulette(NumericCase asked, Checks checks) {
        double reflectance = asked.inputs().number("reflectance");
        if (!(reflectance >= 0 && reflectance < 1)) {
            throw new CaseFault("there is no end of visits to mirrors that keep nothing");
        }
        Scene scene = Scene.builder()
                .camera(OpticalScenes.above(0, 3, 0))
                .light(OpticalScenes.lamp(0.1, 1))
                .object(
                        "mirrors",
                        new Box(new Vector3(-1, -1, -1), new Vector3(1, 1, 1)),
                        OpticalScenes.mirror(reflectance))
                .build();
        Settings settings = withRoulette(OpticalScenes.settings(ALL, true, true));
        if (reflectance == 0) {
            // No light is traced forward where nothing mirrors.
            RayWalk walk = RayWalk.in(scene, settings).follow(Vector3.ZERO, Vector3.UNIT_X);
            checks.number("E_total_visits", walk.visited(), "");
            return;
        }
        long rays = Math.max(FEW_RAYS, Math.round(RANDOM_RAYS * Math.min(1, 3 * (1 - reflectance))));
        Estimate.over(seed -> {
                    EnergyLedger ledger = random(scene, settings, seed, rays);
                    return ledger.absorbed() / ledger.emitted() / (1 - reflectance);
                })
                .check(checks, "E_total_visits", asked.expected().number("E_total_visits"));
        checks.note("a survival of " + asked.inputs().text("survival", "any")
                + " cannot be asked for: the pass' own roulette is run, on which the mean must not depend");
    }
}
