package org.diacaustic.reproduction;

import static org.diacaustic.reproduction.MapKind.AMBIENT_MAPS;
import static org.diacaustic.reproduction.MapKind.NONE;
import static org.diacaustic.reproduction.MapKind.PHOTON_MAP;
import static org.diacaustic.reproduction.Method.ADAPTIVE;
import static org.diacaustic.reproduction.Method.CUBE;
import static org.diacaustic.reproduction.Method.MONTE_CARLO;
import static org.diacaustic.reproduction.Method.NON_REFRACTIVE;
import static org.diacaustic.reproduction.Method.NON_TRANSPARENT;
import static org.diacaustic.reproduction.Method.PLANAR;
import static org.diacaustic.reproduction.Method.RANDOM;
import static org.diacaustic.reproduction.Quantity.BALANCED_NODES;
import static org.diacaustic.reproduction.Quantity.EYE_TESTS;
import static org.diacaustic.reproduction.Quantity.FOREIGN_PHOTONS;
import static org.diacaustic.reproduction.Quantity.INSERTION_STEPS;
import static org.diacaustic.reproduction.Quantity.LIGHT_TESTS;
import static org.diacaustic.reproduction.Quantity.MOST_NODES;
import static org.diacaustic.reproduction.Quantity.NODES_EXAMINED;
import static org.diacaustic.reproduction.Quantity.PERCENT_INTERSECTING;
import static org.diacaustic.reproduction.Quantity.PERCENT_STORED;
import static org.diacaustic.reproduction.Quantity.PHOTONS_USED;
import static org.diacaustic.reproduction.Quantity.PREPROCESSING_SECONDS;
import static org.diacaustic.reproduction.Quantity.RAYS_TRACED;
import static org.diacaustic.reproduction.Quantity.STORED;
import static org.diacaustic.reproduction.Quantity.TREE_HEIGHT;
import static org.diacaustic.reproduction.ThesisScene.COMPLEX;
import static org.diacaustic.reproduction.ThesisScene.CONTROL;
import static org.diacaustic.reproduction.ThesisScene.REFRACTION;

import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import org.diacaustic.reproduction.Statement.Answer;

/** What the thesis concludes from its tables and pictures, to be concluded again from ours. */
final class Statements {
    /** A technique that stores less than this part of what planar interpolation stores, ray for ray, is of no use. */
    private static final double USELESS = 0.01;

    private Statements() {}

    static List<Verdict> judge(Results results) {
        return all().stream().map(statement -> statement.judge(results)).toList();
    }

