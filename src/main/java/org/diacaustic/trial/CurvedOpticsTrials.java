package org.diacaustic.trial;

import java.math.BigDecimal;
import java.util.Arrays;
import java.util.List;
import org.diacaustic.light.Light;
import org.diacaustic.material.Material;
import org.diacaustic.material.Medium;
import org.diacaustic.material.Wave;
import org.diacaustic.math.Color;
import org.diacaustic.math.Vector3;
import org.diacaustic.scene.Camera;
import org.diacaustic.scene.Scene;
import org.diacaustic.shape.Frustum;
import org.diacaustic.shape.Shape;
import org.diacaustic.shape.Sphere;
import org.diacaustic.stability.Checks;
import org.diacaustic.stability.NumericCase;
import org.diacaustic.stability.Operations;
import org.diacaustic.stability.Values;

/** Parallel light focused by balls, cylinders, mirrors and waves. */
final class CurvedOpticsTrials {
    /** How far from the axis near-axial rays go, in radii: between curvature, which is extrapolated, and rounding. */
    private static final double NEAR_AXIS = 0x1p-12;

    private static final int LIMIT_RAYS = 9;

    /** What the caustic mesh finds of irradiance, relative. */
    private static final double EXACT = 1e-10;

    private CurvedOpticsTrials() {}

    static void addTo(Operations operations) {
        operations.add(
                "sphere_focus",
                "The light walk through a ball, without Fresnel: where the line of the ray that comes out meets the axis. Which way"
                        + " the ray at h = R comes out no number can tell, for it comes to the critical angle: it is the limit of rays"
                        + " beside it. The"
                        + " paraxial focus is that of two rays near the axis, extrapolated.",
                CurvedOpticsTrials::sphereFocus);
        operations.add(
                "sphere_gain",
                "The caustic mesh of a ball in parallel light of irradiance 1, asked at the points, within 1e-10, with and without"
                        + " Fresnel; photons of 16 runs, the mesh telling how disc and point differ. Light is refracted twice, and"
                        + " not mirrored.",
                (asked, checks) -> gain(asked, checks, false));
        operations.add(
                "cylinder_gain",
                "As sphere_gain and sphere_focus, of a cylinder that lies across the light.",
                (asked, checks) -> {
                    double radius = asked.inputs().number("R");
                    RayWalk walk = walk(cylinder(radius), asked.inputs().number("n"), radius);
                    double cusp = asked.expected().number("cusp_from_centre");
                    checks.size(radius)
                            .number("cusp_from_centre", cusp, paraxial(walk, radius), EXACT * Math.abs(cusp));
                    gain(asked, checks, true);
                });
        operations.add(
                "mirror_caustic",
                "The light walk to the wall of a mirroring cylinder, from the middle of it: where the line of the mirrored ray meets"
                        + " the axis.",
                CurvedOpticsTrials::mirror);
        operations.add(
                "wave_caustic",
                "The caustic mesh of bumped flat water in parallel light of irradiance 1, asked under crest and trough, within 1e-10;"
                        + " with Fresnel too, whose factor at the crest is the ratio of both; the light walk beside a crest, for the"
                        + " cusp, within 1e-9; photons of 16 runs, the mesh telling how disc and point differ.",
                CurvedOpticsTrials::wave);
    }

    private static void sphereFocus(NumericCase asked, Checks checks) {
        double radius = asked.inputs().number("R");
        RayWalk walk = walk(new Sphere(Vector3.ZERO, radius), asked.inputs().number("n"), radius);
        checks.size(radius);
        double paraxial = paraxial(walk, radius);
        checks.number("paraxial_from_centre", paraxial, "");
        checks.number("paraxial_from_back_surface", paraxial - radius, "");
        double[] asides = asked.inputs().numbers("h");
        List<BigDecimal> expected = asked.expected().decimals("crossing_from_centre");
        for (int i = 0; i < asides.length; i++) {
            double aside = Math.abs(asides[i]);
            double crossing = aside == 0
                    ? paraxial
                    : aside == radius ? marginal(walk, radius) : crossing(walk, asides[i], radius);
            checks.number(
                    "crossing_from_centre[" + i + "]",
                    expected.get(i).doubleValue(),
                    crossing,
                    relative(asked, asides[i]) * expected.get(i).abs().doubleValue());
        }
    }

