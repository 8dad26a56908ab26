package org.diacaustic.fault;

import java.io.IOException;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.diacaustic.image.ImageFiles;
import org.diacaustic.image.ImageFormat;
import org.diacaustic.image.LinearImage;
import org.diacaustic.stability.Checks;
import org.diacaustic.stability.NumericCase;

/** Sizes, counts and seeds that are out of the ordinary. */
final class OptionFaults {
    private static final String EYE = "size: [20, 16]";

    private OptionFaults() {}

    static void addTo(FaultOperations operations) {
        operations
                .add(
                        "zeroimage",
                        "Sizes of 0 and less, and what is no size: exit code 2; 1x1 in every format, 1x7 and 7x1: a picture of that size;"
                                + " sides that a format cannot hold: exit code 2.",
                        OptionFaults::zeroImage)
                .add(
                        "hugeimage",
                        "Sizes from 30000x30000 to 2147483647x2147483647 with -Xmx256m: exit code 4 at once, with the bytes needed.",
                        OptionFaults::hugeImage)
                .add(
                        "photonmem",
                        "10^9 to 10^12 light rays with -Xmx256m, for photon maps, ambient maps and the caustic mesh: exit code 4 with"
                                + " the rays that fit before any is sent, or a picture; more than can be counted: exit code 2.",
                        (bench, asked, checks) -> photonMemory(bench, checks))
                .add(
                        "threadcount",
                        "--threads -1 and less, and what is no number: exit code 2; 0 (all cores), 2, 1000 and more: the bytes of one"
                                + " thread.",
                        (bench, asked, checks) -> threadCount(bench, checks))
                .add(
                        "depthbomb",
                        "Mirrors that face each other with a depth of 10^9 and 2^31 - 1, which keep 0.999 or all light: ends by weight,"
                                + " or by --time; glass for light rays as deep; 0 is direct light only; -1 and 10^10: exit code 2.",
                        (bench, asked, checks) -> depthBomb(bench, checks))
                .add(
                        "seed",
                        "Seeds 0, 1, -1, 2^63 - 1, -2^63 and those the case names: all pictures differ and repeat; no seed is 1; what"
                                + " is no long: exit code 2.",
                        OptionFaults::seed);
    }

    private static void zeroImage(FaultBench bench, NumericCase asked, Checks checks)
            throws IOException, InterruptedException {
        String rule = "expected two whole numbers of at least 1";
        Set<String> sizes = new LinkedHashSet<>(List.of("0x0", "0x16", "-1x16", "axb", "99999999999x1"));
        sizesIn(asked).stream()
                .filter(size -> size.startsWith("0x") || size.endsWith("x0"))
                .forEach(sizes::add);
        bench.scene(FaultScene.TEXT);
        for (String size : sizes) {
            bench.refused("--size " + size, bench.render("--size=" + size), 2, rule);
        }
        for (String size : List.of("[0, 0]", "[1.5, 16]")) {
            bench.refuses("size: " + size, FaultScene.with(EYE, "size: " + size), 2, "camera\\.size: expected ");
        }
        bench.scene(FaultScene.TEXT);
        for (String size : List.of("1x1", "1x7")) {
            bench.rendered("--size " + size, bench.render("--size", size), "");
            LinearImage picture = ImageFiles.read(bench.folder().resolve(FaultBench.PICTURE));
            checks.same("its size", size, picture.width() + "x" + picture.height());
        }
        for (ImageFormat format : ImageFormat.values()) {
            String name = "one." + format.ending();
            ProgramRun run = bench.program().run("render", "scene.yaml", "-o", name, "--size", "1x1");
            LinearImage picture = ImageFiles.read(bench.folder().resolve(name));
            checks.rule(
                    "1x1 as " + name,
                    "1x1",
                    run.toString(),
                    run.code() == 0 && picture.width() * picture.height() == 1);
            Files.delete(bench.folder().resolve(name));
        }
        bench.clear();
        ProgramRun wide = bench.program().run("render", "scene.yaml", "-o", "out.tga", "--size", "65536x1");
        bench.refused("a width that Targa cannot hold", wide, 2, "65535 pixels");
    }