    private static List<Statement> all() {
        return List.of(
                statement(
                        1,
                        "Both shading models cost the same in the control and the refraction scene.",
                        "5.3, 5.4",
                        Set.of(CONTROL, REFRACTION),
                        Statements::shadingCostsTheSame),
                statement(
                        2,
                        "In the complex scene non-transparent shading is cheaper, by 31,336 tests or 1.4 %.",
                        "5.5",
                        Set.of(COMPLEX),
                        Statements::shadingCostsDiffer),
                statement(
                        3,
                        "A million completely random rays, or rays of a plain cube lattice, are no reasonable pre-processor.",
                        "5.3",
                        Set.of(CONTROL),
                        Statements::plainRaysAreUseless),
                statement(
                        4,
                        "Planar interpolation is the cheapest way to fill individual ambient maps.",
                        "5.3 - 5.5, 6.1",
                        Set.of(CONTROL, REFRACTION, COMPLEX),
                        Statements::planarIsCheapest),
                statement(
                        5,
                        "Monte-Carlo rays over-sample a global map and spoil its picture; initial-hit maps prevent it.",
                        "5.3, 5.4",
                        Set.of(CONTROL),
                        Statements::monteCarloOversamples),
                statement(
                        6,
                        "Adaptive rays into a global map make the best picture.",
                        "6.3, 6.4",
                        Set.of(CONTROL),
                        Statements::adaptiveIsBest),
                statement(
                        7,
                        "In the complex scene Monte-Carlo takes about twice, adaptive about six times as long as planar.",
                        "5.5",
                        Set.of(COMPLEX),
                        Statements::timesInTheComplexScene),
                statement(
                        8,
                        "With individual maps adaptive stores a little more than planar, for three times the rays.",
                        "5.5",
                        Set.of(COMPLEX),
                        Statements::adaptiveStoresLittleMore),
                statement(
                        9,
                        "A Monte-Carlo map is cheaper to read than a planar one of about its size; balanced, much less so.",
                        "5.3",
                        Set.of(CONTROL),
                        Statements::randomOrderBalances),
                statement(
                        10,
                        "In the complex scene the three methods hit and store about equally well.",
                        "5.5",
                        Set.of(COMPLEX),
                        Statements::equallyEfficient),
                statement(
                        11,
                        "Non-transparent shading leaves the complex scene completely black.",
                        "5.5",
                        Set.of(COMPLEX),
                        Statements::complexIsBlack),
                statement(
                        12,
                        "Individual maps look blocky when the camera is near.",
                        "5.5, 6.1, 6.3",
                        Set.of(COMPLEX),
                        Statements::mapsAreBlocky),
                statement(
                        13,
                        "Photons that landed on one surface are taken for the light of another.",
                        "4.8",
                        Set.of(COMPLEX),
                        Statements::photonsAreForeign),
                statement(
                        14,
                        "Inserting a photon costs between log2 N and N steps, a retrieval at most N nodes.",
                        "4.8",
                        Set.of(CONTROL),
                        Statements::treeIsWithinBounds));
    }

    private static Statement statement(
            int number, String claim, String section, Set<ThesisScene> scenes, Function<Results, Answer> test) {
        return new Statement(number, claim, section, scenes, test);
    }

    private static Answer shadingCostsTheSame(Results results) {
        boolean same = true;
        StringBuilder evidence = new StringBuilder();
        for (ThesisScene scene : List.of(CONTROL, REFRACTION)) {
            double opaque = results.get(scene, NON_TRANSPARENT, NONE).mean(EYE_TESTS);
            double filtered = results.get(scene, NON_REFRACTIVE, NONE).mean(EYE_TESTS);
            same &= opaque == filtered;
            evidence.append(evidence.isEmpty() ? "" : "; ")
                    .append(text("%s: %,.0f and %,.0f tests", scene.key(), opaque, filtered));
        }
        return new Answer(same, evidence.toString());
    }

    private static Answer shadingCostsDiffer(Results results) {
        double opaque = results.get(COMPLEX, NON_TRANSPARENT, NONE).mean(EYE_TESTS);
        double filtered = results.get(COMPLEX, NON_REFRACTIVE, NONE).mean(EYE_TESTS);
        double more = filtered - opaque;
        return new Answer(more > 0, text("%,.0f tests fewer, %.1f %%", more, 100 * more / opaque));
    }

    private static Answer plainRaysAreUseless(Results results) {
        double planar = results.get(CONTROL, PLANAR, PHOTON_MAP).mean(PERCENT_STORED);
        double random = results.get(CONTROL, RANDOM, PHOTON_MAP).mean(PERCENT_STORED);
        double cube = results.get(CONTROL, CUBE, PHOTON_MAP).mean(PERCENT_STORED);
        return new Answer(
                Math.max(random, cube) < USELESS * planar,
                text(
                        "of random rays %.2f %% are stored, of the cube's %.2f %%, of planar %.2f %%",
                        random, cube, planar));
    }

