package org.diacaustic.cli;

import java.nio.file.Path;
import java.time.Duration;
import java.util.stream.Stream;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.provider.Arguments;

/** Every fault of a scene file is one clear line with its place, exit code 2, 3 or 4, and no picture. */
class BrokenSceneTest {
    private static final Duration LONGEST = Duration.ofSeconds(2);

    @TempDir
    Path folder;

    /** A piece of the small scene, what stands in its place, the exit code, and the line that tells it. */
    static Stream<Arguments> faults() {
        return Stream.of(
                fault(
                        "radius: 1",
                        "raduis: 1",
                        2,
                        "11:7: objects[0].sphere.raduis: unknown key; did you mean 'radius'?"),
                fault(
                        "radius: 1",
                        "radius: one",
                        2,
                        "11:15: objects[0].sphere.radius: expected a number above 0, found 'one'"),
                fault(
                        "radius: 1",
                        "radius: .nan",
                        2,
                        "11:15: objects[0].sphere.radius: expected a number above 0, found '.nan', which is not a finite number"),
                fault(
                        "radius: 1",
                        "radius: -1",
                        2,
                        "11:15: objects[0].sphere.radius: expected a number above 0, found '-1'"),
                fault(
                        "radius: 1",
                        "radius: 1e400",
                        2,
                        "11:15: objects[0].sphere.radius: expected a number above 0, found '1e400', which is too large for a double"),
                fault(
                        "radius: 1",
                        "radius: 1\n      radius: 2",
                        2,
                        "12:7: objects[0].sphere.radius: the key is there twice; the first is at line 11"),
                fault(
                        "at: [0, 0, 0]",
                        "at: [0, 0]",
                        2,
                        "10:11: objects[0].sphere.at: expected a list of 3 numbers, found a list of 2 values"),
                fault(
                        "ior: 1.5",
                        "ior: 1,33",
                        2,
                        "6:37: materials.glass.33: unknown key; if it belongs to a number before it, write that with a point, not a comma"),
                fault(
                        "ior: 1.5",
                        "ior: '1.5'",
                        2,
                        "6:35: materials.glass.ior: expected a number above 0, found '1.5' in quotes, which make it text"),
                fault(
                        "diffuse: 0.5",
                        "diffuse: 1.5",
                        2,
                        "5:19: materials.grey.diffuse: expected a colour, [red, green, blue] or one number for grey, each from 0 to 1, found '1.5'"),
                fault(
                        "diffuse: 0.5",
                        "diffuse: {cheker: {size: 1}}",
                        2,
                        "5:20: materials.grey.diffuse: unknown kind 'cheker'; did you mean 'checker'?"),
                fault(
                        "diffuse: 0.5",
                        "diffuse: {checker: {}}",
                        2,
                        "5:29: materials.grey.diffuse.checker.size: is missing: expected a number above 0"),
                fault(
                        "material: grey",
                        "material: gray",
                        2,
                        "13:73: objects[1].plane.material: there is no material 'gray'; did you mean 'grey'?"),
                fault(
                        "name: floor",
                        "name: ball",
                        2,
                        "13:19: objects[1].plane.name: another object is named 'ball' already, at line 9"),
                fault("- point:", "- pint:", 2, "3:5: lights[0]: unknown kind 'pint'; did you mean 'point'?"),
                fault("camera:", "# camera:", 2, "2:1: camera: is missing: expected a mapping of keys to values"),
                fault(
                        "size: [20, 16]",
                        "size: [0, 0]",
                        2,
                        "1:48: camera.size: expected a width and a height in whole pixels of at least 1, found 0"),
                fault(
                        "to: [0, 0, 0]",
                        "to: [0, 2, 6]",
                        2,
                        "1:9: camera: 'from' (0.0, 2.0, 6.0) and 'to' (0.0, 2.0, 6.0) must be two different finite points"),
                fault(
                        "to: [0, 0, 0]",
                        "to: [0, 0, 0",
                        2,
                        "1:32: the bracket opened here is not closed: expected ',' or ']', but got :: at line 1, column 53"),
                fault(
                        "normal: [0, 1, 0]",
                        "normal: [0, 0, 0]",
                        2,
                        "13:53: objects[1].plane.normal: expected a direction, 3 numbers that are not all 0, found the zero vector"),
                fault(
                        "- plane: {name: floor, at: [0, -1, 0], normal: [0, 1, 0]",
                        "- polygon: {vertices: [[1, 2, 3], [1, 2, 3], [1, 2, 3]]",
                        2,
                        "13:14: objects[1].polygon: a polygon"),
                fault(
                        "- plane: {name: floor, at: [0, -1, 0], normal: [0, 1, 0]",
                        "- polygon: {vertices: [[1, 2, 3], [1, 2, 4]]",
                        2,
                        "13:25: objects[1].polygon.vertices: expected a list of at least 3 points, each a list of 3 numbers, found a list of 2 values"),
                fault(
                        "- plane: {name: floor, at: [0, -1, 0], normal: [0, 1, 0]",
                        "- ellipsoid: {at: [0, 0, 0], radii: [1, 0, 1]",
                        2,
                        "13:16: objects[1].ellipsoid: "),
                fault(
                        "materials:",
                        "materials: &all\n  mine: *all",
                        2,
                        "5:9: *all stands inside what it names: all -> all"),
                fault(
                        "- point: {at: [0, 9, 0], intensity: 100}",
                        "[".repeat(100_000) + "]".repeat(100_000),
                        2,
                        "3:51: nested deeper than the limit of 50 levels"),
                fault(
                        "diffuse: 0.5",
                        "diffuse: {image: {file: nofile.png}}",
                        3,
                        "5:33: materials.grey.diffuse.image.file: no such file: "),
                fault(
                        "diffuse: 0.5",
                        "diffuse: {image: {file: ../../../../../../../etc/passwd}}",
                        2,
                        "5:33: materials.grey.diffuse.image.file: the file lies outside the scene's folder, which is not allowed: "),
                fault(
                        "diffuse: 0.5",
                        "diffuse: {image: {file: broken.png}}",
                        3,
                        "5:33: materials.grey.diffuse.image.file: "),
                fault(
                        "diffuse: 0.5",
                        "diffuse: {image: {file: bomb.png}}",
                        4,
                        "5:33: materials.grey.diffuse.image.file: "),
                fault(
                        "diffuse: 0.5",
                        "diffuse: {image: {file: scene.yaml}}",
                        3,
                        "5:33: materials.grey.diffuse.image.file: "),
                fault("diffuse: 0.5", "diffuse: !!javax.script.ScriptEngineManager {}", 2, "5:19: the tag "),
                fault("settings: {}", "", 0, ""));
    }

    private static Arguments fault(String piece, String replacement, int code, String line) {
        return Arguments.of(piece, replacement, code, line);
    }
}