    /** The relative tolerance of a ray: that of a key such as {@code h=1e-6}, if there is one for it, else that of all. */
    private static double relative(NumericCase asked, double aside) {
        Values tolerance = asked.tolerance();
        for (String key : tolerance.keys()) {
            if (key.startsWith("h=") && Double.parseDouble(key.substring(2)) == aside) {
                return Double.parseDouble(tolerance.text(key).replaceFirst("rel\\s*", ""));
            }
        }
        return tolerance.number("rel");
    }

    /** A walk through an element about the middle, with all light refracted. */
    private static RayWalk walk(Shape shape, double n, double radius) {
        Scene scene = Scene.builder()
                .camera(OpticalScenes.above(0, 3 * radius, 0))
                .object("element", shape, OpticalScenes.clear(n))
                .build();
        return RayWalk.in(scene, OpticalScenes.through(2, false));
    }

    private static Frustum cylinder(double radius) {
        return Frustum.cylinder(new Vector3(0, 0, -2 * radius), new Vector3(0, 0, 2 * radius), radius, true);
    }

    /** How far below the middle the ray that comes down beside the axis meets it; not a number if it does not go through. */
    private static double crossing(RayWalk walk, double aside, double radius) {
        walk.follow(new Vector3(aside, 2 * radius, 0), Vector3.UNIT_Y.negated());
        return walk.deepest() == 1 && walk.escaped() > 0 ? -walk.crossing() : Double.NaN;
    }

    /** The limit at the axis: crossings of two rays differ from it by the square of what they are off. */
    private static double paraxial(RayWalk walk, double radius) {
        double near = crossing(walk, NEAR_AXIS * radius, radius);
        double far = crossing(walk, 2 * NEAR_AXIS * radius, radius);
        return near - (far - near) / 3;
    }

    /** The limit at the rim: a smooth function of the cosine of incidence. */
    private static double marginal(RayWalk walk, double radius) {
        double[] table = new double[LIMIT_RAYS];
        for (int i = 0; i < LIMIT_RAYS; i++) {
            double cosine = Math.scalb(1, -2 - i);
            table[i] = crossing(walk, radius * Math.sqrt((1 - cosine) * (1 + cosine)), radius);
            for (int j = i - 1; j >= 0; j--) {
                table[j] = table[j + 1] + (table[j + 1] - table[j]) / (Math.scalb(1, i - j) - 1);
            }
        }
        return table[0];
    }

    private static void gain(NumericCase asked, Checks checks, boolean isCylinder) {
        double radius = asked.inputs().number("R");
        double distance = asked.inputs().number("plane_from_centre");
        Shape shape = isCylinder ? cylinder(radius) : new Sphere(Vector3.ZERO, radius);
        Camera camera = OpticalScenes.above(0, 3 * radius, -distance);
        Scene scene = OpticalScenes.overFloor(
                camera,
                OpticalScenes.sun(),
                -distance,
                shape,
                OpticalScenes.clear(asked.inputs().number("n")));
        List<Values> points = asked.expected().records("points");
        for (boolean fresnel : new boolean[] {false, true}) {
            String name = fresnel ? "gain_fresnel" : "gain_no_fresnel";
            List<Values> said = points.stream().filter(point -> point.has(name)).toList();
            if (said.isEmpty()) {
                continue;
            }
            double[] places =
                    said.stream().mapToDouble(point -> point.number("rho")).toArray();
            double[] expected =
                    said.stream().mapToDouble(point -> point.number(name)).toArray();
            ExactLight light = ExactLight.of(scene, OpticalScenes.through(2, fresnel), -distance, "cube");
            for (int i = 0; i < places.length; i++) {
                checks.number(
                        name + " at " + places[i], expected[i], light.at(places[i], 0), EXACT * Math.abs(expected[i]));
            }
            light.checkPhotons(checks, "photons, " + name, 0.05 * radius, places, expected);
        }
    }

