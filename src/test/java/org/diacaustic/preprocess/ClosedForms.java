package org.diacaustic.preprocess;

import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleBinaryOperator;
import java.util.function.DoubleUnaryOperator;
import org.diacaustic.light.DirectionalLight;
import org.diacaustic.light.Light;
import org.diacaustic.light.PointLight;
import org.diacaustic.material.Material;
import org.diacaustic.material.Medium;
import org.diacaustic.material.Wave;
import org.diacaustic.math.Color;
import org.diacaustic.math.Vector3;
import org.diacaustic.scene.Scene;
import org.diacaustic.scene.Settings;
import org.diacaustic.shape.Box;
import org.diacaustic.shape.Frustum;
import org.diacaustic.shape.Plane;
import org.diacaustic.shape.Shape;
import org.diacaustic.shape.Sphere;

/** Scenes that light a horizontal floor, object 0, over one optical element, and the irradiance there in closed form. */
final class ClosedForms {
    private static final double UNIT_FLUX = 1 / (4 * Math.PI);

    private ClosedForms() {}

    /**
     * A scene and its answer.
     *
     * @param floor its height
     * @param places x and z of points on it
     * @param reach how far around them it is to be looked at
     * @param irradiance at x and z, in W·m⁻²
     */
    record Form(
            String name,
            Scene scene,
            Settings settings,
            double floor,
            double[][] places,
            double reach,
            DoubleBinaryOperator irradiance) {
        @Override
        public String toString() {
            return name;
        }
    }

    static List<Form> all() {
        return List.of(water(true), plate(0.6), ball(true), cylinder(), wave(true), underWater(), coffeeCup());
    }

    private static Scene scene(Light light, double floor, Shape shape, Material material) {
        return Scene.builder()
                .camera(Forward.camera())
                .light(light)
                .object("floor", new Plane(new Vector3(0, floor, 0), Vector3.UNIT_Y), Forward.MATT)
                .object("element", shape, material)
                .build();
    }

    /** So many refractions, and nothing mirrored. */
    static Settings through(int surfaces, boolean fresnel) {
        return Forward.settings(s -> s.maxDepth(surfaces).followReflections(false)).toBuilder()
                .minimumThroughput(0)
                .fresnel(fresnel)
                .build();
    }

    private static DirectionalLight sun() {
        return new DirectionalLight(new Vector3(0, -1, 0), Color.WHITE, 0);
    }

    private static Light lamp(double height) {
        return new PointLight(new Vector3(0, height, 0), Color.grey(UNIT_FLUX));
    }

    /** The part of unpolarised light that enters a medium n times as dense, at an angle. */
    static double transmittance(double angle, double n) {
        double inside = Math.asin(Math.sin(angle) / n);
        double cosine = Math.cos(angle);
        double cosineInside = Math.cos(inside);
        double s = (cosine - n * cosineInside) / (cosine + n * cosineInside);
        double p = (n * cosine - cosineInside) / (n * cosine + cosineInside);
        return 1 - 0.5 * (s * s + p * p);
    }

    /** Where an increasing function takes a value. */
    private static double inverse(DoubleUnaryOperator function, double value, double low, double high) {
        double a = low;
        double b = high;
        for (int i = 0; i < 60; i++) {
            double middle = 0.5 * (a + b);
            if (function.applyAsDouble(middle) < value) {
                a = middle;
            } else {
                b = middle;
            }
        }
        return 0.5 * (a + b);
    }

    private static double slope(DoubleUnaryOperator function, double x) {
        double step = 1e-4;
        // Of the fourth order.
        return (8 * (function.applyAsDouble(x + step) - function.applyAsDouble(x - step))
                        - (function.applyAsDouble(x + 2 * step) - function.applyAsDouble(x - 2 * step)))
                / (12 * step);
    }

    /** Flat water of n = 1.33, a lamp of flux 1 at 1 above it, a floor at 2 below [numerics RADIOM-04 .. 06]. */
    static Form water(boolean fresnel) {
        double n = 1.33;
        DoubleUnaryOperator radius = angle -> Math.tan(angle) + 2 * Math.tan(Math.asin(Math.sin(angle) / n));
        return new Form(
                "water" + (fresnel ? " of Fresnel" : ""),
                scene(lamp(1), -2, Forward.square(0, 2), Forward.clear(n, 1)),
                through(1, fresnel),
                -2,
                new double[][] {{0, 0}, {0.7, 0}, {1.2, -1.3}, {0, 2.5}},
                0.1,
                fromLamp(radius, angle -> fresnel ? transmittance(angle, n) : 1, n));
    }

    /** E = T · sinθ ÷ (4π · r · dr/dθ); near the axis r is proportional to θ. */
    private static DoubleBinaryOperator fromLamp(DoubleUnaryOperator radius, DoubleUnaryOperator factor, double n) {
        return (x, z) -> {
            double angle = Math.max(1e-3, inverse(radius, Math.hypot(x, z), 0, 1.5));
            double spread = radius.applyAsDouble(angle) * slope(radius, angle);
            return UNIT_FLUX * factor.applyAsDouble(angle) * Math.sin(angle) / spread;
        };
    }

