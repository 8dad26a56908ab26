package org.diacaustic.trial;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.diacaustic.material.ConstantTexture;
import org.diacaustic.material.Material;
import org.diacaustic.math.Color;
import org.diacaustic.math.Ray;
import org.diacaustic.math.Vector3;
import org.diacaustic.render.RenderJob;
import org.diacaustic.render.RenderPlan;
import org.diacaustic.render.Rendering;
import org.diacaustic.scene.Camera;
import org.diacaustic.scene.Scene;
import org.diacaustic.scene.Settings;
import org.diacaustic.shape.Sphere;
import org.diacaustic.stability.CaseFault;
import org.diacaustic.stability.Checks;
import org.diacaustic.stability.NumericCase;
import org.diacaustic.stability.Operations;
import org.diacaustic.stability.Values;

/** Eye rays and lenses. */
final class CameraTrials {
    private static final Map<String, Vector3> AXES =
            Map.of("x", Vector3.UNIT_X, "y", Vector3.UNIT_Y, "z", Vector3.UNIT_Z);

    /** Pixels on a side of the camera that blurs. */
    private static final int SIDE = 64;

    private CameraTrials() {}

    static void addTo(Operations operations) {
        operations.add(
                "dof_blur",
                "The camera's rays from two opposite points of the rim of the lens: how far apart they are at the depth, and how far"
                        + " apart on the plane in focus the points lie by which they see one point at the depth. rel is of the"
                        + " larger of blur and aperture. Without an aperture, rays and a small picture must be those of the"
                        + " pinhole, to the bit.",
                CameraTrials::blur);
        operations.add(
                "pixel_ray",
                "The camera's ray through the middle of the pixel, counted from the top left.",
                CameraTrials::pixelRay);
        operations.add(
                "camera_degenerate",
                "The camera, and the scene file, must refuse the view with a message that names the key, from, to or up; else all"
                        + " rays must be finite and of length 1.",
                CameraTrials::degenerate);
    }

    private static void blur(NumericCase asked, Checks checks) {
        double aperture = asked.inputs().number("aperture_diameter");
        double focus = asked.inputs().number("focus");
        double depth = asked.inputs().number("depth");
        Camera camera =
                Camera.builder().size(SIDE, SIDE).lens(aperture / 2, focus).build();
        double atDepth = across(camera, 0, depth) - across(camera, 0.5, depth);
        double relative = asked.tolerance().number("rel", 1e-12);
        check("blur_diameter_at_depth", atDepth, aperture, relative, asked, checks);
        if (Double.isFinite(focus)) {
            double width = across(camera, SIDE, 0.25, focus) - across(camera, 0, 0.25, focus);
            double pixels = columnsToAxis(camera, 0, depth) - columnsToAxis(camera, 0.5, depth);
            check("blur_diameter_on_focus_plane", pixels * width / SIDE, aperture, relative, asked, checks);
        }
        if (aperture == 0) {
            isPinhole(camera, checks);
        }
    }

    private static void check(
            String name, double got, double aperture, double relative, NumericCase asked, Checks checks) {
        double expected = asked.expected().number(name);
        checks.number(name, expected, Math.abs(got), relative * Math.max(Math.abs(expected), aperture));
    }

    /** Where the ray through the middle of the picture is at a depth, to the right of the axis. */
    private static double across(Camera camera, double lensAngle, double depth) {
        return across(camera, SIDE / 2.0, lensAngle, depth);
    }

    private static double across(Camera camera, double column, double lensAngle, double depth) {
        Ray ray = new Ray();
        camera.aim(column, SIDE / 2.0, 1, lensAngle, ray);
        return Math.fma(depth, ray.directionX / -ray.directionZ, ray.originX);
    }

    /** How many columns right of the middle a point of the lens sees what lies on the axis at a depth. */
    private static double columnsToAxis(Camera camera, double lensAngle, double depth) {
        Ray ray = new Ray();
        camera.aim(SIDE, SIDE / 2.0, 0, 0, ray);
        double half = depth * ray.directionX / -ray.directionZ;
        return -across(camera, lensAngle, depth) * (SIDE / 2.0) / half;
    }

    private static void isPinhole(Camera lens, Checks checks) {
        Camera pinhole = Camera.builder().size(SIDE, SIDE).build();
        Rendering seen = ballSeenBy(lens);
        Rendering expected = ballSeenBy(pinhole);
        checks.same(
                "rays of the picture",
                expected.counters().eyeRays(),
                seen.counters().eyeRays());
        checks.holds(
                "the picture is that of the pinhole, to the bit",
                Arrays.equals(expected.image().samples(), seen.image().samples()));
    }