    private static void mirror(NumericCase asked, Checks checks) {
        double radius = asked.inputs().number("R");
        Scene scene = Scene.builder()
                .camera(OpticalScenes.above(0, 3 * radius, 0))
                .object("wall", cylinder(radius), OpticalScenes.mirror(1))
                .build();
        RayWalk walk = RayWalk.in(scene, OpticalScenes.settings(1, true, false));
        double near = mirrored(walk, NEAR_AXIS, radius);
        double paraxial = near - (mirrored(walk, 2 * NEAR_AXIS, radius) - near) / 3;
        checks.size(radius).number("cusp_from_centre", paraxial, "");
        double[] crossings = Arrays.stream(asked.inputs().numbers("h_over_R"))
                .map(aside -> aside == 0 ? paraxial : mirrored(walk, aside, radius))
                .toArray();
        checks.numbers("crossing_from_centre", crossings, "");
    }

    /** Where a ray that goes down beside the axis of a hollow cylinder meets it, mirrored; endless if it grazes the wall. */
    private static double mirrored(RayWalk walk, double asideOfRadius, double radius) {
        walk.follow(new Vector3(asideOfRadius * radius, 0, 0), Vector3.UNIT_Y.negated());
        return walk.visits() == 0 || walk.direction().x() == 0 ? Double.POSITIVE_INFINITY : -walk.crossing();
    }

    private static void wave(NumericCase asked, Checks checks) {
        double height = asked.inputs().number("A");
        double waveNumber = asked.inputs().number("k");
        double depth = asked.inputs().number("depth");
        Material water = Material.builder()
                .transparency(Color.WHITE)
                .inside(Medium.of(asked.inputs().number("n")))
                .bump(new Wave(Vector3.UNIT_X, waveNumber, height, 0))
                .build();
        double length = 2 * Math.PI / waveNumber;
        double crest = 0.25 * length;
        Light sun = OpticalScenes.sun();
        Scene scene = OpticalScenes.overFloor(
                OpticalScenes.above(0, -0.5 * depth, -depth), sun, -depth, OpticalScenes.square(0, length), water);
        double cusp = asked.expected().number("cusp_depth");
        checks.size(depth).number("cusp_depth", cusp, cusp(scene, crest, waveNumber), 1e-9 * Math.abs(cusp));
        double[] places = {crest, -crest};
        double[] expected = {
            asked.expected().number("E_under_crest"), asked.expected().number("E_under_trough")
        };
        ExactLight light = ExactLight.of(scene, OpticalScenes.through(1, false), -depth, "own-map");
        double underCrest = light.at(crest, 0);
        checks.number("E_under_crest", expected[0], underCrest, EXACT * expected[0]);
        checks.number("E_under_trough", expected[1], light.at(-crest, 0), EXACT * expected[1]);
        light.checkPhotons(checks, "photons", 0.08 * length, places, expected);
        ExactLight weakened = ExactLight.of(scene, OpticalScenes.through(1, true), -depth, "own-map");
        double factor = asked.expected().number("Fresnel_factor_at_crest");
        checks.number("Fresnel_factor_at_crest", factor, weakened.at(crest, 0) / underCrest, EXACT);
        weakened.checkPhotons(
                checks, "photons with Fresnel", 0.08 * length, new double[] {crest}, new double[] {expected[0] * factor
                });
    }

    /** How deep below a crest the rays on both sides of it meet, in the limit; endless if they are parallel. */
    private static double cusp(Scene scene, double crest, double waveNumber) {
        RayWalk walk = RayWalk.in(scene, OpticalScenes.through(1, false));
        double near = beside(walk, crest, NEAR_AXIS / waveNumber);
        double far = beside(walk, crest, 2 * NEAR_AXIS / waveNumber);
        return Double.isInfinite(near) ? near : near - (far - near) / 3;
    }

    private static double beside(RayWalk walk, double crest, double aside) {
        double start = crest + aside;
        walk.follow(new Vector3(start, crest, 0), Vector3.UNIT_Y.negated());
        double slope = walk.direction().x() / walk.direction().y();
        return slope == 0 ? Double.POSITIVE_INFINITY : (start - crest) / slope;
    }
}
