package org.diacaustic.trial;

import java.util.ArrayList;
import java.util.List;
import org.diacaustic.material.Material;
import org.diacaustic.material.Medium;
import org.diacaustic.material.ScatterRules;
import org.diacaustic.math.Color;
import org.diacaustic.math.Vector3;
import org.diacaustic.scene.SceneObject;
import org.diacaustic.shape.Box;
import org.diacaustic.shape.Sphere;
import org.diacaustic.stability.Checks;
import org.diacaustic.stability.NumericCase;
import org.diacaustic.stability.Operations;
import org.diacaustic.stability.Values;

/** Thin layers and thin gaps on the way of one ray. */
final class LayerTrials {
    private static final ScatterRules NO_FRESNEL =
            new ScatterRules(false, false, true, ScatterRules.BackFacingBump.BEND);

    private LayerTrials() {}

    static void addTo(Operations operations) {
        operations.add(
                "slab_stack",
                "So many glass Boxes one below the other, through which a PathTracer follows a refracted ray that starts one gap above"
                        + " the first; x_travel is how far aside it leaves the last. Without Fresnel, so that something is left"
                        + " after thousands of surfaces.",
                LayerTrials::stack);
        operations.add(
                "thin_slab",
                "A Box of that glass, through which a PathTracer follows a refracted ray. Lateral shift: how far off the line of the"
                        + " incident ray the point is where it leaves, with the tolerance of the path. Beer: what the medium leaves"
                        + " of the light on the way; the transmittance of both surfaces together has its tolerance.",
                LayerTrials::slab);
        operations.add(
                "nested_spheres",
                "A sphere of glass with an opaque one inside, met by a PathTracer's ray; the index of the glass is 1, which bends"
                        + " nothing, unless the case names one. Lengths of the path in place of t.",
                LayerTrials::nested);
    }

    private static void stack(NumericCase asked, Checks checks) {
        int slabs = (int) asked.inputs().integer("slabs");
        double thickness = asked.inputs().number("thickness");
        double gap = asked.inputs().number("gap");
        Vector3 direction = RootTrials.vector(asked.inputs(), "I").normalized();
        double aside = Math.hypot(direction.x(), direction.z()) / Math.abs(direction.y());
        double period = thickness + gap;
        double wide = (2 + 2 * aside) * slabs * period;
        Material glass = glass(asked.inputs().number("n"), 0);
        List<SceneObject> objects = new ArrayList<>();
        for (int i = 0; i < slabs; i++) {
            Vector3 low = new Vector3(-wide, -i * period - thickness, -wide);
            Vector3 high = new Vector3(wide, -i * period, wide);
            objects.add(new SceneObject("slab " + i, new Box(low, high), glass));
        }
        // As far above the first slab as the others are apart; from farther if they are not.
        double before = Math.max(0, thickness - gap) / Math.abs(direction.y());
        Vector3 origin = new Vector3(0, gap, 0).minus(direction.times(gap > 0 ? 0 : before));
        PathRecord path = PathRecord.of(objects, NO_FRESNEL, 4 * slabs + 4, origin, direction);
        List<PathRecord.Event> events = path.events();
        checks.same("interface_events", asked.expected().integer("interface_events"), (long) events.size());
        checks.numbers("direction_out", coordinates(path.lastDirection()), "direction");
        checks.size(wide);
        if (!events.isEmpty()) {
            checks.number("x_travel", events.get(events.size() - 1).point().x(), "x");
        }
    }

    private static void slab(NumericCase asked, Checks checks) {
        Values inputs = asked.inputs();
        double top = inputs.number("y_top");
        double bottom = inputs.number("y_bottom");
        double entryX = inputs.number("entry_x");
        double sigma = inputs.number("sigma", 0);
        double angle = StrictMath.toRadians(inputs.number("angle_deg"));
        Vector3 direction = new Vector3(StrictMath.sin(angle), -StrictMath.cos(angle), 0);
        double wide = 1 + 64 * (top - bottom);
        Box box = new Box(new Vector3(entryX - wide, bottom, -wide), new Vector3(entryX + wide, top, wide));
        List<SceneObject> objects = List.of(new SceneObject("slab", box, glass(inputs.number("n"), sigma)));
        Vector3 entry = new Vector3(entryX, top, 0);
        // From not much farther than the slab's own size, as far as coordinates allow to tell the difference.
        double size = Math.max(top - bottom, Math.max(Math.abs(entryX), Math.max(Math.abs(top), Math.abs(bottom))));
        Vector3 origin = entry.minus(direction.times(Math.min(size, 1024 * (top - bottom))));
        PathRecord path = PathRecord.of(objects, ScatterRules.PHYSICAL, 100, origin, direction);
        List<PathRecord.Event> events = path.events();
        checks.size(top - bottom);
        checks.same("interfaces", asked.expected().integer("interfaces"), (long) events.size());
        if (events.size() != 2) {
            return;
        }
        PathRecord.Event in = events.get(0);
        PathRecord.Event out = events.get(1);
        Vector3 across = out.point().minus(in.point());
        double length = out.length() - in.length();
        if (asked.expected().has("thickness_exact")) {
            checks.number("thickness_exact", -across.y(), "path");
        }
        checks.number("path", length);
        checks.number("lateral_shift", across.cross(direction).length(), "path");
        // What leaves was weakened at both surfaces and in between; the record has what arrives at each.
        PathRecord clear = PathRecord.of(
                List.of(new SceneObject("slab", box, glass(inputs.number("n"), 0))),
                ScatterRules.PHYSICAL,
                100,
                origin,
                direction);
        checks.number("beer", out.arriving() / clear.events().get(1).arriving());
        if (asked.expected().has("single_pass_T")) {
            checks.number(
                    "single_pass_T",
                    clear.left() * out.arriving() / clear.events().get(1).arriving(),
                    "beer");
        }
    }

    private static void nested(NumericCase asked, Checks checks) {
        Vector3 origin = RootTrials.vector(asked.inputs(), "origin");
        Vector3 direction = RootTrials.vector(asked.inputs(), "dir").normalized();
        double outer = asked.inputs().number("r_outer");
        double inner = asked.inputs().number("r_inner");
        Vector3 centre = asked.inputs().has("center") ? RootTrials.vector(asked.inputs(), "center") : Vector3.ZERO;
        List<SceneObject> objects = List.of(
                new SceneObject(
                        "glass", new Sphere(centre, outer), glass(asked.inputs().number("n", 1), 0)),
                new SceneObject(
                        "core",
                        new Sphere(centre, inner),
                        Material.builder().diffuse(Color.WHITE).build()));
        PathRecord path = PathRecord.of(objects, ScatterRules.PHYSICAL, 100, origin, direction);
        List<PathRecord.Event> events = path.events();
        checks.size(outer);
        checks.same(
                "objects met",
                "[0, 1]",
                events.stream().map(PathRecord.Event::object).toList().toString());
        if (events.size() == 2) {
            checks.number("t_outer", events.get(0).length(), "t");
            checks.number("t_inner", events.get(1).length(), "t");
            checks.number(
                    "interior_path", events.get(1).length() - events.get(0).length(), "t");
        }
    }

    private static Material glass(double index, double absorption) {
        return Material.builder()
                .transparency(Color.WHITE)
                .inside(new Medium(index, Color.grey(absorption), 0))
                .build();
    }

    private static double[] coordinates(Vector3 v) {
        return new double[] {v.x(), v.y(), v.z()};
    }
}
