package org.diacaustic.render;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.diacaustic.light.Light;
import org.diacaustic.preprocess.Beam;
import org.diacaustic.preprocess.ForwardPlan;
import org.diacaustic.preprocess.ForwardPlanException;
import org.diacaustic.preprocess.ForwardPlanner;
import org.diacaustic.preprocess.MeshProspect;
import org.diacaustic.preprocess.PreProcessor;
import org.diacaustic.preprocess.PreProcessors;
import org.diacaustic.scene.EstimatorName;
import org.diacaustic.scene.ForwardSettings;
import org.diacaustic.scene.MapName;
import org.diacaustic.scene.MapSettings;
import org.diacaustic.scene.Scene;
import org.diacaustic.scene.SceneIndex;
import org.diacaustic.scene.Settings;
import org.diacaustic.scene.Weights;
import org.diacaustic.shader.NonRefractiveShader;

/** Decides whether there is a forward pass, and which: what was asked for, or what the scene needs. */
final class ForwardChoice {
    /** Rays of a pass if nothing is said: about a second on one core. */
    private static final long RAYS = 1 << 19;

    /** Rays of a mesh if nothing is said. */
    private static final long MESH_RAYS = 1 << 18;

    /** Rays of a mesh if all light is soft, and each point of a lamp has a mesh that every pixel must ask. */
    private static final long LAMP_MESH_RAYS = 1 << 15;

    private final Scene scene;
    private final SceneIndex index;
    private final Settings settings;
    private final SceneTraits traits;
    private final ForwardSettings forward;
    private final MapSettings maps;
    private final boolean isAskedFor;
    private final List<Decision> decisions = new ArrayList<>();
    private String whyThisMap = "";

    ForwardChoice(Scene scene, SceneIndex index, Settings settings, SceneTraits traits) {
        this.scene = scene;
        this.index = index;
        this.settings = settings;
        this.traits = traits;
        this.forward = settings.forward();
        this.maps = settings.maps();
        this.isAskedFor = isNamed(forward.preProcessor()) || isNamed(maps.map());
        refuseContradictions();
    }

    private static boolean isNamed(String preProcessor) {
        return !preProcessor.equals(Settings.AUTO) && !preProcessor.equals(Settings.NONE);
    }

    private static boolean isNamed(MapName map) {
        return map != MapName.AUTO && map != MapName.NONE;
    }

    /** What was decided, after {@link #plan}. */
    List<Decision> decisions() {
        return decisions;
    }

    private void refuseContradictions() {
        if (isAskedFor && settings.shader().equals(NonRefractiveShader.NAME)) {
            throw new PlanException("shader 'non-refractive' lets light through glass straight, and "
                    + (isNamed(maps.map()) ? "map '" + maps.map().label() : "preprocessor '" + forward.preProcessor())
                    + "' brings it again: take shader 'non-transparent', or no map");
        }
        if (isNamed(maps.map()) && forward.preProcessor().equals(Settings.NONE)) {
            throw new PlanException("map '" + maps.map().label() + "' needs a preprocessor, but that is 'none'");
        }
        if (isNamed(forward.preProcessor()) && maps.map() == MapName.NONE) {
            throw new PlanException("preprocessor '" + forward.preProcessor() + "' needs a map, but that is 'none'");
        }
        EstimatorName estimator = maps.estimator();
        boolean needsPhotonMap = estimator == EstimatorName.NEAREST || estimator == EstimatorName.PROGRESSIVE;
        if (maps.map() == MapName.AMBIENT_MAPS && needsPhotonMap) {
            throw new PlanException("estimator '" + estimator.label()
                    + "' reads photon maps; ambient-maps are read by density or expected-count");
        }
        if (maps.map() == MapName.CAUSTIC_MESH && estimator != EstimatorName.AUTO) {
            throw new PlanException("estimator '" + estimator.label()
                    + "' reads photons, and map 'caustic-mesh' has none; leave the estimator out");
        }
        if (maps.mapBlur() % 2 == 0) {
            throw new PlanException("map-blur must be odd, so that its square has a middle, but is " + maps.mapBlur());
        }
        Weights weights = forward.weights();
        boolean counts = estimator == EstimatorName.EXPECTED_COUNT;
        if (counts && weights == Weights.SOLID_ANGLE) {
            throw new PlanException("estimator 'expected-count' needs light-weights 'none', but that is 'solid-angle'");
        }
        if (!counts && maps.initialHits() > 0) {
            throw new PlanException("initial-hits let only some of the light through, and estimator '"
                    + estimator.label() + "' needs all of it: take estimator 'expected-count', or no initial-hits");
        }
        if (!counts && weights == Weights.NONE) {
            throw new PlanException(
                    "light-weights 'none' needs estimator 'expected-count', but that is '" + estimator.label() + "'");
        }
    }

