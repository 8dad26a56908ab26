package org.diacaustic.trial;

import java.math.BigDecimal;
import org.diacaustic.math.Vector3;
import org.diacaustic.scene.Scene;
import org.diacaustic.shape.Box;
import org.diacaustic.stability.CaseFault;
import org.diacaustic.stability.Checks;
import org.diacaustic.stability.NumericCase;
import org.diacaustic.stability.Operations;

/** Rays that go on and on. */
final class WalkTrials {
    /** Where in a unit cube a ray begins that goes on for long: on none of its planes of symmetry. */
    private static final Vector3 INSIDE = new Vector3(0.137, -0.291, 0.053);

    private WalkTrials() {}

    static void addTo(Operations operations) {
        operations.add(
                "facing_mirrors",
                "The light walk between two mirrors, from midway, with max-depth = bounces: the weights at all its visits, summed; the"
                        + " weight at the last one, of which what is mirrored is booked as cut; and whether the ray still is where it"
                        + " was beside, to the bit.",
                WalkTrials::mirrors);
        operations.add(
                "trapped_ray",
                "The light walk in a cube of glass, from a point beside its planes of symmetry: the smallest angle of incidence of all"
                        + " bounces, whether all of them were total, and what was cut after the last.",
                WalkTrials::trapped);
    }

    private static void mirrors(NumericCase asked, Checks checks) {
        double reflectance = asked.inputs().number("reflectance");
        int bounces = depth(asked, "bounces");
        double gap = asked.inputs().number("gap");
        Scene scene = Scene.builder()
                .camera(OpticalScenes.above(0, 0.5 * gap, 0))
                .object("lower", OpticalScenes.level(0), OpticalScenes.mirror(reflectance))
                .object("upper", OpticalScenes.level(gap), OpticalScenes.mirror(reflectance))
                .build();
        Vector3 start = new Vector3(0.3 * gap, 0.5 * gap, -0.7 * gap);
        RayWalk walk =
                RayWalk.in(scene, OpticalScenes.settings(bounces, true, true)).follow(start, Vector3.UNIT_Y);
        double residual = walk.deepest() == bounces ? walk.arriving() : 0;
        checks.number("sum_of_visits", walk.visited(), "");
        checks.number("residual_weight", residual, "");
        checks.number("cut", residual * reflectance, walk.cut(), 1e-15 * residual);
        checks.holds("all numbers", !walk.isSpoiled());
        checks.same("ray_height_drift", 0.0, drift(walk, start));
        checks.same("stack_overflow", asked.expected().flag("stack_overflow"), false);
        checks.note("the sum up to the depth, and what is left");
    }

    /** How far beside its start the last leg is, and how far from upright. */
    private static double drift(RayWalk walk, Vector3 start) {
        return Math.abs(walk.origin().x() - start.x())
                + Math.abs(walk.origin().z() - start.z())
                + Math.abs(walk.direction().x())
                + Math.abs(walk.direction().z());
    }

    private static int depth(NumericCase asked, String key) {
        long depth = asked.inputs().integer(key);
        if (depth < 0 || depth > Integer.MAX_VALUE) {
            throw new CaseFault(key + " should be from 0 to " + Integer.MAX_VALUE + ", but is " + depth);
        }
        return (int) depth;
    }

    private static void trapped(NumericCase asked, Checks checks) {
        double[] towards = asked.inputs().vector("dir");
        int depth = depth(asked, "max_depth");
        Scene scene = Scene.builder()
                .camera(OpticalScenes.above(0, 3, 0))
                .object(
                        "cube",
                        new Box(new Vector3(-0.5, -0.5, -0.5), new Vector3(0.5, 0.5, 0.5)),
                        OpticalScenes.clear(asked.inputs().number("n")))
                .build();
        RayWalk walk = RayWalk.in(scene, OpticalScenes.settings(depth, true, true))
                .follow(INSIDE, new Vector3(towards[0], towards[1], towards[2]));
        checks.number("incidence_deg", walk.smallestIncidence(), "");
        if (asked.expected().isDecimal("critical_deg")) {
            BigDecimal critical = asked.expected().decimal("critical_deg");
            checks.number(
                    "critical_deg", critical, criticalDegrees(asked.inputs().number("n")), "");
        }
        checks.same(
                "TIR_every_bounce",
                asked.expected().flag("TIR_every_bounce"),
                walk.totalReflections() == walk.visits());
        checks.number("weight_after_max_depth", walk.cut(), "");
        checks.holds("all numbers", !walk.isSpoiled());
        checks.number("cut and escaped", 1, walk.cut() + walk.escaped(), 1e-12);
        if (asked.expected().flag("TIR_every_bounce")) {
            checks.same("bounces", depth + 1L, walk.visits());
        }
        checks.note("what is left is booked as cut, which is what truncated means here");
    }

    /** The angle from which on the walk mirrors all light back from a flat surface to empty space; 90° if there is none. */
    static double criticalDegrees(double n) {
        Scene scene = Scene.builder()
                .camera(OpticalScenes.above(0, 3, 0))
                .object("surface", OpticalScenes.level(0), OpticalScenes.clear(n))
                .build();
        return StrictMath.toDegrees(StrictMath.atan(ImageTrials.criticalTangent(scene, 1)));
    }
}
