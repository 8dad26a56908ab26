package org.diacaustic.trial;

import java.util.function.DoublePredicate;
import java.util.function.DoubleUnaryOperator;
import org.diacaustic.image.LinearImage;
import org.diacaustic.material.Material;
import org.diacaustic.math.Color;
import org.diacaustic.math.Vector3;
import org.diacaustic.render.RenderJob;
import org.diacaustic.render.RenderPlan;
import org.diacaustic.scene.Camera;
import org.diacaustic.scene.MapName;
import org.diacaustic.scene.MapSettings;
import org.diacaustic.scene.Scene;
import org.diacaustic.scene.Settings;
import org.diacaustic.shape.Sphere;
import org.diacaustic.stability.Checks;
import org.diacaustic.stability.NumericCase;
import org.diacaustic.stability.Operations;

/** Edges and rings of light, by rays and in rendered pictures. */
final class ImageTrials {
    /** Pixels from the middle of a picture, which is one row, to its edges. */
    private static final int HALF = 200;

    /** How far a picture reaches, of what is looked for. */
    private static final double MARGIN = 1.5;

    private static final double GOLDEN = 0.5 * (Math.sqrt(5) - 1);
    private static final int SECTIONS = 80;

    /** A window so many times as wide as it is deep is none. */
    private static final double ENDLESS = 0x1p100;

    private ImageTrials() {}

    static void addTo(Operations operations) {
        operations.add(
                "snell_window",
                "The light walk from a point under water to points of its surface, halving until the next double: where the first ray"
                        + " is mirrored wholly. And a picture from there, of a white sky over a black ground: the window ends where"
                        + " pixels turn black.",
                ImageTrials::window);
        operations.add(
                "sphere_caustic_ring",
                "The light walk through a ball onto the plane, by golden section to the entry whose ray lands farthest from the axis:"
                        + " the ring to 1e-9, and where its ray enters to 1e-6 of the radius, for at a fold no more can be told. And"
                        + " a picture of the plane with a caustic mesh: its brightest pixel, in the outer half of the ring, within a"
                        + " pixel.",
                ImageTrials::ring);
    }

    private static void window(NumericCase asked, Checks checks) {
        double depth = asked.inputs().number("depth");
        Material water = OpticalScenes.clear(asked.inputs().number("n"));
        Scene upright = underWater(depth, 1, water);
        double radius = criticalTangent(upright, depth) * depth;
        checks.size(depth).number("radius", radius, "");
        checks.number("critical_deg", StrictMath.toDegrees(StrictMath.atan2(radius, depth)), "");
        if (radius < Double.POSITIVE_INFINITY) {
            LinearImage picture = rendered(underWater(depth, MARGIN * radius / depth, water), Settings.physical());
            int pixel = HALF;
            while (pixel < 2 * HALF && picture.get(pixel, 0).green() > 0) {
                pixel++;
            }
            checks.number("the window's edge, in pixels", HALF / MARGIN, pixel - HALF, 0.5);
        }
    }

    /** Water up to the height 0 under a white sky, a black ground, and an eye that looks up. */
    private static Scene underWater(double depth, double widestTangent, Material water) {
        return Scene.builder()
                .camera(row(-depth, 0, widestTangent))
                .background(Color.WHITE)
                .object(
                        "ground",
                        OpticalScenes.level(-2 * depth),
                        Material.builder().build())
                .object("water", OpticalScenes.level(0), water)
                .build();
    }

    /** One row of pixels, of an eye on the vertical axis that looks along it. */
    private static Camera row(double from, double to, double widestTangent) {
        return Camera.builder()
                .from(new Vector3(0, from, 0))
                .to(new Vector3(0, to, 0))
                .up(new Vector3(0, 0, 1))
                .size(2 * HALF, 1)
                .fieldOfView(2 * StrictMath.toDegrees(StrictMath.atan(widestTangent / (2 * HALF))))
                .build();
    }

    private static LinearImage rendered(Scene scene, Settings settings) {
        return new RenderJob(RenderPlan.of(scene, settings), 1, (done, total) -> {})
                .run()
                .image();
    }

    /**
     * The tangent of the smallest angle at which a ray from so deep below the height 0 is mirrored wholly there; endless if none
     * is.
     */
    static double criticalTangent(Scene scene, double depth) {
        RayWalk walk = RayWalk.in(scene, OpticalScenes.settings(0, true, true));
        Vector3 from = new Vector3(0, -depth, 0);
        return lowest(tangent -> walk.follow(from, new Vector3(tangent, 1, 0)).totalReflections() > 0);
    }

    /** The smallest number of which something is true that is true of all larger ones; endless if it is of none. */
    private static double lowest(DoublePredicate isReached) {
        double high = 1;
        while (!isReached.test(high)) {
            high *= 2;
            if (high > ENDLESS) {
                return Double.POSITIVE_INFINITY;
            }
        }
        double low = 0;
        for (double middle = 0.5 * high; middle > low && middle < high; middle = low + 0.5 * (high - low)) {
            if (isReached.test(middle)) {
                high = middle;
            } else {
                low = middle;
            }
        }
        return high;
    }

    private static void ring(NumericCase asked, Checks checks) {
        double radius = asked.inputs().number("R");
        double distance = asked.inputs().number("plane_from_centre");
        double expected = asked.expected().number("ring_radius");
        double gap = distance - radius;
        Scene scene = OpticalScenes.overFloor(
                row(0.5 * gap - distance, -distance, MARGIN * expected / (0.5 * gap)),
                OpticalScenes.sun(),
                -distance,
                new Sphere(Vector3.ZERO, radius),
                OpticalScenes.clear(asked.inputs().number("n")));
        Settings through = OpticalScenes.through(2, false);
        RayWalk walk = RayWalk.in(scene, through);
        DoubleUnaryOperator landing = aside -> walk.follow(new Vector3(aside, 2 * radius, 0), Vector3.UNIT_Y.negated())
                .landing(-distance);
        double entry = highest(landing, radius);
        checks.size(radius).number("ring_radius", expected, landing.applyAsDouble(entry), 1e-9 * expected);
        checks.number("h_of_ring", asked.expected().number("h_of_ring"), entry, 1e-6 * radius);
        Settings meshed = through.toBuilder()
                .maps(MapSettings.builder().map(MapName.CAUSTIC_MESH).build())
                .build();
        double peak = Math.abs(brightest(rendered(scene, meshed)) + 0.5 - HALF);
        checks.number("the brightest pixel, from the middle", HALF / MARGIN, peak, 1);
    }

    /** Where a function that rises and then falls is highest, between 0 and an end. */
    private static double highest(DoubleUnaryOperator function, double end) {
        double low = 0;
        double high = end;
        for (int i = 0; i < SECTIONS; i++) {
            double left = high - GOLDEN * (high - low);
            double right = low + GOLDEN * (high - low);
            if (function.applyAsDouble(left) < function.applyAsDouble(right)) {
                low = left;
            } else {
                high = right;
            }
        }
        return 0.5 * (low + high);
    }

    /** Beyond the middle, where light that crosses the axis makes a peak of its own. */
    private static int brightest(LinearImage picture) {
        int best = HALF + HALF / 3;
        for (int pixel = best; pixel < 2 * HALF; pixel++) {
            if (picture.get(pixel, 0).green() > picture.get(best, 0).green()) {
                best = pixel;
            }
        }
        return best;
    }
}
