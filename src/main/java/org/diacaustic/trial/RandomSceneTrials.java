package org.diacaustic.trial;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.diacaustic.light.Falloff;
import org.diacaustic.render.Rendering;
import org.diacaustic.stability.Checks;
import org.diacaustic.stability.NumericCase;
import org.diacaustic.stability.Operations;
import org.diacaustic.stability.Values;

/** Scenes of chance, rendered at several scales. */
public final class RandomSceneTrials {
    private static final String OPERATION = "random_scene";
    private static final int PIXELS = 50;
    private static final long LIGHT_RAYS = 2500;

    private RandomSceneTrials() {}

    static void addTo(Operations operations) {
        operations.add(
                OPERATION,
                "Renders a scene of chance, of all shapes and media, at scale 1 and at powers of two, with one of six ways to"
                        + " trace light forward, lights without falloff: same bits, nothing infinite or not a number, and a ledger"
                        + " of light that closes, at every scale.",
                RandomSceneTrials::run);
    }

    /** Cases with the seeds 1 to {@code count}, of 5,000 rays each: 2,500 from the eye, 2,500 from lights. */
    public static List<NumericCase> cases(int count) {
        List<NumericCase> cases = new ArrayList<>();
        for (int seed = 1; seed <= count; seed++) {
            cases.add(new NumericCase(
                    "R-SCENE-" + seed,
                    "RANDOM",
                    "scene of chance " + seed + " at scales 2^-20, 1, 2^20",
                    OPERATION,
                    Values.of("inputs", Map.of("seed", seed, "log2_scales", List.of(-20, 20))),
                    Values.of("expected", Map.of("pixels_different", 0)),
                    Values.of("tolerance", Map.of("ledger_gap", 1e-12)),
                    List.of(),
                    ""));
        }
        return cases;
    }

    private static void run(NumericCase asked, Checks checks) {
        long seed = asked.inputs().integer("seed");
        double gap = asked.tolerance().number("ledger_gap", 1e-12);
        Way way = Way.of(seed);
        RandomScene scene = new RandomScene(seed, PIXELS, !way.needsEnds());
        Rendering home = render(scene, way, 1);
        check("1", home, gap, checks);
        for (double log2 : asked.inputs().numbers("log2_scales")) {
            String at = "2^" + (int) log2;
            Rendering scaled = render(scene, way, StrictMath.pow(2, log2));
            checks.same("pixels that differ at " + at, 0, Pictures.different(home.image(), scaled.image()));
            check(at, scaled, gap, checks);
        }
        checks.note(way.toString());
    }

    private static Rendering render(RandomScene scene, Way way, double scale) {
        return Pictures.render(scene.build(Placing.scaled(scale), new Falloff.None(), 1), way.settings(LIGHT_RAYS, 1));
    }

    private static void check(String at, Rendering rendering, double gap, Checks checks) {
        checks.holds("picture finite at " + at, Pictures.isFinite(rendering.image()));
        checks.same(
                "report of what is not finite at " + at,
                "",
                rendering.nonFiniteReport().orElse(""));
        checks.atMost(
                "gap of the ledger at " + at,
                gap,
                Pictures.gap(rendering.forward().ledger()));
    }
}