    /** A plate of n = 1.5, 0.5 thick, between a lamp of flux 1 at 1 above it and a floor at 1 below [RADIOM-07, 08]. */
    static Form plate(double absorption) {
        double n = 1.5;
        DoubleUnaryOperator inside = angle -> Math.asin(Math.sin(angle) / n);
        DoubleUnaryOperator radius = angle -> 2 * Math.tan(angle) + 0.5 * Math.tan(inside.applyAsDouble(angle));
        DoubleUnaryOperator factor = angle -> Math.pow(transmittance(angle, n), 2)
                * Math.exp(-absorption * 0.5 / Math.cos(inside.applyAsDouble(angle)));
        Material glass = Material.builder()
                .transparency(Color.WHITE)
                .inside(new Medium(n, Color.grey(absorption), 0))
                .build();
        return new Form(
                "plate of absorption " + absorption,
                scene(lamp(2.5), 0, new Box(new Vector3(-2, 1, -2), new Vector3(2, 1.5, 2)), glass),
                through(2, true),
                0,
                new double[][] {{0, 0}, {0.8, 0}, {1, -1}, {0, 1.8}},
                0.1,
                fromLamp(radius, factor, n));
    }

    /** How far from the axis a parallel ray at h lands behind a unit ball or cylinder of n = 1.5; beyond its crossing: < 0. */
    static double landing(double h, double distance) {
        double deviation = 2 * (Math.asin(h) - Math.asin(h / 1.5));
        return (h - distance * Math.sin(deviation)) / Math.cos(deviation);
    }

    /** A unit ball of glass in the sun, and a floor at 3 below its middle: E = T² · h · dh ÷ (r · dr) [OPTICS-03]. */
    static Form ball(boolean fresnel) {
        DoubleUnaryOperator radius = h -> -landing(h, 3);
        return new Form(
                "ball" + (fresnel ? " of Fresnel" : ""),
                ballOver(3),
                through(2, fresnel),
                -3,
                new double[][] {{0, 0}, {0.32246631149, 0}, {0.4, -0.4}, {0, 0.83027554613}},
                0.1,
                (x, z) -> {
                    double h = Math.max(1e-3, inverse(radius, Math.hypot(x, z), 0, 0.999));
                    double passed = fresnel ? Math.pow(transmittance(Math.asin(h), 1.5), 2) : 1;
                    return passed * h / (radius.applyAsDouble(h) * slope(radius, h));
                });
    }

    /** A unit ball of glass in the sun, and a floor so far below its middle. */
    static Scene ballOver(double distance) {
        return scene(sun(), -distance, new Sphere(Vector3.ZERO, 1), Forward.clear(1.5, 1));
    }

    /** A unit cylinder of glass, across the sun: the same in one dimension, E = dh ÷ dx [OPTICS-04]. */
    static Form cylinder() {
        DoubleUnaryOperator landing = h -> -landing(h, 3);
        return new Form(
                "cylinder",
                scene(
                        sun(),
                        -3,
                        Frustum.cylinder(new Vector3(0, 0, -2), new Vector3(0, 0, 2), 1, true),
                        Forward.clear(1.5, 1)),
                through(2, false),
                -3,
                new double[][] {{0, 0}, {0.45637189814, 0.5}, {-0.7, -1}},
                0.1,
                (x, z) -> 1 / slope(landing, inverse(landing, Math.abs(x), 0, 0.999)));
    }

    /**
     * The thesis' wave, a bump 0.05 · sin 4x of flat water of n = 1.33, under the sun, and a floor at 1 below. A ray at x goes
     * towards the normal of slope 0.2 · cos 4x, and lands at X: E = T · dx ÷ dX [OPTICS-07].
     */
    static Form wave(boolean fresnel) {
        double n = 1.33;
        DoubleUnaryOperator tilt = x -> Math.atan(0.2 * Math.cos(4 * x));
        DoubleUnaryOperator landing = x -> {
            double angle = tilt.applyAsDouble(x);
            return x + Math.tan(angle - Math.asin(Math.sin(angle) / n));
        };
        Material water = Material.builder()
                .transparency(Color.WHITE)
                .inside(Medium.of(n))
                .bump(new Wave(Vector3.UNIT_X, 4, 0.05, 0))
                .build();
        return new Form(
                "wave" + (fresnel ? " of Fresnel" : ""),
                scene(sun(), -1, Forward.square(0, 2), water),
                through(1, fresnel),
                -1,
                new double[][] {{Math.PI / 8, 0}, {-Math.PI / 8, 0.3}, {0.1, -0.5}, {0.9, 1}},
                0.05,
                (x, z) -> {
                    double from = inverse(landing, x, x - 0.5, x + 0.5);
                    double angle = Math.abs(tilt.applyAsDouble(from));
                    return (fresnel ? transmittance(angle, n) : 1) / slope(landing, from);
                });
    }

