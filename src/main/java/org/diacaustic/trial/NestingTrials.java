package org.diacaustic.trial;

import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.diacaustic.material.Material;
import org.diacaustic.material.Medium;
import org.diacaustic.math.Color;
import org.diacaustic.math.Vector3;
import org.diacaustic.scene.Scene;
import org.diacaustic.scene.SceneObject;
import org.diacaustic.shape.Box;
import org.diacaustic.shape.Plane;
import org.diacaustic.shape.Shape;
import org.diacaustic.shape.Sphere;
import org.diacaustic.stability.CaseFault;
import org.diacaustic.stability.Checks;
import org.diacaustic.stability.NumericCase;
import org.diacaustic.stability.Operations;

/** Transparent objects in, on and over each other. */
final class NestingTrials {
    private static final Pattern INDEX_IN_TEXT = Pattern.compile("n\\s*=?\\s*(\\d+(?:\\.\\d+)?)");
    private static final Pattern EVENT = Pattern.compile("(enter|exit)\\s+(\\w+)\\s+t\\s*=\\s*(\\S+)");
    private static final Pattern NUMBER = Pattern.compile("-?\\d+(?:\\.\\d+)?(?:e-?\\d+)?");
    private static final double GLASS = 1.5;

    private NestingTrials() {}

    static void addTo(Operations operations) {
        operations.add(
                "layer_stack_normal",
                "A path straight through sheets that lie one unit apart, each with a medium on both sides; and, if outside is empty,"
                        + " through boxes that overlap by a quarter, of falling priority.",
                NestingTrials::layers);
        operations.add(
                "nested_priority",
                "A path through two boxes that are as thick as the case says, with priorities in the order that it names.",
                NestingTrials::priority);
        operations.add(
                "camera_inside",
                "Paths from the camera: the media around it are looked for. The critical angle is the largest at which the surface"
                        + " lets light out, by bisection over paths that start off the middle.",
                NestingTrials::inside);
        operations.add(
                "touching_spheres",
                "A path through the two spheres; between them there is a gap without width, of the medium around.",
                NestingTrials::touching);
    }

    private static Scene sceneOf(SceneObject... objects) {
        Scene.Builder scene = Scene.builder().camera(Stage.eye(Vector3.ZERO, Vector3.UNIT_X));
        List.of(objects).forEach(scene::object);
        return scene.build();
    }

    private static SceneObject solid(String name, Shape shape, double index, int priority) {
        return new SceneObject(name, shape, Stage.clear(new Medium(index, Color.BLACK, priority)));
    }

    /** Of unit width, from one x to another. */
    private static Box slab(double from, double to) {
        return new Box(new Vector3(from, -1, -1), new Vector3(to, 1, 1));
    }

    private static void layers(NumericCase asked, Checks checks) {
        double[] indices = asked.inputs().numbers("indices");
        if (indices.length < 2) {
            throw new CaseFault("inputs.indices should hold at least 2 media, but holds " + indices.length);
        }
        SceneObject[] sheets = new SceneObject[indices.length - 1];
        for (int i = 0; i < sheets.length; i++) {
            sheets[i] = new SceneObject(
                    "sheet " + i,
                    new Plane(new Vector3(i, 0, 0), new Vector3(-1, 0, 0)),
                    Material.builder()
                            .transparency(Color.WHITE)
                            .outside(Medium.of(indices[i]))
                            .inside(Medium.of(indices[i + 1]))
                            .build());
        }
        PathRecord crossed = PathRecord.of(sceneOf(sheets).objects(), new Vector3(-1, 0, 0), Vector3.UNIT_X);
        checks.numbers("R_each", crossed.reflectances(), "R");
        checks.number("single_pass_T", crossed.left(), "T");
        boolean isInNothing = indices[0] == 1 && indices[indices.length - 1] == 1;
        if (isInNothing && indices.length > 2) {
            SceneObject[] solids = new SceneObject[indices.length - 2];
            for (int i = 0; i < solids.length; i++) {
                solids[i] = solid("solid " + i, slab(i, i + 1.25), indices[i + 1], solids.length - i);
            }
            PathRecord through = PathRecord.of(sceneOf(solids).objects(), new Vector3(-1, 0, 0), Vector3.UNIT_X);
            checks.numbers("R_each", through.reflectances(), "R");
            checks.number("single_pass_T", through.left(), "T");
            checks.holds("ends outside of all", through.endsInVacuum());
        }
    }

