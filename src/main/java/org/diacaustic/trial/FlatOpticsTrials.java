package org.diacaustic.trial;

import java.util.function.DoubleUnaryOperator;
import org.diacaustic.light.Light;
import org.diacaustic.material.Material;
import org.diacaustic.math.Vector3;
import org.diacaustic.render.RadianceProbe;
import org.diacaustic.render.RenderPlan;
import org.diacaustic.scene.Scene;
import org.diacaustic.scene.Settings;
import org.diacaustic.shader.NonRefractiveShader;
import org.diacaustic.shape.Box;
import org.diacaustic.stability.Checks;
import org.diacaustic.stability.NumericCase;
import org.diacaustic.stability.Operations;

/** Light through air, flat water and plates of glass onto a floor. */
final class FlatOpticsTrials {
    /** So often light goes to and fro in a plate before what is left is nothing. */
    private static final int ALL = 100_000;

    private static final int HALVINGS = 200;

    private FlatOpticsTrials() {}

    static void addTo(Operations operations) {
        operations.add(
                "floor_irradiance",
                "π × the radiance of a white floor that the eye pass sees, before it is rounded to a picture; and photons through a"
                        + " sheet of index 1 half way, in 16 runs, against the answer and the difference between disc and point that"
                        + " the caustic mesh finds. The mesh's irradiance at the point has to meet 1e-12.",
                FlatOpticsTrials::floor);
        operations.add(
                "planar_interface_irradiance",
                "The caustic mesh of a lamp over a sheet of water, asked at the point, with and without Fresnel; the angle of the ray"
                        + " that the light walk brings there; straight shadow rays by the non-refractive shader; photons of 16 runs,"
                        + " the mesh telling how disc and point differ. mp_reproduction_rel is asked of all that is not photons.",
                FlatOpticsTrials::planarInterface);
        operations.add(
                "plate_irradiance",
                "As planar_interface_irradiance, through a box of glass without inner reflections; the light walk along the normal,"
                        + " without and with them.",
                FlatOpticsTrials::plate);
    }

    private static void floor(NumericCase asked, Checks checks) {
        double height = asked.inputs().number("h");
        double x = asked.inputs().number("r");
        double expected = asked.expected().number("E");
        Light lamp = OpticalScenes.lamp(height, asked.inputs().number("flux"));
        Scene bare = Scene.builder()
                .camera(OpticalScenes.above(x, 0.5 * height, 0))
                .light(lamp)
                .object("floor", OpticalScenes.level(0), OpticalScenes.MATT)
                .build();
        checks.number("E", seen(bare, OpticalScenes.direct(Settings.physical())), "direct");
        double disc = disc(height, x);
        Scene sheet = OpticalScenes.overFloor(
                bare.camera(),
                lamp,
                0,
                OpticalScenes.square(0.5 * height, 0.7 * (x + 2 * disc)),
                OpticalScenes.clear(1));
        ExactLight light = ExactLight.of(sheet, OpticalScenes.through(1, true), 0, "own-map");
        checks.number("E through a sheet of index 1", expected, light.at(x, 0), 1e-12 * expected);
        light.checkPhotons(checks, "photons", disc, new double[] {x}, new double[] {expected});
    }

    /** The radius that photons are gathered in: far below what irradiance changes in. */
    private static double disc(double height, double x) {
        return 0.1 * height + 0.05 * Math.abs(x);
    }

    /** The irradiance of a white floor in the middle of the picture. */
    private static double seen(Scene scene, Settings settings) {
        return Math.PI
                * new RadianceProbe(RenderPlan.of(scene, settings))
                        .through(0.5, 0.5)
                        .green();
    }

