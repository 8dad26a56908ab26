package org.diacaustic.trial;

import java.util.List;
import java.util.Locale;
import org.diacaustic.light.PointLight;
import org.diacaustic.material.ConstantTexture;
import org.diacaustic.material.Material;
import org.diacaustic.material.Medium;
import org.diacaustic.math.Color;
import org.diacaustic.math.Vector3;
import org.diacaustic.preprocess.EnergyLedger;
import org.diacaustic.scene.Scene;
import org.diacaustic.scene.Settings;
import org.diacaustic.shape.Box;
import org.diacaustic.shape.Plane;
import org.diacaustic.shape.Sphere;
import org.diacaustic.stability.CaseFault;
import org.diacaustic.stability.Checks;
import org.diacaustic.stability.NumericCase;
import org.diacaustic.stability.Operations;

/** Beer's law. */
final class AbsorptionTrials {
    private static final long RAYS = 200;
    private static final double SINE = 0.6;
    private static final double COSINE = 0.8;

    private AbsorptionTrials() {}

    static void addTo(Operations operations) {
        operations.add(
                "beer",
                "What a medium leaves of a path, and what it takes; the latter also as the ledger of a forward pass books it whose"
                        + " light stands in the middle of a ball of the medium, where that can be built.",
                AbsorptionTrials::beer);
        operations.add(
                "beer_edge",
                "What is to be rejected must be refused by the medium and by the scene file, with a message that says"
                        + " absorption; else the transmittance is compared.",
                AbsorptionTrials::edge);
        operations.add(
                "beer_segments",
                "An eye ray in an absorbing medium goes to and fro between two mirrors, as often as there are segments, to a"
                        + " wall that glows: a path of the length that is asked.",
                AbsorptionTrials::segments);
    }

    private static void beer(NumericCase asked, Checks checks) {
        double sigma = asked.inputs().number("sigma");
        double distance = asked.inputs().number("distance");
        checks.size(1);
        checks.number("T", Medium.transmittance(sigma, distance));
        checks.number("absorbed_fraction", Medium.absorbed(sigma, distance), "absorbed");
        if (distance > 0x1p-300 && distance < 0x1p300) {
            EnergyLedger ledger = ledgerOfBall(new Medium(1, Color.grey(sigma), 0), distance);
            checks.number(
                    "absorbed as booked",
                    asked.expected().decimal("absorbed_fraction"),
                    ledger.absorbed() / ledger.emitted(),
                    "absorbed");
        }
    }

    private static EnergyLedger ledgerOfBall(Medium medium, double radius) {
        Scene scene = Scene.builder()
                .camera(Stage.eye(Vector3.ZERO, Vector3.UNIT_X))
                .light(new PointLight(Vector3.ZERO, Color.WHITE))
                .object("ball", new Sphere(Vector3.ZERO, radius), Stage.clear(medium))
                .object("floor", new Plane(new Vector3(0, -4 * radius, 0), Vector3.UNIT_Y), Stage.WHITE)
                .build();
        return LightRun.of(scene, Settings.physical(), "random", RAYS).ledger();
    }

    private static void edge(NumericCase asked, Checks checks) {
        double sigma = asked.inputs().number("sigma");
        String result = asked.expected().text("result").toLowerCase(Locale.ROOT);
        if (result.startsWith("t=")) {
            double expected = leadingNumber(result.substring(2));
            double got = Medium.transmittance(sigma, asked.inputs().number("distance"));
            checks.number("T", expected, got, 4 * Math.ulp(expected));
        } else if (result.contains("reject")) {
            checks.holds("the medium refuses", isRefused(sigma));
            List<String> faults = Stage.faults(sceneWith(sigma));
            checks.holds(
                    "the scene file is refused for its absorption",
                    faults.stream().anyMatch(fault -> fault.contains("absorption")));
        } else {
            throw new CaseFault("expected.result should begin with T= or speak of rejection, but is " + result);
        }
    }

    private static double leadingNumber(String text) {
        String number = text.split("[^-+.0-9e]", 2)[0];
        try {
            return Double.parseDouble(number);
        } catch (NumberFormatException notOne) {
            throw new CaseFault("expected.result should name a number after T=, but is T=" + text);
        }
    }

    private static boolean isRefused(double absorption) {
        try {
            new Medium(1, Color.grey(absorption), 0);
            return false;
        } catch (IllegalArgumentException refused) {
            return refused.getMessage().contains("absorption");
        }
    }

    private static String sceneWith(double absorption) {
        return "{camera: {from: [0, 0, 5], to: [0, 0, 0]}, objects: [{sphere: {at: [0, 0, 0], radius: 1,"
                + " material: {transparency: 1, absorption: " + Stage.yaml(absorption) + "}}}]}";
    }

    private static void segments(NumericCase asked, Checks checks) {
        double distance = asked.inputs().number("distance");
        int count = (int) Math.min(asked.inputs().integer("segments"), 10_000_000);
        double apart = COSINE * distance / count;
        double wall = SINE * distance;
        double space = 2 * distance;
        Material mirror = Material.builder().reflectivity(Color.WHITE).build();
        Material glow = Material.builder()
                .diffuse(Color.WHITE)
                .ambient(new ConstantTexture(Color.WHITE))
                .build();
        Medium medium = new Medium(1, Color.grey(asked.inputs().number("sigma")), 0);
        Vector3 direction = new Vector3(SINE, COSINE, 0);
        Scene scene = Scene.builder()
                .camera(Stage.eye(Vector3.ZERO, direction))
                .object("above", new Plane(new Vector3(0, 0.5 * apart, 0), new Vector3(0, -1, 0)), mirror)
                .object("below", new Plane(new Vector3(0, -0.5 * apart, 0), Vector3.UNIT_Y), mirror)
                .object("wall", new Plane(new Vector3(wall, 0, 0), new Vector3(-1, 0, 0)), glow)
                .object(
                        "medium",
                        new Box(new Vector3(-space, -space, -space), new Vector3(space, space, space)),
                        Stage.clear(medium))
                .build();
        var probe = Stage.probe(scene, Stage.plainLight().maxDepth(count + 8));
        checks.size(1).number("T", probe.along(direction, 0).green());
        checks.note("mirrored " + probe.counters().reflectionRays() + " times");
    }
}
