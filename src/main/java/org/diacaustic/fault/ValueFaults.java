package org.diacaustic.fault;

import java.io.IOException;
import java.util.List;
import org.diacaustic.image.ImageFiles;
import org.diacaustic.image.LinearImage;
import org.diacaustic.stability.Checks;

/** Numbers of the right kind that mean nothing, and scenes in which something is missing or in the way. */
final class ValueFaults {
    private static final String PLACE = "^scene\\.yaml:\\d+:\\d+: ";

    private ValueFaults() {}

    static void addTo(FaultOperations operations) {
        operations
                .add(
                        "nonfinite",
                        "Not a number, infinite, too large for a double, and where they mean nothing also 0 and negative, for sizes,"
                                + " places, indices, powers, fractions and settings: exit code 2 with the rule.",
                        (bench, asked, checks) -> nonFinite(bench))
                .add(
                        "zeroarea",
                        "Polygons, ellipsoids, boxes, discs, cylinders and the like without extent are refused with exit code 2;"
                                + " triangles of meshes without area are left out with a warning that counts them.",
                        (bench, asked, checks) -> zeroArea(bench))
                .add(
                        "dupname",
                        "Two objects of one name are refused with exit code 2 and both places, also if one of the names was given"
                                + " by us; materials, which are referred to by name, likewise.",
                        (bench, asked, checks) -> duplicateName(bench))
                .add(
                        "emptyscene",
                        "No lights, no objects, neither: a picture, black but for ambient light and background, and a warning each;"
                                + " no camera, nothing at all: exit code 2.",
                        (bench, asked, checks) -> emptyScene(bench, checks))
                .add(
                        "caminside",
                        "The eye in the middle of opaque objects, on surfaces, in glass, where a light is: a picture of numbers,"
                                + " and a warning if it is in or on what is opaque.",
                        (bench, asked, checks) -> cameraInside(bench));
    }

    private static void nonFinite(FaultBench bench) throws IOException, InterruptedException {
        for (String number : List.of(".nan", ".inf", "-.inf", "1e400", "0", "-1")) {
            refuses(bench, FaultScene.RADIUS, "radius: ", number, "expected a number above 0, found ");
        }
        for (String number : List.of(".nan", ".inf", "-1e400")) {
            refuses(bench, FaultScene.IOR, "ior: ", number, "expected a number above 0, found ");
            refuses(bench, "intensity: 100", "intensity: ", number, "expected a colour, .*each of at least 0, found ");
            refuses(bench, "at: [0, 0, 0]", "at: [0, 0, ", number + "]", "expected a number, found ");
        }
        refuses(bench, FaultScene.IOR, "ior: ", "0", "expected a number above 0, found ");
        refuses(bench, FaultScene.IOR, "absorption: ", "-1", "each of at least 0, found ");
        refuses(bench, "intensity: 100", "intensity: ", "-1", "each of at least 0, found ");
        refuses(bench, "transparency: 0.9", "transparency: ", "1.5", "each from 0 to 1, found ");
        refuses(bench, "from: [0, 2, 6]", "from: [0, 2, ", ".nan]", "expected a number, found ");
        refuses(bench, "from: [0, 2, 6]", "from: ", "[0, 0, 0]", "'from'.*and 'to'");
        refuses(bench, "size: [20, 16]", "size: [20, ", ".inf]", "expected a number, found ");
        refuses(bench, "size: [20, 16]", "size: [20, 16], field-of-view: ", "180", "below 180");
        refuses(bench, "normal: [0, 1, 0]", "normal: [0, ", ".nan, 0]", "expected a number, found ");
        refuses(bench, "normal: [0, 1, 0]", "normal: ", "[0, 0, 0]", "not all 0");
        refuses(bench, FaultScene.RAYS, "gather-radius: ", "0", "expected a number from .* found ");
        refuses(bench, FaultScene.RAYS, "rays: ", "-5", "expected a whole number .* found ");
        refuses(bench, FaultScene.RADIUS, "radius: ", "1e308", "a size from 1.0E-150 to 1.0E150");
        refuses(bench, FaultScene.RADIUS, "radius: ", "1e-320", "a size from 1.0E-150 to 1.0E150");
    }

    private static void refuses(FaultBench bench, String piece, String key, String number, String rule)
            throws IOException, InterruptedException {
        bench.refuses(key + number, FaultScene.with(piece, key + number), 2, PLACE + ".*" + rule);
    }