    private static List<String> sizesIn(NumericCase asked) {
        List<String> sizes = new ArrayList<>();
        Matcher size =
                Pattern.compile("\\d{1,10}x\\d{1,10}").matcher(asked.inputs().text("variant", ""));
        while (size.find()) {
            sizes.add(size.group());
        }
        return sizes;
    }

    private static void hugeImage(FaultBench bench, NumericCase asked, Checks checks)
            throws IOException, InterruptedException {
        Set<String> sizes = new LinkedHashSet<>(
                List.of("100000x100000", "46341x46341", "65536x65536", "2147483647x1", "2147483647x2147483647"));
        sizesIn(asked).stream().filter(size -> size.length() > 9).forEach(sizes::add);
        bench.scene(FaultScene.TEXT);
        for (String size : sizes) {
            String[] sides = size.split("x", -1);
            long limit = Integer.MAX_VALUE;
            boolean fits = Long.parseLong(sides[0]) <= limit && Long.parseLong(sides[1]) <= limit;
            ProgramRun run =
                    FaultBench.within(2, () -> bench.render(bench.program().with("-Xmx256m"), "--size", size));
            bench.refused(
                    "--size " + size,
                    run,
                    fits ? 4 : 2,
                    fits ? size.replace("x", " x ") + ".* needs \\d+ bytes" : "at most",
                    2);
        }
        ProgramRun linear = bench.program()
                .with("-Xmx256m")
                .run("render", "scene.yaml", "-o", "out.pfm", "--size", "100000x100000");
        bench.refused("as .pfm", linear, 4, "needs 240000000000 bytes", 2);
    }

    private static void photonMemory(FaultBench bench, Checks checks) throws IOException, InterruptedException {
        bench.scene(FaultScene.TEXT);
        String expected = "about \\S+ (photons|cells) are to be expected, but there is room for \\d+: give fewer rays";
        for (String map : List.of("photon-map", "caustic-mesh", "ambient-maps")) {
            if (map.equals("ambient-maps")) {
                bench.scene(FaultScene.with(
                        "plane: {name: floor, at: [0, -1, 0], normal: [0, 1, 0]",
                        "disc: {name: floor, at: [0, -1, 0], normal: [0, 1, 0], radius: 5"));
            }
            ProgramRun run = FaultBench.within(
                    5, () -> bench.render(bench.program().with("-Xmx256m"), "--map", map, "--rays", "1000000000000"));
            bench.refused("10^12 rays, " + map, run, 4, expected, 5);
        }
        bench.scene(FaultScene.TEXT);
        ProgramRun fewer =
                bench.render(bench.program().with("-Xmx256m"), "--map", "photon-map", "--rays", "1000000000");
        bench.refused("10^9 rays, photon-map", fewer, 4, expected, 5);
        bench.refused("10^13 rays", bench.render("--rays", "10000000000000"), 2, "from 1 to 1000000000000");
        bench.refused("1e400 rays", bench.render("--rays", "1e400"), 2, "'1e400' is not a long");
        bench.rendered(
                "as many passes as wanted, within the limit",
                bench.render(
                        bench.program().with("-Xmx256m"),
                        "--map",
                        "photon-map",
                        "--rays",
                        "200000",
                        "--passes",
                        "20",
                        "--size",
                        "4x4"),
                "");
    }

    private static void threadCount(FaultBench bench, Checks checks) throws IOException, InterruptedException {
        bench.scene(FaultScene.TEXT);
        byte[] alone = bytes(bench, "--threads", 1);
        for (int threads : new int[] {0, 2, 1000, Integer.MAX_VALUE}) {
            checks.holds(
                    "--threads " + threads + " gives the same bytes",
                    Arrays.equals(alone, bytes(bench, "--threads", threads)));
        }
        for (String threads : List.of("-1", "-2147483648")) {
            bench.refused("--threads " + threads, bench.render("--threads=" + threads), 2, "must be at least 0");
        }
        for (String threads : List.of("two", "2147483648")) {
            bench.refused("--threads '" + threads + "'", bench.render("--threads=" + threads), 2, "--threads");
        }
    }

