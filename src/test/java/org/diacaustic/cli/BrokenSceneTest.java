package org.diacaustic.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.zip.CRC32;
import java.util.zip.DeflaterOutputStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** Every fault of a scene is one clear line with its place, exit code 2, 3 or 4, and no picture. */
class BrokenSceneTest {
    private static final Duration LONGEST = Duration.ofSeconds(2);
    private static final String RADIUS = "radius: 1";
    private static final String DIFFUSE = "diffuse: 0.5";
    private static final String FLOOR = "plane: {name: floor, at: [0, -1, 0], normal: [0, 1, 0]";

    @TempDir
    Path folder;

    @BeforeEach
    void writeBrokenFiles() throws IOException {
        Files.write(folder.resolve("bomb.png"), greyPng(50_000, 50_000, false));
        Files.write(folder.resolve("broken.png"), greyPng(2, 2, true));
        Files.writeString(folder.resolve("text.png"), "no picture");
        Files.writeString(folder.resolve("index.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 7\n");
        Files.writeString(folder.resolve("nan.obj"), "v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n");
    }

    /** A piece of the small scene, what stands in its place, the exit code, and how the line begins that tells it. */
    static Arguments[] faults() {
        String sphere = "objects[0].sphere.";
        String image = "5:34: materials.grey.diffuse.image.file: ";
        return new Arguments[] {
            fault(RADIUS, "raduis: 1", 2, "11:7: " + sphere + "raduis: unknown key; did you mean 'radius'?"),
            fault(
                    RADIUS,
                    "colour: 1\n      " + RADIUS,
                    2,
                    "11:7: " + sphere + "colour: unknown key; known here: name, "),
            fault(RADIUS, "radius: one", 2, "11:15: " + sphere + "radius: expected a number above 0, found 'one'"),
            fault(RADIUS, "radius: [1]", 2, "11:15: " + sphere + "radius: expected a number above 0, found a list of"),
            fault(RADIUS, "radius: .nan", 2, "11:15: " + sphere + "radius: expected a number above 0, found '.nan'"),
            fault(RADIUS, "radius: 1e400", 2, "11:15: " + sphere + "radius: expected a number above 0, found '1e400'"),
            fault(RADIUS, "radius: 1e308", 2, "9:7: objects[0].sphere: expected a shape with a size from 1.0E-150 to "),
            fault(
                    RADIUS,
                    "radius: 1e-320",
                    2,
                    "9:7: objects[0].sphere: expected a shape with a size from 1.0E-150 to "),
            fault(
                    "at: [0, 0, 0]",
                    "at: [1e200, 0, 0]",
                    2,
                    "9:7: objects[0].sphere: expected a shape with a size from 1.0E-150 to "),
            fault("name: ball", "name: 'ball", 2, "9:13: the quote opened here is not closed"),
            fault("camera:", "%YAML 3.0\n---\ncamera:", 2, "1:1: is YAML of another version; a scene file is YAML 1.2"),
            fault(RADIUS, "radius: -1", 2, "11:15: " + sphere + "radius: expected a number above 0, found '-1'"),
            fault(RADIUS, "radius: 1\n      radius: 2", 2, "12:7: " + sphere + "radius: the key is there twice"),
            fault(RADIUS, "# none", 2, "9:7: " + sphere + "radius: is missing: expected a number above 0"),
            fault("at: [0, 0, 0]", "at: [0, 0]", 2, "10:11: " + sphere + "at: expected a list of 3 numbers, found"),
            fault(
                    "ior: 1.5",
                    "ior: 1,33",
                    2,
                    "6:37: materials.glass.33: unknown key; if it belongs to a number before"),
            fault(
                    "ior: 1.5",
                    "ior: '1.5'",
                    2,
                    "6:35: materials.glass.ior: expected a number above 0, found '1.5' in q"),
            fault(DIFFUSE, "diffuse: 1.5", 2, "5:19: materials.grey.diffuse: expected a colour, "),
            fault(
                    DIFFUSE,
                    "diffuse: {cheker: {size: 1}}",
                    2,
                    "5:20: materials.grey.diffuse: unknown kind 'cheker'; did"),
            fault(DIFFUSE, "diffuse: {checker: {}}", 2, "5:29: materials.grey.diffuse.checker.size: is missing: expec"),
            fault(DIFFUSE, "diffuse: {image: {file: none.png}}", 3, image + "no such file: "),
            fault(
                    DIFFUSE,
                    "diffuse: {image: {file: ../../etc/passwd}}",
                    2,
                    image + "the file lies outside the scene's f"),
            fault(DIFFUSE, "diffuse: {image: {file: broken.png}}", 3, image),
            fault(DIFFUSE, "diffuse: {image: {file: text.png}}", 3, image),
            fault(DIFFUSE, "diffuse: {image: {file: bomb.png}}", 4, image),
            fault(DIFFUSE, "diffuse: !!javax.script.ScriptEngineManager {}", 2, "5:19: the tag "),
            fault(
                    "material: grey",
                    "material: gray",
                    2,
                    "13:71: objects[1].plane.material: there is no material 'gray'"),
            fault(
                    "name: floor",
                    "name: ball",
                    2,
                    "13:19: objects[1].plane.name: another object is named 'ball' already"),
            fault("- point:", "- pint:", 2, "3:5: lights[0]: unknown kind 'pint'; did you mean 'point'?"),
            fault("camera:", "# camera:", 2, "2:1: camera: is missing: expected a mapping"),
            fault("objects:", "object:", 2, "7:1: object: unknown key; did you mean 'objects'?"),
            fault("to: [0, 0, 0]", "to: [0, 2, 6]", 2, "1:9: camera: a camera's 'from' [0.0, 2.0, 6.0] and 'to' [0.0,"),
            fault("to: [0, 0, 0]", "to: [0, 0, 0", 2, "1:31: the bracket opened here is not closed: "),
            fault("size: [20, 16]", "size: [0, 0]", 2, "1:48: camera.size: expected a width and a height in whole pix"),
            fault("normal: [0, 1, 0]", "normal: [0, 0, 0]", 2, "13:50: objects[1].plane.normal: expected a direction"),
            fault(
                    FLOOR,
                    "polygon: {vertices: [[1, 2, 3], [1, 2, 3], [1, 2, 3]]",
                    2,
                    "13:14: objects[1].polygon: vertex"),
            fault(
                    FLOOR,
                    "polygon: {vertices: [[1, 2, 3], [1, 2, 4]]",
                    2,
                    "13:25: objects[1].polygon.vertices: expected a"),
            fault(
                    FLOOR,
                    "ellipsoid: {at: [0, 0, 0], radii: [1, 0, 1]",
                    2,
                    "13:16: objects[1].ellipsoid: radii must be"),
            fault(
                    "materials:",
                    "materials: &all\n  mine: *all",
                    2,
                    "5:9: *all stands inside what it names: all -> all"),
            fault(
                    "lights:",
                    "lights: " + "[".repeat(100_000) + "]".repeat(100_000) + "\nx:",
                    2,
                    "2:58: nested deeper than"),
            fault(SmallScene.TEXT, "", 2, "1:1: holds no scene: the document is empty"),
        };
    }

    private static Arguments fault(String piece, String replacement, int code, String line) {
        return Arguments.of(piece, replacement, code, line);
    }

    @ParameterizedTest(name = "{index}: {3}")
    @MethodSource("faults")
    void render_givenBrokenScene_saysWhereAndWhyInOneLine(String piece, String replacement, int code, String line)
            throws IOException {
        Path scene = SmallScene.in(folder, piece, replacement);
        Path picture = folder.resolve("out.png");
        long start = System.nanoTime();
        Cli.Result result = Cli.run("render", scene, "-o", picture);
        assertThat(Duration.ofNanos(System.nanoTime() - start)).isLessThan(LONGEST);
        assertThat(result.errorLines()).hasSize(1);
        assertThat(result.err()).startsWith(scene + ":" + line);
        assertThat(result.code()).isEqualTo(code);
        assertThat(result.out()).isEmpty();
        assertThat(picture).doesNotExist();
    }

    @ParameterizedTest
    @MethodSource("brokenMeshes")
    void render_givenBrokenMesh_namesItsLine(String file, String line) throws IOException {
        Path scene = SmallScene.in(folder, FLOOR, "mesh: {file: " + file);
        Cli.Result result = Cli.run("render", scene, "-o", folder.resolve("out.png"));
        assertThat(result.code()).isEqualTo(2);
        assertThat(result.errorLines()).hasSize(1);
        assertThat(result.err()).startsWith(folder.resolve(file) + line);
    }

    static Arguments[] brokenMeshes() {
        return new Arguments[] {
            Arguments.of("index.obj", ":4: a face names vertex 7, but the file has 3 vertices"),
            Arguments.of("nan.obj", ":2: expected x, y, z, a finite number, found 'nan'")
        };
    }

    @Test
    void render_givenNoSceneFile_givesCode3() {
        Cli.Result result = Cli.run("render", folder.resolve("none.yaml"), "-o", folder.resolve("out.png"));
        assertThat(result.code()).isEqualTo(3);
        assertThat(result.errorLines()).hasSize(1);
        assertThat(result.err()).contains("none.yaml: no such file");
    }

    @Test
    void render_givenSizeBeyondMemory_refusesItBeforeAllocation() throws IOException {
        Path scene = SmallScene.in(folder, "size: [20, 16]", "size: [100000, 100000]");
        Cli.Result result = Cli.run("render", scene, "-o", folder.resolve("out.png"));
        assertThat(result.code()).isEqualTo(4);
        assertThat(result.errorLines()).hasSize(1);
        // 3 floats of 4 bytes for each of 10^10 pixels, of the picture and of what a coarser map would change.
        assertThat(result.err()).contains("100000 x 100000 needs 240000000000 bytes");
    }

    @Test
    void check_givenManyFaults_tellsThemAllInTheOrderOfTheFile() throws IOException {
        Path scene = folder.resolve("scene.yaml");
        Files.writeString(
                scene,
                SmallScene.TEXT
                        .replace(RADIUS, "radius: one")
                        .replace(DIFFUSE, "diffuse: {image: {file: none.png}}")
                        .replace("- point:", "- pint:"));
        Cli.Result result = Cli.run("check", scene);
        assertThat(result.code()).isEqualTo(2);
        assertThat(result.err()).isEmpty();
        assertThat(result.out()
                        .lines()
                        .map(line -> line.replace(scene + ":", "").split(": ")[1]))
                .containsExactly("lights[0]", "materials.grey.diffuse.image.file", "objects[0].sphere.radius");
    }

    @Test
    void check_givenUnknownShader_saysWhichAreKnown() throws IOException {
        Cli.Result result = Cli.run("check", SmallScene.in(folder), "--shader", "raytrace");
        assertThat(result.code()).isEqualTo(2);
        assertThat(result.errorLines())
                .containsExactly(
                        "diacaustic: unknown shader 'raytrace'; known are auto, non-transparent, non-refractive");
    }

    @Test
    void check_givenSoundScene_saysSo() throws IOException {
        Path scene = SmallScene.in(folder);
        Cli.Result result = Cli.run("check", scene);
        assertThat(result.code()).isZero();
        assertThat(result.out()).isEqualTo(scene + ": OK, 2 objects, 1 light, 20 x 16 pixels\n");
        assertThat(result.err()).isEmpty();
    }

    @Test
    void check_givenDoubtfulScenes_warns() throws IOException {
        Path scene = SmallScene.in(folder, "from: [0, 2, 6]", "from: [0.5, 0, 0.5]");
        assertThat(Cli.run("check", scene).out()).doesNotContain("warning");
        SmallScene.in(folder, "material: glass", "material: grey");
        assertThat(Cli.run("check", scene).out()).doesNotContain("warning");
        Files.writeString(
                scene,
                SmallScene.TEXT
                        .replace("from: [0, 2, 6]", "from: [0.5, 0, 0.5]")
                        .replace("material: glass", "material: grey"));
        assertThat(Cli.run("check", scene).out())
                .startsWith(scene + ":1:16: warning: camera.from: the camera stands inside ball, which is opaque\n");
        SmallScene.in(folder, "from: [0, 2, 6]", "from: [0, -1, 6]");
        assertThat(Cli.run("check", scene).out())
                .startsWith(
                        scene + ":1:16: warning: camera.from: the camera stands on the surface of floor; rounding ");
        SmallScene.in(folder, "from: [0, 2, 6]", "from: [0, -0.9999999, 6]");
        assertThat(Cli.run("check", scene).out()).doesNotContain("warning");
        Files.writeString(scene, "camera: {from: [0, 0, 5], to: [0, 0, 0]}\n");
        Cli.Result result = Cli.run("render", scene, "-o", folder.resolve("out.png"));
        assertThat(result.code()).isZero();
        assertThat(result.err())
                .contains("warning: no objects: the picture shows the background only")
                .contains("warning: no lights: ");
    }

    /** One grey, in a valid file of any size; its data end early. */
    private static byte[] greyPng(int width, int height, boolean wrongChecksum) throws IOException {
        ByteArrayOutputStream header = new ByteArrayOutputStream();
        DataOutputStream fields = new DataOutputStream(header);
        fields.writeInt(width);
        fields.writeInt(height);
        fields.write(new byte[] {8, 0, 0, 0, 0});
        ByteArrayOutputStream data = new ByteArrayOutputStream();
        try (DeflaterOutputStream rows = new DeflaterOutputStream(data)) {
            rows.write(new byte[6]);
        }
        ByteArrayOutputStream file = new ByteArrayOutputStream();
        DataOutputStream out = new DataOutputStream(file);
        out.writeLong(0x89504e470d0a1a0aL);
        writeChunk(out, "IHDR", header.toByteArray(), 0);
        writeChunk(out, "IDAT", data.toByteArray(), wrongChecksum ? 1 : 0);
        writeChunk(out, "IEND", new byte[0], 0);
        return file.toByteArray();
    }

    private static void writeChunk(DataOutputStream out, String type, byte[] data, int error) throws IOException {
        byte[] name = type.getBytes(StandardCharsets.US_ASCII);
        CRC32 checksum = new CRC32();
        checksum.update(name);
        checksum.update(data);
        out.writeInt(data.length);
        out.write(name);
        out.write(data);
        out.writeInt((int) checksum.getValue() ^ error);
    }
}