    /**
     * The forward pass; nothing if none is asked for or needed.
     *
     * @param additional pre-processors beside the built-in ones
     */
    Optional<ForwardPlan> plan(List<PreProcessor> additional) {
        String reason = reasonForNone();
        if (reason == null) {
            try {
                ForwardPlan plan = choose(PreProcessors.byName(additional));
                describe(plan);
                return Optional.of(plan);
            } catch (ForwardPlanException refused) {
                if (isAskedFor) {
                    throw new PlanException(refused.getMessage());
                }
                reason = refused.getMessage();
            }
        }
        decisions.add(new Decision(
                "forward pass", false, "light from lamps that is refracted or mirrored onto surfaces", reason));
        if (forward.passes() > 1) {
            decisions.add(
                    new Decision("passes", false, "1 of " + forward.passes(), "there is no forward pass to repeat"));
        }
        return Optional.empty();
    }

    /** Null if there is to be a forward pass. */
    private String reasonForNone() {
        if (forward.preProcessor().equals(Settings.NONE) || maps.map() == MapName.NONE) {
            return "asked for none";
        }
        if (!traits.hasTransparency() && (traits.mirroring().isEmpty() || !forward.followsReflections())) {
            return "nothing refracts or mirrors";
        }
        if (ForwardPlanner.emitters(scene).isEmpty()) {
            return scene.lights().isEmpty() ? "there is no light" : "no light sends out light rays";
        }
        if (isAskedFor) {
            return null;
        }
        if (!settings.shader().equals(Settings.AUTO)) {
            return "a shader is asked for by name, and no map";
        }
        if (!traits.isDiffuse()) {
            return "nothing is diffuse, so light that lands cannot be seen";
        }
        if (traits.isStraight(forward)) {
            return "nothing bends light or mirrors it, so straight shadow rays are exact";
        }
        return traits.looksStraight(forward)
                ? "what is transparent turns light by less than a hundredth of a pixel, so straight shadow rays are as good"
                : null;
    }

    private ForwardPlan choose(Map<String, PreProcessor> known) {
        if (maps.map() != MapName.AUTO) {
            return planFor(maps.map(), known);
        }
        if (!mayBeMesh(known)) {
            return planFor(MapName.PHOTON_MAP, known);
        }
        ForwardPlan mesh;
        try {
            mesh = planFor(MapName.CAUSTIC_MESH, known);
        } catch (ForwardPlanException refused) {
            whyThisMap = refused.getMessage();
            return planFor(MapName.PHOTON_MAP, known);
        }
        double torn = MeshProspect.tornPart(mesh);
        if (MeshProspect.isTorn(torn)) {
            whyThisMap = String.format(
                    Locale.ROOT,
                    "%.0f %% of the light is torn apart too finely for cells, so photons do as well",
                    100 * torn);
            return planFor(MapName.PHOTON_MAP, known);
        }
        whyThisMap = String.format(
                Locale.ROOT,
                "cells between neighbouring rays have no noise and tell their error; %.1f %% of the light is too torn for them",
                100 * torn);
        return mesh;
    }

    /** Whether nothing that is asked for by name needs photons. */
    private boolean mayBeMesh(Map<String, PreProcessor> known) {
        String name = forward.preProcessor();
        if (maps.estimator() != EstimatorName.AUTO) {
            whyThisMap = "an estimator of photons is asked for";
            return false;
        }
        boolean hasNoCells = name.equals("random") || name.equals("monte-carlo") || !known.containsKey(name);
        if (!name.equals(Settings.AUTO) && hasNoCells) {
            whyThisMap = "preprocessor '" + name + "' sends no neighbouring rays, between which there could be cells";
            return false;
        }
        return true;
    }