    /**
     * A lamp of flux 1 in water, 2 below its surface, and the floor 2 below the lamp: light that is mirrored comes as from 2 above.
     * Outside of Snell's window, from a radius of 6 · tan 48.75° = 6.84 on, that is all of it [OPTICS-01].
     */
    static Form underWater() {
        double n = 1.33;
        double critical = Math.asin(1 / n);
        return new Form(
                "under water",
                lampIn(n),
                mirrored(),
                -4,
                new double[][] {{3, 0}, {4, -5}, {0, 7.2}, {7, 7}},
                0.1,
                (x, z) -> {
                    double angle = Math.atan(Math.hypot(x, z) / 6);
                    double outside = Math.asin(Math.min(1, n * Math.sin(angle)));
                    double mirrored = angle < critical ? 1 - transmittance(outside, n) : 1;
                    return UNIT_FLUX * mirrored * Math.pow(Math.cos(angle), 3) / 36;
                });
    }

    static Scene lampIn(double n) {
        return scene(lamp(-2), -4, Forward.square(0, 4), Forward.clear(n, 1));
    }

    static Settings mirrored() {
        return Forward.settings(s -> s.maxDepth(1)).toBuilder()
                .minimumThroughput(0)
                .build();
    }

    /**
     * A cup of mirror, of radius 1, in the sun, which comes in over the rim along x and goes down by half as much. Seen from
     * above, a ray at z = sinθ meets the wall at (cosθ, sinθ), goes back as (−cos 2θ, −sin 2θ), and is t on when it comes to the
     * floor: E = sinα ÷ |1 − 2t ÷ cosθ|, summed over all θ that come to a point. That is endless on a nephroid, with its cusp
     * half way from the middle to the wall [OPTICS-06].
     */
    static Form coffeeCup() {
        Light light = new DirectionalLight(new Vector3(1, -0.5, 0), Color.WHITE, 0);
        Material mirror = Material.builder().reflectivity(Color.WHITE).build();
        return new Form(
                "coffee cup",
                scene(light, 0, Frustum.cylinder(Vector3.ZERO, new Vector3(0, 0.6, 0), 1, false), mirror),
                mirrored().toBuilder().fresnel(false).build(),
                0,
                new double[][] {{0, 0}, {0.3, 0}, {0.35, 0.1}, {0.6, 0}, {0.65, 0.01}},
                0.02,
                ClosedForms::inCup);
    }

    private static double inCup(double x, double z) {
        double sine = 0.5 / Math.sqrt(1.25);
        double sum = 0;
        int steps = 401;
        // Farther aside the rim keeps the sun from the lower wall.
        double widest = Math.asin(0.79);
        for (int i = 0; i < steps; i++) {
            double low = widest * (2.0 * i / steps - 1);
            double high = widest * (2.0 * (i + 1) / steps - 1);
            double atLow = beside(low, x, z);
            if (atLow * beside(high, x, z) < 0) {
                double theta = inverse(angle -> -Math.signum(atLow) * beside(angle, x, z), 0, low, high);
                double t = (Math.cos(theta) - x) * Math.cos(2 * theta) + (Math.sin(theta) - z) * Math.sin(2 * theta);
                sum += sine / Math.abs(1 - 2 * t / Math.cos(theta));
            }
        }
        return sum;
    }

    /** How far to the side of a point the ray of θ goes by. */
    private static double beside(double theta, double x, double z) {
        return (Math.cos(theta) - x) * Math.sin(2 * theta) - (Math.sin(theta) - z) * Math.cos(2 * theta);
    }

    /** The mean over a square. */
    static double mean(Form form, double x, double z, double half) {
        double sum = 0;
        for (int i = 0; i < 9; i++) {
            double u = Math.sqrt(0.6) * (i / 3 - 1);
            double v = Math.sqrt(0.6) * (i % 3 - 1);
            double weight = (i / 3 == 1 ? 8 : 5) * (i % 3 == 1 ? 8 : 5) / 324.0;
            sum += weight * form.irradiance.applyAsDouble(x + u * half, z + v * half);
        }
        return sum;
    }

    /** The mean over a disc, over rings of equal area. */
    static double meanOverDisc(Form form, double x, double z, double radius) {
        int rings = 12;
        int spokes = 24;
        List<Double> values = new ArrayList<>();
        for (int i = 0; i < rings; i++) {
            double r = radius * Math.sqrt((i + 0.5) / rings);
            for (int k = 0; k < spokes; k++) {
                double angle = 2 * Math.PI * (k + 0.5 * (i % 2)) / spokes;
                values.add(form.irradiance.applyAsDouble(x + r * Math.cos(angle), z + r * Math.sin(angle)));
            }
        }
        return values.stream().mapToDouble(value -> value).average().getAsDouble();
    }
}
