package org.diacaustic.fault;

import java.io.IOException;
import org.diacaustic.stability.Checks;

/** Keys that are not known or are there twice, and values of another kind than asked for. */
final class KeyFaults {
    private static final String PLACE = "^scene\\.yaml:\\d+:\\d+: ";
    private static final String RADIUS_AT = PLACE + "objects\\[0\\]\\.sphere\\.radius: ";

    private KeyFaults() {}

    static void addTo(FaultOperations operations) {
        operations
                .add(
                        "unknownkey",
                        "A key that is misspelt, in each part of a scene, in another case, on the command line: exit code 2 and the key"
                                + " that was meant.",
                        (bench, asked, checks) -> unknownKey(bench))
                .add(
                        "duplicatekey",
                        "A key twice, in blocks and in brackets, quoted once, of objects, materials and the whole scene: exit code 2,"
                                + " one place and the line of the other.",
                        (bench, asked, checks) -> duplicateKey(bench))
                .add(
                        "type",
                        "Texts, flags, lists, mappings, dates and nothing for numbers, and the like for other kinds: exit code 2 with"
                                + " the path of the key, what was expected and what was found.",
                        (bench, asked, checks) -> type(bench))
                .add(
                        "yamlnumbers",
                        "Numbers are those of YAML 1.2: 0o17 is 15, 017 is 17; commas, underscores, sixties, yes, on and what is no"
                                + " finite double are refused.",
                        (bench, asked, checks) -> yamlNumbers(bench, checks));
    }

    private static void unknownKey(FaultBench bench) throws IOException, InterruptedException {
        String[][] meant = {
            {"      material: glass", "      materal: {ior: 1.5}", "material"},
            {FaultScene.RADIUS, "raduis: 1", "radius"},
            {FaultScene.RADIUS, "Radius: 1", "radius"},
            {"from: [0, 2, 6]", "form: [0, 2, 6]", "from"},
            {FaultScene.IOR, "ior: 1.5, absorbtion: 1", "absorption"},
            {"intensity: 100", "intensty: 100", "intensity"},
            {"settings: {rays", "settings: {ray", "rays"},
            {"settings:", "setings:", "settings"},
            {"  - sphere:", "  - shpere:", "sphere"},
        };
        for (String[] one : meant) {
            String scene = FaultScene.with(one[0], one[1]);
            bench.refuses(one[1].strip(), scene, 2, PLACE + ".*did you mean '" + one[2] + "'\\?");
        }
        bench.refuses(
                "nothing alike", FaultScene.with(FaultScene.RADIUS, "zzz: 1\n      radius: 1"), 2, "known here: ");
        bench.scene(FaultScene.TEXT);
        bench.refused("-D sampels=2", bench.render("-D", "sampels=2"), 2, "did you mean 'samples'\\?");
        bench.refused("--sampels 2", bench.render("--sampels", "2"), 2, "did you mean '--samples'\\?");
    }

    private static void duplicateKey(FaultBench bench) throws IOException, InterruptedException {
        String[][] twice = {
            {FaultScene.RADIUS, "radius: 1\n      radius: 2"},
            {FaultScene.RADIUS, "radius: 1\n      radius: 1"},
            {FaultScene.RADIUS, "radius: 1\n      \"radius\": 2"},
            {FaultScene.IOR, "ior: 1.5, ior: 1.6"},
            {"materials:", "materials:\n  glass: {}"},
            {"settings:", "objects: []\nsettings:"},
            {"size: [20, 16]", "size: [20, 16], size: [20, 16]"},
        };
        for (String[] one : twice) {
            String scene = FaultScene.with(one[0], one[1]);
            String pattern = PLACE + ".*the key is there twice; the first is at line \\d+";
            bench.refuses(one[1].replaceAll("\\s*\\R\\s*", " / "), scene, 2, pattern);
        }
    }