    /** The bytes of the picture, none if the run failed. */
    private static byte[] bytes(FaultBench bench, Object... more) throws IOException, InterruptedException {
        ProgramRun run = bench.render(more);
        if (run.code() != 0) {
            throw new IOException(Arrays.toString(more) + ": " + run);
        }
        return Files.readAllBytes(bench.folder().resolve(FaultBench.PICTURE));
    }

    private static void depthBomb(FaultBench bench, Checks checks) throws IOException, InterruptedException {
        String mirrors = """
                camera: {from: [0, 0, 0], to: [0, 0, 1], size: [2, 2]}
                background: 1
                materials: {mirror: {reflectivity: %s}}
                objects:
                  - plane: {at: [0, 0, 1], normal: [0, 0, -1], material: mirror}
                  - plane: {at: [0, 0, -1], normal: [0, 0, 1], material: mirror}
                """;
        String noLights = "[^\\n]*warning: no lights[^\\n]*";
        for (String depth : List.of("1000000000", "2147483647")) {
            bench.scene(mirrors.replace("%s", "0.999"));
            bench.rendered("0.999 kept, depth " + depth, bench.render("--max-depth", depth), noLights);
        }
        bench.scene(mirrors.replace("%s", "1"));
        ProgramRun endless = FaultBench.within(2, () -> bench.render("--max-depth", "1000000000", "--time", "1s"));
        checks.atMost("seconds of mirrors that keep all light, with --time 1s", 2, endless.seconds());
        checks.rule(
                "it ends by time",
                "exit 4, or 0",
                endless.toString(),
                (endless.code() == 4 || endless.code() == 0) && !endless.showsTrace());
        bench.clear();
        bench.scene(FaultScene.TEXT);
        bench.rendered(
                "light and eye rays of depth 10^9 in glass",
                bench.render("--max-depth", "1000000000", "-D", "light-depth=1000000000"),
                "");
        bench.rendered("depth 0", bench.render("--max-depth", "0"), "");
        bench.refused(
                "depth -1", bench.render("--max-depth=-1"), 2, "expected a whole number of at least 0, found '-1'");
        bench.refused("depth 10^10", bench.render("--max-depth", "10000000000"), 2, "'10000000000' is not an int");
        bench.refused(
                "light-depth -1", bench.render("-D", "light-depth=-1"), 2, "expected a whole number of at least 0");
    }

    private static void seed(FaultBench bench, NumericCase asked, Checks checks)
            throws IOException, InterruptedException {
        bench.scene(FaultScene.TEXT);
        Set<String> seeds = new LinkedHashSet<>(List.of("1", "0", "-1", "9223372036854775807", "-9223372036854775808"));
        Matcher named = Pattern.compile("-?\\d{1,18}(?![\\d^.])")
                .matcher(asked.inputs().text("variant", "").replace("2^", ""));
        while (named.find()) {
            seeds.add(named.group());
        }
        List<byte[]> pictures = new ArrayList<>();
        for (String seed : seeds) {
            byte[] picture = bytes(bench, "--seed=" + seed, "--samples", 4);
            byte[] again = bytes(bench, "-D", "seed=" + seed, "--samples", 4);
            checks.holds("seed " + seed + " repeats", Arrays.equals(picture, again));
            checks.holds(
                    "seed " + seed + " differs from those before",
                    pictures.stream().noneMatch(other -> Arrays.equals(other, picture)));
            pictures.add(picture);
        }
        checks.holds("no seed is seed 1", Arrays.equals(pictures.get(0), bytes(bench, "--samples", 4)));
        for (String seed : List.of("9223372036854775808", "-9223372036854775809", "1.5")) {
            bench.refused("--seed '" + seed + "'", bench.render("--seed=" + seed), 2, "seed");
        }
    }
}
