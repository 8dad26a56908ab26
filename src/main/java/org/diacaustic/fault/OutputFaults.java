package org.diacaustic.fault;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.math.BigDecimal;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import javax.imageio.ImageIO;
import org.diacaustic.image.ImageFiles;
import org.diacaustic.image.LinearImage;
import org.diacaustic.json.JsonWriter;
import org.diacaustic.stability.Checks;

/** What is written, as others read it. */
final class OutputFaults {
    /** What must not depend on the user. */
    private static final String[] WORDS = {"picture", "statistics", "output", "progress", "message"};

    private OutputFaults() {}

    static void addTo(FaultOperations operations) {
        operations
                .add(
                        "validimages",
                        "Pictures of 1x1 to 300x9 pixels, written by renders: PNG read by the reader of the JDK and by a plain one with all"
                                + " checksums, TGA, HDR and PFM by our readers and by plain ones, EXR by ours: the same codes and floats.",
                        (bench, asked, checks) -> pictures(bench, checks))
                .add(
                        "statsjson",
                        "--stats of renders without an error estimate, with samples that are not finite, of 10^12 planned rays that is stopped, with"
                                + " the least long as seed, and --progress json: read by a strict reader; JsonWriter with NaN, infinities, -0.0, the"
                                + " extreme longs and odd texts.",
                        (bench, asked, checks) -> statistics(bench, checks))
                .add(
                        "locale",
                        "German, Turkish, Arabic, Hindi and Thai users, by LANG and by the virtual machine's own words: the picture, the statistics"
                                + " and the numbers in messages are those of an American; files and folders named in other scripts are found.",
                        (bench, asked, checks) -> locales(bench, checks));
    }

    private static void pictures(FaultBench bench, Checks checks) throws IOException, InterruptedException {
        bench.scene(FaultScene.TEXT);
        for (String size : List.of("1x1", "7x5", "8x3", "300x9")) {
            for (String ending : List.of("png", "tga", "hdr", "pfm", "exr")) {
                picture(bench, checks, size, ending);
            }
        }
    }

    private static void picture(FaultBench bench, Checks checks, String size, String ending)
            throws IOException, InterruptedException {
        String name = "out." + ending;
        bench.program().run("render", "scene.yaml", "-o", name, "--size", size);
        Path file = bench.folder().resolve(name);
        byte[] bytes = Files.readAllBytes(file);
        LinearImage ours = ImageFiles.read(file);
        String what = size + " as " + name;
        checks.same(what + ": size", size, ours.width() + "x" + ours.height());
        switch (ending) {
            case "png" ->
                checks.holds(
                        what + ": JDK and plain reader agree",
                        PlainPng.read(bytes).isSameAs(PlainPicture.of(ImageIO.read(new ByteArrayInputStream(bytes)))));
            case "tga" -> checks.holds(what + ": two readers agree", isSame(PlainReaders.targa(bytes), ours));
            case "hdr" ->
                checks.holds(what + ": two readers agree", isSameRadiance(PlainReaders.radiance(bytes), ours));
            case "pfm" ->
                checks.holds(
                        what + ": two readers agree",
                        Arrays.equals(PlainReaders.floatMap(bytes, ours.width(), ours.height()), ours.samples()));
            default -> checks.holds(what + ": whole", FaultBench.isWhole(file));
        }
        Files.delete(file);
    }

    /** Whether codes are those that our reader made light of. */
    private static boolean isSame(PlainPicture codes, LinearImage ours) {
        for (int i = 0; i < codes.codes().length; i++) {
            double code = (codes.codes()[i] & 0xff) / 255.0;
            double light = code <= 0.04045 ? code / 12.92 : StrictMath.pow((code + 0.055) / 1.055, 2.4);
            if (Math.abs(light - ours.samples()[i]) > 1e-6) {
                return false;
            }
        }
        return codes.codes().length == ours.samples().length;
    }

    private static boolean isSameRadiance(PlainPicture codes, LinearImage ours) {
        for (int pixel = 0; pixel < codes.width() * codes.height(); pixel++) {
            int exponent = codes.codes()[4 * pixel + 3] & 0xff;
            for (int channel = 0; channel < 3; channel++) {
                int code = codes.codes()[4 * pixel + channel] & 0xff;
                // Readers differ in whether a code means the middle or the lower end of its step.
                double step = exponent == 0 ? 0 : StrictMath.scalb(1.0, exponent - 136);
                double light = ours.samples()[3 * pixel + channel];
                if (light < code * step || light > (code + 1) * step) {
                    return false;
                }
            }
        }
        return codes.width() == ours.width() && codes.height() == ours.height();
    }