    private static void priority(NumericCase asked, Checks checks) {
        String rule = asked.inputs().text("priority").toLowerCase(Locale.ROOT);
        int glassPriority = rule.startsWith("glass over") ? 2 : 1;
        int waterPriority = rule.startsWith("water over") ? 2 : 1;
        if (glassPriority == waterPriority && !rule.contains("equal")) {
            throw new CaseFault(
                    "inputs.priority should be glass over water, water over glass or equal, but is " + rule);
        }
        double[] glass = asked.inputs().numbers("glass");
        double[] water = asked.inputs().numbers("water");
        Scene scene = sceneOf(
                solid("glass", slab(glass[0], glass[1]), asked.inputs().number("n_glass"), glassPriority),
                solid("water", slab(water[0], water[1]), asked.inputs().number("n_water"), waterPriority));
        double start = Math.min(glass[0], water[0]) - 1;
        PathRecord crossed = PathRecord.of(scene.objects(), new Vector3(start, 0, 0), Vector3.UNIT_X);
        checks.same("interfaces_seen", asked.expected().integer("interfaces_seen"), (long)
                crossed.events().size());
        if (crossed.events().size() > 1) {
            PathRecord.Event boundary = crossed.events().get(1);
            checks.number("boundary_at", boundary.length() + start);
            checks.number("R_at_boundary", boundary.reflectance());
        }
        checks.holds("medium_after_exit: air, nothing entered and not left", crossed.endsInVacuum());
    }

    private static void inside(NumericCase asked, Checks checks) {
        Vector3 camera = Stage.vector(asked.inputs().vector("camera"));
        String text = asked.inputs().text("sphere");
        Matcher numbers = NUMBER.matcher(text);
        double radius = next(numbers, text);
        Vector3 centre = text.contains("origin")
                ? Vector3.ZERO
                : new Vector3(next(numbers, text), next(numbers, text), next(numbers, text));
        double index = asked.inputs().has("n") ? asked.inputs().number("n") : indexIn(asked.title());
        Scene scene = sceneOf(solid("sphere", new Sphere(centre, radius), index, 0));
        Vector3 outward = camera.equals(centre) ? Vector3.UNIT_X : camera.minus(centre);
        PathRecord straight = PathRecord.of(scene.objects(), camera, outward);
        if (straight.events().isEmpty() || camera.minus(centre).length() >= radius) {
            throw new CaseFault("inputs.camera should be inside of the sphere, but is at " + camera);
        }
        PathRecord.Event first = straight.events().get(0);
        checks.holds(
                "first_interface: from the sphere's medium to air",
                first.indexBefore() == index && !first.isEntering() && straight.endsInVacuum());
        checks.number("R_normal", first.reflectance());
        Vector3 aside = outward.perpendicular();
        double low = 0;
        double high = 1;
        for (double middle = 0.5; middle > low && middle < high; middle = low + 0.5 * (high - low)) {
            Vector3 start = centre.plus(aside.times(middle * radius));
            boolean totally = PathRecord.of(scene.objects(), start, outward)
                    .events()
                    .get(0)
                    .isTotal();
            low = totally ? low : middle;
            high = totally ? middle : high;
        }
        checks.number("critical_angle_deg", StrictMath.toDegrees(StrictMath.asin(low)));
    }

    private static double next(Matcher numbers, String text) {
        if (!numbers.find()) {
            throw new CaseFault("inputs.sphere should give a radius, and a centre or the origin, but is " + text);
        }
        return Double.parseDouble(numbers.group());
    }

    /** The index of refraction that a text gives as n=1.5 or n1.5; that of glass if it gives none. */
    private static double indexIn(String text) {
        Matcher given = INDEX_IN_TEXT.matcher(text);
        return given.find() ? Double.parseDouble(given.group(1)) : GLASS;
    }

    private static void touching(NumericCase asked, Checks checks) {
        String transmittance = asked.expected().keys().stream()
                .filter(key -> key.startsWith("T_single_pass"))
                .findFirst()
                .orElseThrow(() -> new CaseFault("the case does not give expected.T_single_pass"));
        double index = asked.inputs().has("n")
                ? asked.inputs().number("n")
                : indexIn(transmittance.substring("T_single_pass".length()));
        double[][] centres = asked.inputs().rows("centers");
        double apart = Stage.vector(centres[0]).minus(Stage.vector(centres[1])).length();
        double radius = asked.inputs().number("radius", 0.5 * apart);
        Scene scene = sceneOf(
                solid("A", new Sphere(Stage.vector(centres[0]), radius), index, 0),
                solid("B", new Sphere(Stage.vector(centres[1]), radius), index, 0));
        PathRecord crossed = PathRecord.of(
                scene.objects(),
                Stage.vector(asked.inputs().vector("origin")),
                Stage.vector(asked.inputs().vector("dir")));
        List<String> events = asked.expected().texts("events");
        checks.same("events", events.size(), crossed.events().size());
        for (int i = 0; i < Math.min(events.size(), crossed.events().size()); i++) {
            Matcher event = EVENT.matcher(events.get(i));
            if (!event.find()) {
                throw new CaseFault("expected.events should say such as enter A t=5, but say " + events.get(i));
            }
            PathRecord.Event got = crossed.events().get(i);
            String what = (got.isEntering() ? "enter " : "exit ")
                    + scene.objects().get(got.object()).name();
            checks.same("event " + i, event.group(1) + " " + event.group(2), what);
            checks.number("t of event " + i, new java.math.BigDecimal(event.group(3)), got.length(), "t");
            checks.number("normal_R_each", got.reflectance());
        }
        checks.number(transmittance, crossed.left());
        checks.note("the gap without width between the spheres is kept");
    }
}