    private ForwardPlan planFor(MapName map, Map<String, PreProcessor> known) {
        boolean isMesh = map == MapName.CAUSTIC_MESH;
        EstimatorName best = map == MapName.AMBIENT_MAPS ? EstimatorName.DENSITY : EstimatorName.NEAREST;
        EstimatorName estimator = maps.estimator() == EstimatorName.AUTO ? best : maps.estimator();
        long rays = forward.rays() > 0 ? forward.rays() : isMesh ? meshRays() : RAYS;
        // Cells need no rays but those that may find something, whatever the thesis did.
        Settings aimed = isMesh
                ? settings.toBuilder()
                        .forward(forward.toBuilder().aimAtSpecular(true).build())
                        .build()
                : settings;
        ForwardPlanner planner = new ForwardPlanner(scene, index, aimed);
        if (forward.preProcessor().equals(Settings.AUTO) && isMesh) {
            return planner.plan(known.get("own-map"), rays, map, estimator);
        }
        if (forward.preProcessor().equals(Settings.AUTO)) {
            try {
                return planner.plan(known.get("planar"), rays, map, estimator);
            } catch (ForwardPlanException lightAmongObjects) {
                return planner.plan(known.get("cube"), rays, map, estimator);
            }
        }
        PreProcessor asked = known.get(forward.preProcessor());
        if (asked == null) {
            throw new PlanException("unknown preprocessor '" + forward.preProcessor() + "'; known are auto, none, "
                    + String.join(", ", known.keySet()));
        }
        return planner.plan(asked, rays, map, estimator);
    }

    private long meshRays() {
        boolean isSoft = ForwardPlanner.emitters(scene).stream().allMatch(light -> light.sampleCount() > 1);
        return isSoft ? LAMP_MESH_RAYS : MESH_RAYS;
    }

    private void describe(ForwardPlan plan) {
        boolean isChosen = forward.preProcessor().equals(Settings.AUTO);
        String name = plan.preProcessor().name();
        String why = !isChosen
                ? "asked for"
                : name.equals("own-map")
                        ? "lattices that fit each object have the evenest cells"
                        : name.equals("planar")
                                ? "a lattice is smoother than random rays, and every light stands outside of what it is aimed at"
                                : "a lattice is smoother than random rays, and no plane stands before all that light is aimed at";
        boolean isAimed = forward.aimsAtSpecular() || plan.map() == MapName.CAUSTIC_MESH;
        decisions.add(new Decision("preprocessor", true, name + ", " + howMany(plan), why));
        decisions.add(new Decision(
                "emission windows",
                isAimed,
                isAimed ? aims(plan) : "windows around what refracts or mirrors",
                isAimed ? "only what refracts or mirrors needs light rays" : "asked for the whole scene"));
        if (plan.passes() > 1) {
            decisions.add(new Decision("passes", true, plan.passes() + " pictures, averaged", "asked for"));
        }
        boolean mapChosen = maps.map() == MapName.AUTO;
        boolean isMesh = plan.map() == MapName.CAUSTIC_MESH;
        String how = isMesh ? "" : ", " + plan.estimator().label();
        decisions.add(new Decision("map", true, plan.map().label() + how, mapChosen ? whyThisMap : "asked for"));
        if (!forward.followsReflections() && !traits.mirroring().isEmpty()) {
            decisions.add(new Decision(
                    "mirrored light",
                    false,
                    "what " + String.join(", ", traits.mirroring()) + " mirrors onto surfaces",
                    "light-reflections is off"));
        }
        List<String> dark = scene.lights().stream()
                .filter(light -> light.spread() == Light.Spread.NONE)
                .map(light -> "light " + (scene.lights().indexOf(light) + 1))
                .toList();
        if (!dark.isEmpty()) {
            decisions.add(new Decision(
                    "light rays", false, "rays of " + String.join(", ", dark), "it sends out no light rays"));
        }
    }

    /** How many rays, or what the settings say instead. */
    private String howMany(ForwardPlan plan) {
        String name = plan.preProcessor().name();
        if (forward.latticeSize() > 0 && !name.equals("random") && !name.equals("monte-carlo")) {
            return "lattices of " + forward.latticeSize() + " x " + forward.latticeSize();
        }
        if (forward.baseRays() > 0 && name.equals("monte-carlo")) {
            return forward.baseRays() + " light rays that look, and batches";
        }
        return plan.rays() + " light rays";
    }

    private static String aims(ForwardPlan plan) {
        return plan.beams().stream()
                .collect(Collectors.groupingBy(
                        Beam::aim, java.util.LinkedHashMap::new, Collectors.summingLong(Beam::rays)))
                .entrySet()
                .stream()
                .map(entry -> entry.getKey() + ": " + entry.getValue() + " rays")
                .collect(Collectors.joining("; "));
    }
}