    private static Rendering ballSeenBy(Camera camera) {
        Material glow = Material.builder()
                .diffuse(Color.WHITE)
                .ambient(new ConstantTexture(Color.WHITE))
                .build();
        Scene scene = Scene.builder()
                .camera(camera)
                .object("ball", new Sphere(new Vector3(0, 0, -3), 0.5), glow)
                .build();
        return new RenderJob(RenderPlan.of(scene, Settings.physical()), 1, (done, total) -> {}).run();
    }

    private static void pixelRay(NumericCase asked, Checks checks) {
        Vector3 look = axis(asked.inputs(), "look", "-z");
        Camera camera = Camera.builder()
                .to(look)
                .up(axis(asked.inputs(), "up", "+y"))
                .fieldOfView(asked.inputs().number("vfov_deg"))
                .size((int) asked.inputs().integer("width"), (int)
                        asked.inputs().integer("height"))
                .build();
        double[] pixel = asked.inputs().numbers("pixel");
        Ray ray = new Ray();
        camera.aim(pixel[0] + 0.5, pixel[1] + 0.5, 0.5, 0.5, ray);
        checks.numbers("dir", new double[] {ray.directionX, ray.directionY, ray.directionZ}, "dir");
    }

    /** A direction that is written as three numbers, or as an axis with a sign. */
    private static Vector3 axis(Values inputs, String key, String otherwise) {
        String text = inputs.text(key, otherwise).strip().toLowerCase(Locale.ROOT);
        if (text.startsWith("[")) {
            return Stage.vector(inputs.vector(key));
        }
        Vector3 unit = AXES.get(text.replaceAll("[+-]", ""));
        if (unit == null) {
            throw new CaseFault("inputs." + key + " should be an axis such as -z, but is " + text);
        }
        return text.startsWith("-") ? unit.negated() : unit;
    }

    private static void degenerate(NumericCase asked, Checks checks) {
        Camera camera;
        try {
            camera = camera(asked.inputs());
        } catch (IllegalArgumentException refused) {
            String message = refused.getMessage();
            checks.holds("the message names the key", message.matches("(?s).*('from'|'to'|'up'|field of view|lens).*"));
            List<String> faults = Stage.faults(sceneWith(asked.inputs()));
            checks.holds(
                    "the scene file is refused for its camera",
                    faults.stream().anyMatch(fault -> fault.contains("camera")));
            checks.note("refused: " + message);
            return;
        }
        checks.holds("all rays are finite and of length 1", raysAreUnit(camera));
        checks.note("the view is well defined");
    }

    private static Camera camera(Values inputs) {
        Camera.Builder camera = Camera.builder()
                .from(Stage.vector(inputs.vector("position")))
                .to(Stage.vector(inputs.vector("look_at")));
        if (inputs.has("up")) {
            camera.up(Stage.vector(inputs.vector("up")));
        }
        if (inputs.has("vfov_deg")) {
            camera.fieldOfView(inputs.number("vfov_deg"));
        }
        if (inputs.has("focus")) {
            camera.lens(inputs.number("aperture_diameter", 0) / 2, inputs.number("focus"));
        }
        return camera.build();
    }

    private static String sceneWith(Values inputs) {
        List<String> keys = new ArrayList<>();
        keys.add("from: " + written(inputs.vector("position")));
        keys.add("to: " + written(inputs.vector("look_at")));
        if (inputs.has("up")) {
            keys.add("up: " + written(inputs.vector("up")));
        }
        if (inputs.has("vfov_deg")) {
            keys.add("field-of-view: " + Stage.yaml(inputs.number("vfov_deg")));
        }
        if (inputs.has("focus")) {
            keys.add("focus-distance: " + Stage.yaml(inputs.number("focus")));
            keys.add("lens-radius: " + Stage.yaml(inputs.number("aperture_diameter", 0) / 2));
        }
        return "{camera: {" + String.join(", ", keys) + "}}";
    }

    private static String written(double[] vector) {
        return "[" + Stage.yaml(vector[0]) + ", " + Stage.yaml(vector[1]) + ", " + Stage.yaml(vector[2]) + "]";
    }

    private static boolean raysAreUnit(Camera camera) {
        Ray ray = new Ray();
        for (int i = 0; i <= 8; i++) {
            for (int j = 0; j <= 8; j++) {
                camera.aim(camera.width() * i / 8.0, camera.height() * j / 8.0, i / 9.0, j / 9.0, ray);
                double length = new Vector3(ray.directionX, ray.directionY, ray.directionZ).length();
                if (!(Math.abs(length - 1) < 1e-15)) {
                    return false;
                }
            }
        }
        return true;
    }
}