    private static void statistics(FaultBench bench, Checks checks) throws IOException, InterruptedException {
        bench.scene(FaultScene.TEXT);
        Map<String, Object> plain = stats(bench, "--map", "none", "--seed=-9223372036854775808");
        requireNull(checks, "an error that is not estimated", plain, "/errorEstimate");
        checks.same("the seed", new BigDecimal(Long.MIN_VALUE), plain.get("/seed"));
        checks.same(
                "planned light rays",
                new BigDecimal("1000000000000"),
                interrupted(bench).get("/counters/plannedLightRays"));
        bench.scene(FaultScene.with("intensity: 100", "intensity: 1e308"));
        Map<String, Object> infinite = stats(bench);
        checks.holds(
                "samples that are not finite are counted",
                infinite.get("/counters/nonFiniteSamples") instanceof BigDecimal count && count.signum() > 0);
        bench.scene(FaultScene.TEXT);
        for (String line :
                bench.render("--progress", "json", "--size", "160x160").errorLines()) {
            checks.holds("a line of progress is JSON", StrictJson.values(line).get("/percent") instanceof BigDecimal);
        }
        String odd = "\"\\\b\f\n\r\t\0\u007f/\u00e9\ud83d\ude00\ud800";
        String written = new JsonWriter()
                .beginObject()
                .put("nan", Double.NaN)
                .put("more", Double.POSITIVE_INFINITY)
                .put("less", Double.NEGATIVE_INFINITY)
                .put("zero", -0.0)
                .put("tiny", Double.MIN_VALUE)
                .put("large", Double.MAX_VALUE)
                .put("most", Long.MAX_VALUE)
                .put("least", Long.MIN_VALUE)
                .put("text", odd)
                .end()
                .toString();
        Map<String, Object> read = StrictJson.values(written);
        for (String name : List.of("nan", "more", "less")) {
            requireNull(checks, "JSON of what is not finite: " + name, read, "/" + name);
        }
        checks.same("the largest long", new BigDecimal(Long.MAX_VALUE), read.get("/most"));
        checks.same("the least long", new BigDecimal(Long.MIN_VALUE), read.get("/least"));
        checks.same("the largest double", Double.MAX_VALUE, ((BigDecimal) read.get("/large")).doubleValue());
        checks.same("the least double", Double.MIN_VALUE, ((BigDecimal) read.get("/tiny")).doubleValue());
        checks.same("an odd text", odd, read.get("/text"));
    }

    /** The statistics of a render of 10^12 light rays, all of which are absorbed, that was stopped. */
    private static Map<String, Object> interrupted(FaultBench bench) throws IOException, InterruptedException {
        bench.scene(FaultScene.with(FaultScene.IOR, "ior: 1.5, absorption: 1e300"));
        Object[] arguments = FaultBench.renderArguments(
                "--rays",
                "1000000000000",
                "--map",
                "photon-map",
                "-D",
                "light-reflections=false",
                "--stats",
                "stats.json");
        try (RunningProgram running = bench.program().start(arguments)) {
            running.awaitWork(4);
            running.signal("INT");
            running.await();
        }
        return takeStats(bench);
    }

    private static void requireNull(Checks checks, String what, Map<String, Object> values, String path) {
        boolean isNull = values.containsKey(path) && values.get(path) == null;
        checks.rule(what, "null", String.valueOf(values.getOrDefault(path, "missing")), isNull);
    }

    private static Map<String, Object> stats(FaultBench bench, Object... more)
            throws IOException, InterruptedException {
        Object[] all = Arrays.copyOf(more, more.length + 2);
        all[more.length] = "--stats";
        all[more.length + 1] = "stats.json";
        bench.render(all);
        return takeStats(bench);
    }

    private static Map<String, Object> takeStats(FaultBench bench) throws IOException {
        Path file = bench.folder().resolve("stats.json");
        Map<String, Object> values = StrictJson.values(Files.readString(file));
        Files.delete(file);
        return values;
    }

    private static void locales(FaultBench bench, Checks checks) throws IOException, InterruptedException {
        bench.scene(FaultScene.TEXT);
        String[] american = words(bench, bench.program().with("-Duser.language=en", "-Duser.country=US"));
        String[][] users = {{"de", "DE"}, {"tr", "TR"}, {"ar", "EG"}, {"hi", "IN"}};
        for (String[] user : users) {
            Program program = bench.program()
                    .with("-Duser.language=" + user[0], "-Duser.country=" + user[1])
                    .in("LANG", user[0] + "_" + user[1] + ".UTF-8")
                    .in("LC_ALL", user[0] + "_" + user[1] + ".UTF-8");
            String[] words = words(bench, program);
            for (int i = 0; i < words.length; i++) {
                checks.same(user[0] + "_" + user[1] + ": " + WORDS[i], american[i], words[i]);
            }
        }
        Program digits = bench.program().with("-Duser.language=th", "-Duser.country=TH", "-Duser.variant=TH");
        checks.same("Thai digits: " + WORDS[1], american[1], words(bench, digits)[1]);
        for (String name : List.of("Szene äöü.yaml", "場面.yaml", "-two  blanks.yaml", "%s$HOME;'.yaml")) {
            bench.write(name, FaultScene.TEXT);
            Program program = bench.program().in("LC_ALL", "C.UTF-8");
            ProgramRun run = program.run("render", "./" + name, "-o", "./" + name + ".png");
            Path picture = bench.folder().resolve(name + ".png");
            checks.rule(
                    name + " is found",
                    "exit 0, a whole picture beside it",
                    run.toString(),
                    run.code() == 0 && FaultBench.isWhole(picture));
        }
    }

    private static String[] words(FaultBench bench, Program program) throws IOException, InterruptedException {
        Path stats = bench.folder().resolve("stats.json");
        ProgramRun run = bench.render(
                program, "--stats", "stats.json", "--exposure", "1234.5", "--progress", "json", "--size", "160x40");
        String picture = run.code() == 0
                ? Integer.toHexString(
                        Arrays.hashCode(Files.readAllBytes(bench.folder().resolve(FaultBench.PICTURE))))
                : run.toString();
        Map<String, Object> values = StrictJson.values(Files.readString(stats));
        String counted =
                values.get("/exposure") + " " + values.get("/energy/emitted") + " " + values.get("/counters/eyeRays");
        ProgramRun refused = bench.render(program, "-D", "exposure=-0.5", "-D", "INVALID=1");
        return new String[] {
            picture,
            counted,
            run.output().replaceAll("\\d+\\.\\d\\d s", "TIME"),
            run.errors().replaceAll("\"secondsLeft\": \\d+\\.\\d", "TIME"),
            refused.code() + refused.errors()
        };
    }
}
