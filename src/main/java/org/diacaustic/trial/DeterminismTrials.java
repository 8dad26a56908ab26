package org.diacaustic.trial;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.TimeUnit;
import org.diacaustic.image.LinearImage;
import org.diacaustic.light.Falloff;
import org.diacaustic.stability.Checks;
import org.diacaustic.stability.Launcher;
import org.diacaustic.stability.NumericCase;
import org.diacaustic.stability.Operations;

/** The same bits, however they are made. */
final class DeterminismTrials {
    private static final int PIXELS = 60;
    private static final long LIGHT_RAYS = 4000;
    private static final int SCENES = 6;
    private static final long LONGEST_SECONDS = 120;

    /** As processes render it: refraction, waves and a photon map, in a second. */
    private static final String SCENE = """
            camera: {from: [0, 3, 8], to: [0, 1, 0], field-of-view: 35, size: [48, 36]}
            lights:
              - point: {at: [2, 6, 3], intensity: 90}
            materials:
              floor: {diffuse: {checker: {first: [0.8, 0.8, 0.75], second: [0.3, 0.35, 0.4], size: 0.5}}}
              glass: {transparency: 1, ior: 1.5, absorption: [0.3, 0.1, 0.2]}
              water: {transparency: 0.95, ior: 1.33, waves: [{direction: [1, 0, 0.3], length: 0.7, height: 0.02}]}
            objects:
              - plane: {at: [0, 0, 0], normal: [0, 1, 0], material: floor}
              - sphere: {name: ball, at: [0, 1, 0], radius: 0.8, material: glass}
              - polygon: {name: sheet, vertices: [[-3, 3, -3], [-3, 3, 3], [3, 3, 3], [3, 3, -3]], material: water}
            """;

    private static final Map<String, String> COLLECTORS = Map.of("serial", "-XX:+UseSerialGC", "g1", "-XX:+UseG1GC");

    private final Launcher launcher;

    private DeterminismTrials(Launcher launcher) {
        this.launcher = launcher;
    }

    static void addTo(Operations operations, Launcher launcher) {
        operations.add(
                "determinism",
                "Renders " + SCENES
                        + " scenes of chance, in as many ways to trace light forward, on each number of threads. With --jdk HOME,"
                        + " processes of both virtual machines render a scene too, with each collector, compiled and interpreted.",
                new DeterminismTrials(launcher)::run);
    }

    private void run(NumericCase asked, Checks checks) throws IOException, InterruptedException {
        Set<String> distinct = new TreeSet<>();
        for (double threads : asked.inputs().numbers("threads")) {
            distinct.add(picturesOf((int) threads));
        }
        checks.number("distinct_sha256", distinct.size(), "count");
        if (launcher.otherJava().isEmpty()) {
            checks.note(
                    "threads only: --jdk HOME holds virtual machines, collectors and the interpreter against each other too");
            return;
        }
        checks.number(
                "distinct pictures of processes",
                1,
                pictures(asked.inputs().texts("gc"), asked.inputs().texts("jit"))
                        .size(),
                0);
    }

    private static String picturesOf(int threads) {
        MessageDigest digest = sha256();
        for (long scene = 0; scene < SCENES; scene++) {
            Way way = Way.of(scene);
            RandomScene random = new RandomScene(scene, PIXELS, !way.needsEnds());
            LinearImage picture = Pictures.render(
                            random.build(Placing.HOME, new Falloff.InverseSquare(), 1),
                            way.settings(LIGHT_RAYS, scene),
                            threads)
                    .image();
            ByteBuffer bytes = ByteBuffer.allocate(4 * picture.samples().length);
            bytes.asFloatBuffer().put(picture.samples());
            digest.update(bytes);
        }
        return HexFormat.of().formatHex(digest.digest());
    }

    /** The digests of pictures that processes write, all in one way. */
    private Set<String> pictures(List<String> collectors, List<String> compilers)
            throws IOException, InterruptedException {
        Path folder = Files.createTempDirectory("determinism");
        Path scene = folder.resolve("scene.yaml");
        Path picture = folder.resolve("picture.pfm");
        Set<String> distinct = new TreeSet<>();
        try {
            Files.writeString(scene, SCENE);
            for (Path java : List.of(launcher.java(), launcher.otherJava().orElseThrow())) {
                for (String collector : collectors) {
                    for (String compiler : compilers) {
                        List<String> command = new ArrayList<>(List.of(
                                java.toString(), COLLECTORS.getOrDefault(collector, "-XX:+Use" + collector + "GC")));
                        if (!compiler.equals("default")) {
                            command.add(compiler);
                        }
                        command.addAll(launcher.program());
                        command.addAll(List.of("render", scene.toString(), "-o", picture.toString()));
                        command.addAll(List.of("--preprocessor", "random", "--map", "photon-map", "--rays", "2000"));
                        distinct.add(
                                run(command) == 0
                                        ? HexFormat.of().formatHex(sha256().digest(Files.readAllBytes(picture)))
                                        : "failed: " + String.join(" ", command.subList(0, 3)));
                        Files.deleteIfExists(picture);
                    }
                }
            }
        } finally {
            Files.deleteIfExists(picture);
            Files.deleteIfExists(scene);
            Files.delete(folder);
        }
        return distinct;
    }

    private static int run(List<String> command) throws IOException, InterruptedException {
        Process process = new ProcessBuilder(command)
                .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                .redirectError(ProcessBuilder.Redirect.DISCARD)
                .start();
        if (!process.waitFor(LONGEST_SECONDS, TimeUnit.SECONDS)) {
            process.destroyForcibly().waitFor();
            return -1;
        }
        return process.exitValue();
    }

    private static MessageDigest sha256() {
        try {
            return MessageDigest.getInstance("SHA-256");
        } catch (NoSuchAlgorithmException missing) {
            // Every Java platform must have it.
            throw new IllegalStateException(missing);
        }
    }
}