    private static Answer planarIsCheapest(Results results) {
        boolean cheapest = true;
        StringBuilder evidence = new StringBuilder();
        for (ThesisScene scene : ThesisScene.values()) {
            double planar = testsPerLightValue(results.get(scene, PLANAR, AMBIENT_MAPS));
            double next = DoubleStream.of(
                            testsPerLightValue(results.get(scene, MONTE_CARLO, AMBIENT_MAPS)),
                            testsPerLightValue(results.get(scene, ADAPTIVE, AMBIENT_MAPS)))
                    .min()
                    .orElseThrow();
            cheapest &= planar < next;
            evidence.append(evidence.isEmpty() ? "" : "; ")
                    .append(text("%s: %.0f tests a value, the next best %.0f", scene.key(), planar, next));
        }
        return new Answer(cheapest, evidence.toString());
    }

    private static double testsPerLightValue(Outcome outcome) {
        return outcome.mean(LIGHT_TESTS) / outcome.mean(STORED);
    }

    private static Answer monteCarloOversamples(Results results) {
        Pictures pictures = new Pictures(results);
        double global = pictures.error(CONTROL, MONTE_CARLO, PHOTON_MAP);
        double individual = pictures.error(CONTROL, MONTE_CARLO, AMBIENT_MAPS);
        double planar = pictures.error(CONTROL, PLANAR, PHOTON_MAP);
        return new Answer(
                global > individual && global > planar,
                text(
                        "error of the picture %.1f %% with the global map, %.1f %% with individual ones; planar, global: %.1f %%",
                        100 * global, 100 * individual, 100 * planar));
    }

    private static Answer adaptiveIsBest(Results results) {
        Pictures pictures = new Pictures(results);
        double adaptive = pictures.error(CONTROL, ADAPTIVE, PHOTON_MAP);
        Outcome best = pictures.best(CONTROL);
        return new Answer(
                best.experiment().equals(new Experiment(CONTROL, ADAPTIVE, PHOTON_MAP)),
                text(
                        "error of its picture %.1f %%; the best has %.1f %%: %s",
                        100 * adaptive,
                        100 * pictures.error(best),
                        best.experiment().title().toLowerCase(Locale.ROOT)));
    }

    private static Answer timesInTheComplexScene(Results results) {
        Outcome planar = results.get(COMPLEX, PLANAR, PHOTON_MAP);
        Outcome monteCarlo = results.get(COMPLEX, MONTE_CARLO, PHOTON_MAP);
        Outcome adaptive = results.get(COMPLEX, ADAPTIVE, PHOTON_MAP);
        double twice = monteCarlo.mean(PREPROCESSING_SECONDS) / planar.mean(PREPROCESSING_SECONDS);
        double sixTimes = adaptive.mean(PREPROCESSING_SECONDS) / planar.mean(PREPROCESSING_SECONDS);
        return new Answer(
                Math.rint(twice) == 2 && Math.rint(sixTimes) == 6,
                text(
                        "%.1f and %.1f times as long, on one thread of this machine; %.1f and %.1f times as many rays,"
                                + " %.1f and %.1f times as many steps of insertion into the tree",
                        twice,
                        sixTimes,
                        monteCarlo.mean(RAYS_TRACED) / planar.mean(RAYS_TRACED),
                        adaptive.mean(RAYS_TRACED) / planar.mean(RAYS_TRACED),
                        monteCarlo.mean(INSERTION_STEPS) / planar.mean(INSERTION_STEPS),
                        adaptive.mean(INSERTION_STEPS) / planar.mean(INSERTION_STEPS)));
    }

    private static Answer adaptiveStoresLittleMore(Results results) {
        Outcome planar = results.get(COMPLEX, PLANAR, AMBIENT_MAPS);
        Outcome adaptive = results.get(COMPLEX, ADAPTIVE, AMBIENT_MAPS);
        double stored = adaptive.mean(STORED) / planar.mean(STORED);
        double rays = adaptive.mean(RAYS_TRACED) / planar.mean(RAYS_TRACED);
        return new Answer(
                stored > 1 && stored < 1.5 && Math.rint(rays) == 3,
                text("stores %.2f times as much with %.2f times the rays", stored, rays));
    }

