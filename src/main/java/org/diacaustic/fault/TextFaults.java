package org.diacaustic.fault;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.util.Arrays;
import java.util.List;
import org.diacaustic.stability.Checks;

/** Faults of a scene's text, before any key of it is looked at. */
final class TextFaults {
    private static final String PLACE = "^scene\\.yaml:\\d+:\\d+: ";
    private static final int MEBIBYTE = 1 << 20;

    private TextFaults() {}

    static void addTo(FaultOperations operations) {
        operations
                .add(
                        "malformed",
                        "Brackets, quotes and keys left open, a wrong indent, a tab, characters that YAML has not, other encodings,"
                                + " two documents, none: each is exit code 2 and one line with file, line and column within a second.",
                        (bench, asked, checks) -> malformed(bench))
                .add(
                        "huge",
                        "200 MB of blanks or lines, and texts just below our limit of 16 MiB, with -Xmx256m: exit code 2 or 4 or a"
                                + " picture, within 5 s.",
                        (bench, asked, checks) -> huge(bench, checks))
                .add(
                        "deep",
                        "A hundred thousand lists, mappings, keys, and lists in blocks, one in the other: exit code 2 and one line"
                                + " that names the limit.",
                        (bench, asked, checks) -> deep(bench))
                .add(
                        "aliasbomb",
                        "Lists and mappings that repeat each other up to 9^9 and 2^60 times, and a long list that is repeated often,"
                                + " with -Xmx256m: exit code 2 within 2 s.",
                        (bench, asked, checks) -> aliasBomb(bench))
                .add(
                        "cycle",
                        "An anchor that contains itself, directly or through others, as a value or a key: exit code 2 and one line"
                                + " with the anchors on the way round.",
                        (bench, asked, checks) -> cycle(bench));
    }

    private static void malformed(FaultBench bench) throws IOException, InterruptedException {
        refusesSoon(bench, "an unclosed list", FaultScene.with("objects:", "objects: ["));
        refusesSoon(bench, "an unclosed mapping", FaultScene.with("{diffuse: 0.5}", "{diffuse: 0.5"));
        refusesSoon(bench, "an unclosed quote", FaultScene.with("name: ball", "name: \"ball"));
        refusesSoon(bench, "a tab for an indent", FaultScene.with("      radius", "\tradius"));
        refusesSoon(bench, "a wrong indent", FaultScene.with("      radius", "     radius"));
        refusesSoon(bench, "a missing colon", FaultScene.with(FaultScene.RADIUS, "radius 1"));
        refusesSoon(bench, "a text that ends after a key", FaultScene.TEXT.substring(0, 270));
        refusesSoon(bench, "JSON that ends early", "{\"camera\": {\"from\": [0,");
        refusesSoon(bench, "a null character", FaultScene.with(FaultScene.RADIUS, "radius: \0"));
        refusesSoon(bench, "an alias of nothing", FaultScene.with(FaultScene.RADIUS, "radius: *r"));
        refusesSoon(bench, "a tag", FaultScene.with(FaultScene.RADIUS, "radius: !!float 1"));
        refusesSoon(bench, "a reserved character", "@scene: 1\n" + FaultScene.TEXT);
        refusesSoon(bench, "a version of YAML that is not", "%YAML 3.0\n---\n" + FaultScene.TEXT);
        refusesSoon(bench, "two documents", FaultScene.TEXT + "---\n" + FaultScene.TEXT);
        refusesSoon(bench, "nothing", "");
        byte[] text = FaultScene.TEXT.getBytes(StandardCharsets.UTF_8);
        byte[] broken = text.clone();
        broken[200] = (byte) 0xff;
        refusesSoon(bench, "a byte that is not UTF-8", broken);
        refusesSoon(bench, "UTF-16", FaultScene.TEXT.getBytes(StandardCharsets.UTF_16));
    }

    private static void refusesSoon(FaultBench bench, String what, String text)
            throws IOException, InterruptedException {
        refusesSoon(bench, what, text.getBytes(StandardCharsets.UTF_8));
    }

    private static void refusesSoon(FaultBench bench, String what, byte[] text)
            throws IOException, InterruptedException {
        bench.write("scene.yaml", text);
        bench.refused(what, FaultBench.within(1, bench::render), 2, PLACE, 1);
    }