    private static void type(FaultBench bench) throws IOException, InterruptedException {
        for (String found : new String[] {"'one'", "true", "{a: 1}", "[1]", "[]", "~", "2020-01-01", "1 m", "'1'"}) {
            String scene = FaultScene.with(FaultScene.RADIUS, "radius: " + found);
            bench.refuses("radius: " + found, scene, 2, RADIUS_AT + "expected a number above 0, found ");
        }
        String[][] others = {
            {"[0, 2, 6]", "6", "camera\\.from: expected a list of 3 numbers, found '6'"},
            {"[0, 2, 6]", "[0, two, 6]", "camera\\.from\\[1\\]: expected a number, found 'two'"},
            {"name: ball", "name: [1]", "name: expected text, found a list"},
            {"lights:\n  - point", "lights:\n    point", "lights: expected a list, found a mapping"},
            {"settings: {rays: 2000}", "settings: many", "settings: expected a mapping of keys to values, found 'many'"
            },
            {FaultScene.RAYS, "fresnel: 1", "settings\\.fresnel: expected true or false, found '1'"},
            {FaultScene.RAYS, "samples: 1.5", "settings\\.samples: expected a whole number .*found '1.5'"},
            {FaultScene.GREY, "diffuse: red", "diffuse: expected a colour, .*found 'red'"},
            {FaultScene.GREY, "diffuse: [1, 2]", "diffuse: expected a colour, .*found a list of 2 values"},
        };
        for (String[] other : others) {
            bench.refuses(other[1].strip(), FaultScene.with(other[0], other[1]), 2, PLACE + ".*" + other[2]);
        }
    }

    private static void yamlNumbers(FaultBench bench, Checks checks) throws IOException, InterruptedException {
        String[][] refused = {
            {FaultScene.IOR, "ior: 1,33", "with a point, not a comma"},
            {FaultScene.RADIUS, "radius: 1,33", "write 1.33, with a point"},
            {FaultScene.RADIUS, "radius: 1_000", "found '1_000'"},
            {FaultScene.RADIUS, "radius: 1:30", "found '1:30'"},
            {FaultScene.RADIUS, "radius: 1e400", "too large for a double"},
            {FaultScene.RADIUS, "radius: 0x1p3", "found '0x1p3'"},
            {FaultScene.RADIUS, "radius: Infinity", "found 'Infinity'"},
            {FaultScene.RADIUS, "radius: .inf", "not a finite number"},
            {FaultScene.RADIUS, "radius: 1" + "0".repeat(400), "too large for a double"},
            {FaultScene.RAYS, "seed: 1e999999999", "expected a whole number"},
            {FaultScene.RAYS, "seed: 9223372036854775808", "expected a whole number"},
            {FaultScene.RAYS, "fresnel: on", "text in YAML 1.2"},
            {FaultScene.RAYS, "fresnel: no", "text in YAML 1.2"},
            {FaultScene.RAYS, "on: 1", "settings\\.on: unknown key"},
            {FaultScene.RAYS, "yes: 1", "settings\\.yes: unknown key"},
        };
        for (String[] one : refused) {
            bench.refuses(
                    one[1].substring(0, Math.min(30, one[1].length())), FaultScene.with(one[0], one[1]), 2, one[2]);
        }
        bench.scene(FaultScene.TEXT);
        String[][] same = {{"0o17", "15"}, {"0x10", "16"}, {"017", "17"}, {"4.0", "4"}, {"1e1", "10"}};
        for (String[] one : same) {
            ProgramRun run = bench.program().run("plan", "scene.yaml", "-D", "samples=" + one[0]);
            boolean met = run.code() == 0 && run.output().contains(" " + one[1] + " rays a pixel");
            checks.rule(
                    "samples: " + one[0],
                    one[1],
                    run.output()
                            .lines()
                            .filter(line -> line.contains("rays a pixel"))
                            .findFirst()
                            .orElse(run.toString()),
                    met);
        }
    }
}
