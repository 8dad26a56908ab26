package org.diacaustic.reproduction;

import static org.diacaustic.reproduction.MapKind.AMBIENT_MAPS;
import static org.diacaustic.reproduction.MapKind.PHOTON_MAP;
import static org.diacaustic.reproduction.Method.ADAPTIVE;
import static org.diacaustic.reproduction.Method.CUBE;
import static org.diacaustic.reproduction.Method.MONTE_CARLO;
import static org.diacaustic.reproduction.Method.NON_TRANSPARENT;
import static org.diacaustic.reproduction.Method.PLANAR;
import static org.diacaustic.reproduction.ThesisScene.COMPLEX;
import static org.diacaustic.reproduction.ThesisScene.CONTROL;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * What holds among the thesis' own numbers without exception, and numbers that follow from lattices alone: these leave no
 * room for chance or fitting, and must be found again to the digit.
 */
final class Identities {
    private final Results results;
    private final List<Identity> found = new ArrayList<>();

    private Identities(Results results) {
        this.results = results;
    }

    static List<Identity> check(Results results) {
        Identities identities = new Identities(results);
        for (ThesisScene scene : results.scenes()) {
            if (scene != COMPLEX) {
                identities.checkLattices(scene);
            }
            identities.checkSums(scene);
            identities.checkShadows(scene);
        }
        return List.copyOf(identities.found);
    }

    /** Diamonds on lattices: a count of points. */
    private void checkLattices(ThesisScene scene) {
        add(scene, PLANAR, PHOTON_MAP, Quantity.PRIMARY_RAYS, 421 * 421);
        add(scene, PLANAR, PHOTON_MAP, Quantity.STORED, 22_260);
        add(scene, PLANAR, AMBIENT_MAPS, Quantity.STORED, 17_290);
        if (scene == CONTROL) {
            add(scene, CUBE, PHOTON_MAP, Quantity.PRIMARY_RAYS, 6 * 447 * 447);
            add(scene, CUBE, PHOTON_MAP, Quantity.PRIMARY_HITS, 1_012);
            add(scene, CUBE, PHOTON_MAP, Quantity.STORED, 264);
        }
    }

    private void add(ThesisScene scene, Method method, MapKind map, Quantity quantity, long expected) {
        Outcome outcome = results.get(scene, method, map);
        found.add(new Identity(
                outcome.experiment() + ": " + quantity.title().toLowerCase(Locale.ROOT),
                count(expected),
                count(outcome.mean(quantity))));
    }

    /** What every row of the tables of pre-processing obeys. */
    private void checkSums(ThesisScene scene) {
        int rows = 0;
        int rays = 0;
        int tests = 0;
        int hits = 0;
        int opened = 0;
        int batches = 0;
        int batched = 0;
        for (Outcome outcome : results.all()) {
            if (outcome.experiment().scene() != scene
                    || outcome.experiment().method().isShadingModel()) {
                continue;
            }
            for (int run = 0; run < outcome.statistic(Quantity.STORED).count(); run++) {
                rows++;
                rays += value(outcome, Quantity.RAYS_TRACED, run)
                                == value(outcome, Quantity.PRIMARY_RAYS, run) + value(outcome, Quantity.STORED, run)
                        ? 1
                        : 0;
                tests += value(outcome, Quantity.LIGHT_TESTS, run) == 3 * value(outcome, Quantity.RAYS_TRACED, run)
                        ? 1
                        : 0;
                hits += value(outcome, Quantity.LIGHT_HITS, run)
                                == value(outcome, Quantity.PRIMARY_HITS, run) + value(outcome, Quantity.STORED, run)
                        ? 1
                        : 0;
                double beyond =
                        value(outcome, Quantity.LIGHT_TESTS, run) - 16 * value(outcome, Quantity.RAYS_TRACED, run);
                opened += beyond >= 0 && beyond % 6 == 0 ? 1 : 0;
                if (outcome.experiment().method() == MONTE_CARLO) {
                    batched++;
                    batches += value(outcome, Quantity.PRIMARY_RAYS, run) % 1000 == 0 ? 1 : 0;
                }
            }
        }
        if (scene == COMPLEX) {
            addRuns(
                    scene,
                    "tests = 16 × rays traced, and 6 for each volume of the fractal that is opened",
                    rows,
                    opened);
        } else {
            addRuns(scene, "rays traced = primary rays + stored", rows, rays);
            addRuns(scene, "tests = 3 × rays traced", rows, tests);
            addRuns(scene, "rays that hit = primary hits + stored", rows, hits);
        }
        addRuns(scene, "Monte-Carlo primary rays are whole batches of 1,000", batched, batches);
    }

    private void addRuns(ThesisScene scene, String claim, int runs, int holding) {
        found.add(new Identity(
                scene.key() + ": " + claim, runs + " of " + runs + " runs", holding + " of " + runs + " runs"));
    }

    /** A shadow ray for every light at every hit; every hit is also a lookup in a photon map. */
    private void checkShadows(ThesisScene scene) {
        double hits = results.get(scene, ADAPTIVE, PHOTON_MAP).mean(Quantity.LOOKUPS);
        int lights = scene.read().scene().lights().size();
        found.add(new Identity(
                scene.key() + ": shadow rays = lights × hits",
                count(lights * hits),
                count(results.get(scene, NON_TRANSPARENT, MapKind.NONE).mean(Quantity.SHADOW_RAYS))));
    }

    private static double value(Outcome outcome, Quantity quantity, int run) {
        return outcome.statistic(quantity).values().get(run);
    }

    private static String count(double value) {
        return String.format(Locale.ROOT, "%,.0f", value);
    }
}