    private static void planarInterface(NumericCase asked, Checks checks) {
        double above = asked.inputs().number("a");
        double depth = asked.inputs().number("d");
        double x = asked.inputs().number("r");
        Light lamp = OpticalScenes.lamp(above, asked.inputs().number("flux"));
        Material water = OpticalScenes.clear(asked.inputs().number("n"));
        Scene endless = OpticalScenes.overFloor(
                OpticalScenes.above(x, -0.5 * depth, -depth), lamp, -depth, OpticalScenes.level(0), water);
        RayWalk walk = RayWalk.in(endless, OpticalScenes.through(1, false));
        DoubleUnaryOperator landing = tangent -> landing(walk, above, tangent, -depth);
        double tangent = tangent(landing, x, above);
        checks.number("theta1_deg", StrictMath.toDegrees(StrictMath.atan(tangent)), "mp_reproduction");
        double disc = disc(above + depth, x);
        double half = 1.2 * above * tangent(landing, Math.abs(x) + 2 * disc, above);
        Scene scene = OpticalScenes.overFloor(endless.camera(), lamp, -depth, OpticalScenes.square(0, half), water);
        for (boolean fresnel : new boolean[] {true, false}) {
            String name = fresnel ? "E_fresnel" : "E_no_fresnel";
            ExactLight light = ExactLight.of(scene, OpticalScenes.through(1, fresnel), -depth, "own-map");
            checks.number(name, light.at(x, 0), "mp_reproduction");
            light.checkPhotons(checks, "photons, " + name, disc, new double[] {x}, new double[] {
                asked.expected().number(name)
            });
        }
        Settings straight = OpticalScenes.direct(Settings.physical()).toBuilder()
                .shader(NonRefractiveShader.NAME)
                .attenuate(false)
                .build();
        checks.number("straight_line_model", seen(endless, straight), "mp_reproduction");
    }

    /** Where the ray from a lamp on the axis that leaves at an angle of this tangent lands; not in this world if it never does. */
    private static double landing(RayWalk walk, double lamp, double tangent, double floor) {
        walk.follow(new Vector3(0, lamp, 0), new Vector3(tangent, -1, 0));
        boolean lands = walk.visits() > 0
                && walk.origin().y() < lamp
                && walk.direction().y() < 0;
        return lands ? walk.landing(floor) : Double.POSITIVE_INFINITY;
    }

    /** The tangent of the angle at which the ray leaves that lands at x: as high as x over the height, or less. */
    private static double tangent(DoubleUnaryOperator landing, double x, double height) {
        double low = 0;
        double high = Math.abs(x) / height;
        for (int i = 0; i < HALVINGS && low < high; i++) {
            double middle = low + 0.5 * (high - low);
            if (middle == low || middle == high) {
                break;
            }
            if (landing.applyAsDouble(middle) < Math.abs(x)) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return high;
    }

    private static void plate(NumericCase asked, Checks checks) {
        double above = asked.inputs().number("light_to_plate");
        double thickness = asked.inputs().number("thickness");
        double below = asked.inputs().number("plate_to_floor");
        double x = asked.inputs().number("r");
        if (!(thickness > 0)) {
            checks.notApplicable("a plate without thickness is no box; scenes refuse it");
            return;
        }
        // The plate's lower side is at the height 0, so that no digit of a thin one is lost.
        double lampHeight = thickness + above;
        Light lamp = OpticalScenes.lamp(lampHeight, asked.inputs().number("flux"));
        Material glass =
                OpticalScenes.clear(asked.inputs().number("n"), asked.inputs().number("sigma"));
        double disc = disc(lampHeight + below, x);
        Settings singlePass = OpticalScenes.through(2, true);
        Scene wide = plateScene(lamp, glass, thickness, -below, 4 * (lampHeight + Math.abs(x)));
        RayWalk walk = RayWalk.in(wide, singlePass);
        DoubleUnaryOperator landing = tangent -> landing(walk, lampHeight, tangent, -below);
        double tangent = tangent(landing, x, above);
        checks.number("theta1_deg", StrictMath.toDegrees(StrictMath.atan(tangent)), "");
        double outer = Math.abs(x) + 2 * disc;
        double edge = landing(walk, lampHeight, tangent(landing, outer, above), 0);
        Scene scene = plateScene(lamp, glass, thickness, -below, 1.2 * edge);
        ExactLight light = ExactLight.of(scene, singlePass, -below, "cube");
        checks.number("E_single_pass", light.at(x, 0), "");
        light.checkPhotons(checks, "photons", disc, new double[] {x}, new double[] {
            asked.expected().number("E_single_pass")
        });
        checks.number("normal_T_single", throughNormally(wide, singlePass, lampHeight), "");
        checks.number(
                "normal_T_all_bounces", throughNormally(wide, OpticalScenes.settings(ALL, true, true), lampHeight), "");
    }

    private static Scene plateScene(Light lamp, Material glass, double thickness, double floor, double half) {
        Box box = new Box(new Vector3(-half, 0, -half), new Vector3(half, thickness, half));
        return OpticalScenes.overFloor(OpticalScenes.above(0, 0.5 * floor, floor), lamp, floor, box, glass);
    }

    private static double throughNormally(Scene scene, Settings settings, double lamp) {
        return RayWalk.in(scene, settings)
                .follow(new Vector3(0, lamp, 0), Vector3.UNIT_Y.negated())
                .kept();
    }
}