    private static void huge(FaultBench bench, Checks checks) throws IOException, InterruptedException {
        for (char filler : new char[] {' ', '\n'}) {
            try (OutputStream out = Files.newOutputStream(bench.folder().resolve("scene.yaml"))) {
                byte[] filling = new byte[MEBIBYTE];
                Arrays.fill(filling, (byte) filler);
                for (int i = 0; i < 200; i++) {
                    out.write(filling);
                }
                out.write(("\n" + FaultScene.TEXT).getBytes(StandardCharsets.UTF_8));
            }
            bench.refused("200 MB of " + (filler == ' ' ? "blanks" : "lines"), small(bench, 5), 4, "limit of 16 MiB");
        }
        String filling = "x".repeat(15 * MEBIBYTE);
        for (String text : List.of(
                " ".repeat(15 * MEBIBYTE) + "\n" + FaultScene.TEXT,
                "\n".repeat(15 * MEBIBYTE) + FaultScene.TEXT,
                FaultScene.with("name: ball", "name: " + filling))) {
            bench.scene(text);
            ProgramRun run = small(bench, 5);
            bench.rendered("15 MiB that begin with " + text.substring(0, 3).strip(), run, "");
            checks.atMost("seconds", 5, run.seconds());
        }
        bench.scene(FaultScene.TEXT + "x: [" + "1,".repeat(7 * MEBIBYTE) + "1]");
        bench.refused("seven million numbers", small(bench, 5), 2, "more values than the limit");
    }

    private static ProgramRun small(FaultBench bench, double seconds) throws IOException, InterruptedException {
        return FaultBench.within(seconds, () -> bench.render(bench.program().with("-Xmx256m")));
    }

    private static void deep(FaultBench bench) throws IOException, InterruptedException {
        int depth = 100_000;
        for (String text : List.of(
                "[".repeat(depth) + "]".repeat(depth),
                "[".repeat(depth),
                "{a: ".repeat(depth) + "1" + "}".repeat(depth),
                "{\"a\":".repeat(depth),
                "- ".repeat(depth) + "1",
                "? ".repeat(depth) + "1",
                FaultScene.with("objects:", "objects: " + "[{sphere: ".repeat(depth / 2)),
                FaultScene.TEXT + "x: " + "[".repeat(51) + "]".repeat(51))) {
            String start = text.substring(0, 10).strip();
            bench.refuses(
                    "nested, from " + start + " on", text, 2, PLACE + "nested deeper than the limit of 50 levels");
        }
    }

    private static void aliasBomb(FaultBench bench) throws IOException, InterruptedException {
        StringBuilder lists = new StringBuilder("a0: &a0 [1, 2, 3, 4, 5, 6, 7, 8, 9]\n");
        StringBuilder mappings = new StringBuilder("a0: &a0 {x: 1}\n");
        for (int i = 1; i <= 9; i++) {
            lists.append(String.format("a%d: &a%d [%s]%n", i, i, ("*a" + (i - 1) + ", ").repeat(9)));
        }
        for (int i = 1; i < 60; i++) {
            mappings.append(String.format("a%d: &a%d {x: *a%d, y: *a%d}%n", i, i, i - 1, i - 1));
        }
        String often = "a: &a [" + "1, ".repeat(40_000) + "1]\nb: [" + "*a, ".repeat(40_000) + "*a]\n";
        for (String bomb : List.of(lists.toString(), mappings.toString(), often)) {
            bench.scene(bomb + FaultScene.TEXT);
            String what = "aliases that begin with " + bomb.substring(0, 14);
            bench.refused(what, small(bench, 2), 2, PLACE + "more values than the limit", 2);
        }
    }

    private static void cycle(FaultBench bench) throws IOException, InterruptedException {
        String[][] cycles = {
            {"an item of itself", FaultScene.with("objects:", "objects: &a\n  - *a"), "a -> a"},
            {"a value of itself", FaultScene.with("materials:", "materials: &all\n  mine: *all"), "all -> all"},
            {"a key of itself", "x: &a {*a : 1}\n" + FaultScene.TEXT, "a -> a"},
            {"by way of another", "x: &a {y: &b {z: *a}}\n" + FaultScene.TEXT, "a -> b -> a"},
            {"in two ways", "x: &a [&b [*a, *b]]\n" + FaultScene.TEXT, "a -> b -> a"},
            {"the whole document", "&r\n" + FaultScene.TEXT + "x: *r\n", "r -> r"},
        };
        for (String[] cycle : cycles) {
            bench.refuses(cycle[0], cycle[1], 2, PLACE + "\\*\\w+ stands inside what it names: " + cycle[2]);
        }
    }
}