    private static Answer randomOrderBalances(Results results) {
        double inserted = costRatio(results, NODES_EXAMINED);
        double balanced = costRatio(results, BALANCED_NODES);
        return new Answer(
                inserted > 1 && Math.abs(Math.log(balanced)) < Math.log(inserted),
                text(
                        "for each photon used, planar examines %.1f times the nodes of Monte-Carlo; in balanced trees %.1f times",
                        inserted, balanced));
    }

    /** Nodes for each photon used: of the planar map, over that of the Monte-Carlo map. */
    private static double costRatio(Results results, Quantity nodes) {
        Outcome planar = results.get(CONTROL, PLANAR, PHOTON_MAP);
        Outcome monteCarlo = results.get(CONTROL, MONTE_CARLO, PHOTON_MAP);
        return planar.mean(nodes)
                / planar.mean(PHOTONS_USED)
                / (monteCarlo.mean(nodes) / monteCarlo.mean(PHOTONS_USED));
    }

    private static Answer equallyEfficient(Results results) {
        List<Outcome> all = results.of(COMPLEX, PHOTON_MAP);
        double spread = Math.max(spread(all, PERCENT_INTERSECTING), spread(all, PERCENT_STORED));
        return new Answer(
                spread < 1.2,
                all.stream()
                        .map(outcome -> text(
                                "%s: %.0f %% hit, %.0f %% stored",
                                outcome.experiment().method().key(),
                                outcome.mean(PERCENT_INTERSECTING),
                                outcome.mean(PERCENT_STORED)))
                        .collect(Collectors.joining("; ")));
    }

    private static double spread(List<Outcome> outcomes, Quantity quantity) {
        double largest =
                outcomes.stream().mapToDouble(o -> o.mean(quantity)).max().orElseThrow();
        double least =
                outcomes.stream().mapToDouble(o -> o.mean(quantity)).min().orElseThrow();
        return largest / least;
    }

    private static Answer complexIsBlack(Results results) {
        double brightest =
                Pictures.brightest(results.get(COMPLEX, NON_TRANSPARENT, NONE).picture());
        return new Answer(brightest == 0, text("its brightest pixel is %.3g", brightest));
    }

    private static Answer mapsAreBlocky(Results results) {
        double individual =
                Pictures.flatness(results.get(COMPLEX, PLANAR, AMBIENT_MAPS).picture());
        double global =
                Pictures.flatness(results.get(COMPLEX, PLANAR, PHOTON_MAP).picture());
        return new Answer(
                individual > 2 * global,
                text(
                        "of neighbouring lit pixels %.0f %% show the very same light with individual maps, %.0f %% with a global map",
                        100 * individual, 100 * global));
    }

    private static Answer photonsAreForeign(Results results) {
        Outcome planar = results.get(COMPLEX, PLANAR, PHOTON_MAP);
        double foreign = planar.mean(FOREIGN_PHOTONS);
        return new Answer(
                foreign > 0,
                text(
                        "%,.0f of %,.0f photons used lie on another object or side than the point they are used for",
                        foreign, planar.mean(PHOTONS_USED)));
    }

    private static Answer treeIsWithinBounds(Results results) {
        boolean within = true;
        StringBuilder evidence = new StringBuilder();
        for (Outcome outcome : results.of(CONTROL, PHOTON_MAP)) {
            double photons = outcome.mean(STORED);
            double height = outcome.mean(TREE_HEIGHT);
            double nodes = outcome.mean(MOST_NODES);
            within &= height >= Math.log(photons) / Math.log(2) && height <= photons && nodes <= photons;
            evidence.append(evidence.isEmpty() ? "" : "; ")
                    .append(text(
                            "%s: %,.0f photons, height %.0f, most nodes %,.0f",
                            outcome.experiment().method().key(), photons, height, nodes));
        }
        return new Answer(within, evidence.toString());
    }

    private static String text(String format, Object... values) {
        return String.format(Locale.ROOT, format, values);
    }
}