    private static void zeroArea(FaultBench bench) throws IOException, InterruptedException {
        String[][] objects = {
            {"polygon", "vertices: [[1, 2, 3], [1, 2, 3], [1, 2, 3]]"},
            {"polygon", "vertices: [[0, 0, 0], [1, 0, 0]]"},
            {"polygon", "vertices: [[0, 0, 0], [1, 0, 0], [2, 0, 0]]"},
            {"polygon", "vertices: [[0, 0, 0], [1, 0, 0], [1, 0, 0], [0, 1, 0]]"},
            {"polygon", "vertices: [[0, 0, 0], [1, 0, 0], [1, 1e-320, 0]]"},
            {"ellipsoid", "at: [0, 0, 0], radii: [1, 0, 1]"},
            {"sphere", "at: [0, 0, 0], radius: 0"},
            {"box", "low: [0, 0, 0], high: [0, 0, 0]"},
            {"box", "low: [0, 0, 0], high: [1, 0, 1]"},
            {"disc", "at: [0, 0, 0], normal: [0, 1, 0], radius: 1, inner-radius: 1"},
            {"cylinder", "from: [0, 0, 0], to: [0, 0, 0], radius: 1"},
            {"torus", "at: [0, 0, 0], major-radius: 1, minor-radius: 0"},
            {"quadric", "coefficients: [0, 0, 0, 0, 0, 0, 0, 0, 0, 1]"},
            {"plane", "at: [0, 0, 0], normal: [0, 0, 0]"},
        };
        for (String[] object : objects) {
            String scene = FaultScene.withObject(object[0], object[1]);
            bench.refuses(object[0] + " " + object[1], scene, 2, PLACE + "objects\\[2\\]\\." + object[0]);
        }
        bench.refuses(
                "a transform to nothing",
                FaultScene.withObject("sphere", "at: [0, 0, 0], radius: 1, transform: [{scale: {by: [1, 0, 1]}}]"),
                2,
                PLACE + "objects\\[2\\]\\.sphere\\.transform");
        for (String triangle : List.of("f 1 1 1", "f 1 2 2", "f 1 2 3")) {
            bench.write("flat.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\n" + triangle + "\n");
            bench.renders(
                    "a triangle of a mesh, " + triangle,
                    FaultScene.withObject("mesh", "file: flat.obj"),
                    ".*flat\\.obj: warning: 1 of 1 triangles have no area; no light meets them");
        }
    }

    private static void duplicateName(FaultBench bench) throws IOException, InterruptedException {
        String both = PLACE + ".*another object is named '.*' already, at line \\d+";
        bench.refuses("two objects 'ball'", FaultScene.with("name: floor", "name: ball"), 2, both);
        bench.refuses(
                "a name that we gave",
                FaultScene.with("name: ball", "name: plane-2").replace("name: floor, ", ""),
                2,
                both);
        bench.refuses(
                "two materials 'grey'",
                FaultScene.with("  glass:", "  grey: {diffuse: 1}\n  glass:"),
                2,
                PLACE + "materials\\.grey: the key is there twice; the first is at line 5");
        bench.renders("names that differ in case", FaultScene.with("name: floor", "name: Ball"), "");
    }

    private static void emptyScene(FaultBench bench, Checks checks) throws IOException, InterruptedException {
        String noLights = "[^\\n]*warning: no lights: [^\\n]*";
        String noObjects = "[^\\n]*warning: no objects: [^\\n]*";
        bench.renders("no lights", FaultScene.without("lights:", "materials:"), noLights);
        LinearImage black = ImageFiles.read(bench.folder().resolve(FaultBench.PICTURE));
        float light = 0;
        for (float sample : black.samples()) {
            light += sample;
        }
        checks.same("light in a picture without lights", 0f, light);
        bench.renders(
                "an empty list of lights",
                FaultScene.with("  - point: {at: [0, 9, 0], intensity: 100}\n", "")
                        .replace("lights:", "lights: []"),
                noLights);
        bench.renders("no objects", FaultScene.without("objects:", "settings:"), noObjects);
        bench.renders(
                "an empty list of objects", FaultScene.without("objects:", "settings:") + "objects: []\n", noObjects);
        bench.renders(
                "a camera only",
                "camera: {from: [0, 2, 6], to: [0, 0, 0], size: [20, 16]}\n",
                "(" + noObjects + "\\n?|" + noLights + "\\n?){2}");
        bench.renders("a light of no power", FaultScene.with("intensity: 100", "intensity: 0"), "");
        bench.refuses("no camera", FaultScene.without("camera:", "lights:"), 2, "scene\\.yaml:1:1: camera: is missing");
        bench.refuses(
                "a camera that says nothing",
                FaultScene.with(
                        "camera: {from: [0, 2, 6], to: [0, 0, 0], size: [20, 16]}", "camera: {from: [0, 2, 6]}"),
                2,
                PLACE + "camera\\.to: is missing");
        bench.refuses("an empty mapping", "{}", 2, "camera: is missing");
        bench.refuses("nothing", "# nothing\n", 2, "holds no scene");
    }

    private static void cameraInside(FaultBench bench) throws IOException, InterruptedException {
        String in = "[^\\n]*warning: camera.from: the camera stands inside [\\w-]+, which is opaque";
        String on = "[^\\n]*warning: camera.from: the camera stands on the surface of [\\w-]+[^\\n]*";
        String box = FaultScene.withObject("box", "low: [-9, 1, 5], high: [9, 3, 7]");
        bench.renders("in the middle of a box", box, in);
        bench.renders("at a corner of a box", FaultScene.withObject("box", "low: [0, 2, 6], high: [9, 3, 7]"), on);
        bench.renders("on a box", FaultScene.withObject("box", "low: [-9, 0, 6], high: [9, 3, 7]"), on);
        bench.renders("in the middle of a ball", FaultScene.withObject("sphere", "at: [0, 2, 6], radius: 1"), in);
        bench.renders("on a ball", FaultScene.withObject("sphere", "at: [0, 2, 7], radius: 1"), on);
        bench.renders("on the floor", FaultScene.with("from: [0, 2, 6]", "from: [0, -1, 6]"), on);
        bench.renders(
                "on a disc, looking along it",
                FaultScene.withObject("disc", "at: [0, 2, 6], normal: [0, 3, -1], radius: 1"),
                on);
        bench.renders("in glass", FaultScene.with("from: [0, 2, 6]", "from: [0, 0, 0.5]"), "");
        bench.renders("on glass", FaultScene.with("from: [0, 2, 6]", "from: [0, 0, 1]"), on);
        bench.renders("where the light is", FaultScene.with("at: [0, 9, 0]", "at: [0, 2, 6]"), "");
    }
}
