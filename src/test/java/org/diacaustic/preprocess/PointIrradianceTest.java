package org.diacaustic.preprocess;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.assertj.core.api.Assumptions.assumeThat;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.DoubleUnaryOperator;
import org.diacaustic.light.DirectionalLight;
import org.diacaustic.light.Falloff;
import org.diacaustic.light.Light;
import org.diacaustic.light.PointLight;
import org.diacaustic.light.SphereLight;
import org.diacaustic.map.CausticMesh;
import org.diacaustic.map.FootprintLookup;
import org.diacaustic.map.SurfacePoint;
import org.diacaustic.material.Material;
import org.diacaustic.material.Medium;
import org.diacaustic.material.Wave;
import org.diacaustic.math.Color;
import org.diacaustic.math.Rgb;
import org.diacaustic.math.Vector3;
import org.diacaustic.parallel.Workers;
import org.diacaustic.scene.Scene;
import org.diacaustic.shape.Plane;
import org.diacaustic.shape.Shape;
import org.diacaustic.shape.Sphere;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The mesh of real scenes, asked about points along its light paths: held against closed forms. */
class PointIrradianceTest {
    private static final double WATER = 1.33;
    private static final double GLASS = 1.5;
    private static final int POINTS = 400;

    /** The step of differences of fourth order, of smooth functions of numbers about 1. */
    private static final double STEP = 1e-3;

    private final SplittableRandom random = new SplittableRandom(7);
    private final Rgb found = new Rgb();
    private final SurfacePoint at = MeshLight.on(0, true, Vector3.UNIT_Y);

    static List<Falloff> falloffs() {
        return List.of(new Falloff.None(), new Falloff.InverseSquare(), new Falloff.Polynomial(1, 0.05, 0.002));
    }

    /** @param depth how often light may be mirrored or refracted */
    private static Lookups lookups(Scene scene, String preProcessor, int depth, long rays) {
        Workers workers = new Workers(2);
        ForwardPlan plan = Forward.plan(scene, Forward.settings(s -> s.maxDepth(depth)), preProcessor, rays);
        MeshPass pass =
                new MeshPass(plan, 0, workers, part -> {}).keepingSeeds().run();
        CausticMesh mesh = CausticMesh.movedFrom(pass.cells(), workers);
        return new Lookups(mesh.lookup(pass.lightPaths()), mesh.lookup());
    }

    private static Scene overFloor(Light light, Shape shape, Material material) {
        return Scene.builder()
                .camera(Forward.camera())
                .light(light)
                .object("floor", new Plane(Vector3.ZERO, Vector3.UNIT_Y), Forward.MATT)
                .object("shape", shape, material)
                .build();
    }

    private double ask(FootprintLookup lookup, double x, double z) {
        at.x = x;
        at.z = z;
        lookup.irradiance(at, found);
        return found.green;
    }

    private double askAround(FootprintLookup lookup, double radius) {
        double azimuth = random.nextDouble(2 * Math.PI);
        return ask(lookup, radius * Math.cos(azimuth), radius * Math.sin(azimuth));
    }

    /** Fresnel's transmittance of unpolarised light at the surface of something denser. */
    private static double transmittance(double sine, double n) {
        double in = Math.sqrt(1 - sine * sine);
        double out = Math.sqrt(1 - sine * sine / (n * n));
        double s = (in - n * out) / (in + n * out);
        double p = (n * in - out) / (n * in + out);
        return 1 - 0.5 * (s * s + p * p);
    }

    private static double slope(DoubleUnaryOperator f, double x, double step) {
        return (8 * (f.applyAsDouble(x + step) - f.applyAsDouble(x - step))
                        - (f.applyAsDouble(x + 2 * step) - f.applyAsDouble(x - 2 * step)))
                / (12 * step);
    }

    private static double median(double[] errors) {
        double[] sorted = errors.clone();
        Arrays.sort(sorted);
        return sorted[sorted.length / 2];
    }

    private static double largest(double[] errors) {
        return Arrays.stream(errors).max().orElseThrow();
    }

    /**
     * A lamp of 1 W, 1 over flat water 2 deep: E = T·sin θ ÷ (4π·r·dr/dθ). P-RADIOM-04, right below, and P-RADIOM-05, 0.7
     * beside; and at many other places.
     */
    @ParameterizedTest
    @ValueSource(ints = {1 << 10, 1 << 14})
    void irradiance_givenFlatWater_isTheClosedForm(int rays) {
        Light lamp = new PointLight(new Vector3(0, 3, 0), Color.grey(1 / (4 * Math.PI)));
        FootprintLookup lookup = lookups(overFloor(lamp, Forward.square(2, 3), water()), "own-map", 4, rays).exact;
        assertThat(ask(lookup, 0, 0)).isCloseTo(0.012439552035987406, within(1e-9));
        assertThat(askAround(lookup, 0.7)).isCloseTo(0.011545326492645069, within(1e-9));
        double[] errors = new double[POINTS];
        for (int i = 0; i < POINTS; i++) {
            double tangent = random.nextDouble(0.02, 2.9);
            double cosine = 1 / Math.sqrt(1 + tangent * tangent);
            double sine = tangent * cosine;
            double inWater = sine / WATER;
            double cosineInWater = Math.sqrt(1 - inWater * inWater);
            double r = tangent + 2 * inWater / cosineInWater;
            double slope = 1 / (cosine * cosine) + 2 * cosine / (WATER * cosineInWater * cosineInWater * cosineInWater);
            double expected = transmittance(sine, WATER) * sine / (4 * Math.PI * r * slope);
            errors[i] = Math.abs(askAround(lookup, r) / expected - 1);
        }
        assertThat(median(errors)).isLessThan(1e-8);
        assertThat(largest(errors)).isLessThan(1e-6);
    }

    private static Material water(Wave... waves) {
        Material.Builder water = Material.builder().transparency(Color.WHITE).inside(Medium.of(WATER));
        for (Wave wave : waves) {
            water.bump(wave);
        }
        return water.build();
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.01, 0.05})
    void irradiance_givenWavesThatDoNotFoldLight_isThatOfTheRay(double height) {
        Wave along = new Wave(Vector3.UNIT_X, 3, height, 0.3);
        Wave askew = new Wave(new Vector3(0.6, 0, 0.8), 6, height / 2, 0);
        Light lamp = new PointLight(new Vector3(0, 5, 0), Color.WHITE);
        Scene scene = overFloor(lamp, Forward.square(2, 2), water(along, askew));
        FootprintLookup lookup = lookups(scene, "own-map", 4, 1 << 14).exact;
        double[] errors = new double[POINTS];
        for (int i = 0; i < POINTS; i++) {
            double u = random.nextDouble(-1.9, 1.9);
            double v = random.nextDouble(-1.9, 1.9);
            double xu = slope(a -> throughWaves(a, v, along, askew)[0], u, STEP);
            double zu = slope(a -> throughWaves(a, v, along, askew)[1], u, STEP);
            double xv = slope(a -> throughWaves(u, a, along, askew)[0], v, STEP);
            double zv = slope(a -> throughWaves(u, a, along, askew)[1], v, STEP);
            double distance = Math.sqrt(u * u + v * v + 9);
            double[] ray = throughWaves(u, v, along, askew);
            double expected = ray[2] * 3 / (distance * distance * distance) / Math.abs(xu * zv - xv * zu);
            errors[i] = Math.abs(ask(lookup, ray[0], ray[1]) / expected - 1);
        }
        assertThat(median(errors)).isLessThan(1e-8);
        assertThat(largest(errors)).isLessThan(1e-6);
    }

    /** Where a ray of a lamp at height 5 through (u, 2, v) lands, x and z, and the part of it that does. */
    private static double[] throughWaves(double u, double v, Wave... waves) {
        Vector3 normal = Vector3.UNIT_Y;
        for (Wave wave : waves) {
            Vector3 d = wave.direction();
            double slope = wave.height()
                    * wave.waveNumber()
                    * Math.cos(wave.waveNumber() * (d.x() * u + d.z() * v) + wave.phase());
            normal = normal.minus(d.times(slope));
        }
        normal = normal.normalized();
        Vector3 in = new Vector3(u, -3, v).normalized();
        double cosine = -in.dot(normal);
        double sineSquared = 1 - cosine * cosine;
        double out = Math.sqrt(1 - sineSquared / (WATER * WATER));
        Vector3 refracted = in.times(1 / WATER).plus(normal.times(cosine / WATER - out));
        double down = -2 / refracted.y();
        return new double[] {
            u + down * refracted.x(), v + down * refracted.z(), transmittance(Math.sqrt(sineSquared), WATER)
        };
    }

    /** P-OPTICS-03: a ball of glass in parallel light of 1 W·m⁻², 3 over the floor. */
    @ParameterizedTest
    @ValueSource(strings = {"own-map", "cube"})
    void irradiance_givenGlassBallInParallelLight_isTheClosedForm(String preProcessor) {
        Light sun = new DirectionalLight(new Vector3(0, -1, 0), Color.WHITE, 0);
        Scene scene = overFloor(sun, new Sphere(new Vector3(0, 3, 0), 1), Forward.clear(GLASS, 1));
        FootprintLookup lookup = lookups(scene, preProcessor, 2, 1 << 14).exact;
        assertThat(ask(lookup, 0, 0)).isCloseTo(0.9216, within(1e-6));
        for (int i = 0; i < 50; i++) {
            assertThat(askAround(lookup, 0.3224663114971402)).isCloseTo(0.6938989132235281, within(1e-6));
            assertThat(askAround(lookup, 0.8302755461377525)).isCloseTo(0.26944851748603572, within(1e-6));
        }
    }

    /** Where a ray of a lamp, 5 over the middle of a ball of glass of radius 1, comes to the plane so far below the middle. */
    private static double throughBall(double angle, double below) {
        double entry = Math.asin(5 * Math.sin(angle));
        double inside = Math.asin(5 * Math.sin(angle) / GLASS);
        double exit = entry - angle + Math.PI - 2 * inside;
        return Math.sin(exit) + (below + Math.cos(exit)) * Math.tan(angle - 2 * (entry - inside));
    }

    private static Scene ballUnderLamp(double below) {
        Light lamp = new PointLight(new Vector3(0, below + 5, 0), Color.WHITE);
        return overFloor(lamp, new Sphere(new Vector3(0, below, 0), 1), Forward.clear(GLASS, 1));
    }

    /** The sum over all rays that come to a place, on either side of the axis: E = T²·sin α ÷ (r·dr/dα). */
    private static double throughBallTo(double radius, double below) {
        int steps = 256;
        double widest = Math.asin(0.2);
        double sum = 0;
        for (double place : new double[] {radius, -radius}) {
            boolean wasPast = throughBall(0, below) > place;
            for (int i = 1; i <= steps; i++) {
                // Evenly in the angle of incidence: the ball bends light ever faster towards its rim.
                double high = angle(Math.min(i, steps - 1e-6) / steps);
                boolean isPast = throughBall(high, below) > place;
                if (isPast != wasPast) {
                    double at = bisected(angle((i - 1.0) / steps), high, place, below);
                    double slope = slope(a -> throughBall(a, below), at, Math.min(1e-4, 0.01 * (widest - at)));
                    double passed = transmittance(5 * Math.sin(at), GLASS);
                    sum += passed * passed * Math.sin(at) / Math.abs(radius * slope);
                }
                wasPast = isPast;
            }
        }
        return sum;
    }

    private static double angle(double part) {
        return Math.asin(0.2 * Math.sin(part * Math.PI / 2));
    }

    private static double bisected(double from, double to, double place, double below) {
        double low = from;
        double high = to;
        boolean isPast = throughBall(low, below) > place;
        for (int half = 0; half < 50; half++) {
            double middle = 0.5 * (low + high);
            boolean goesOn = throughBall(middle, below) > place == isPast;
            low = goesOn ? middle : low;
            high = goesOn ? high : middle;
        }
        return low;
    }

    @ParameterizedTest
    @ValueSource(strings = {"own-map", "cube"})
    void irradiance_givenGlassBallUnderALamp_isTheClosedForm(String preProcessor) {
        FootprintLookup lookup = lookups(ballUnderLamp(3), preProcessor, 2, 1 << 14).exact;
        double[] errors = errorsUnderBall(lookup, 3, 0.9);
        assertThat(median(errors)).isLessThan(1e-7);
        assertThat(largest(errors)).isLessThan(2e-6);
    }

    /** Before its focus a ball's light lies in three sheets over itself, inside of the fold. */
    @Test
    void irradiance_givenLightInSeveralSheets_isTheSumOfItsRays() {
        FootprintLookup lookup = lookups(ballUnderLamp(1.2), "own-map", 2, 1 << 15).exact;
        double[] errors = errorsUnderBall(lookup, 1.2, 0.5);
        assertThat(median(errors)).isLessThan(1e-6);
    }

    private double[] errorsUnderBall(FootprintLookup lookup, double below, double widest) {
        double[] errors = new double[POINTS];
        for (int i = 0; i < POINTS; i++) {
            double radius = random.nextDouble(0.02, widest);
            errors[i] = Math.abs(askAround(lookup, radius) / throughBallTo(radius, below) - 1);
        }
        return errors;
    }

    /** Straight light of a lamp of intensity 1 through a sheet that lets 0.9 through and does not bend it. */
    @ParameterizedTest
    @MethodSource("falloffs")
    void irradiance_givenAnyFalloff_isThatOfStraightShadowRays(Falloff falloff) {
        Scene scene = Forward.sheetOverFloor(new Vector3(0.3, 12, -0.2), falloff);
        FootprintLookup lookup = lookups(scene, "own-map", 4, 1 << 12).exact;
        for (int i = 0; i < POINTS; i++) {
            double x = random.nextDouble(-2.7, 2.4);
            double z = random.nextDouble(-2.5, 2.6);
            double distance = Math.sqrt((x - 0.3) * (x - 0.3) + 144 + (z + 0.2) * (z + 0.2));
            double expected = 0.9 * 12 / distance * falloff.at(distance);
            assertThat(ask(lookup, x, z)).isCloseTo(expected, within(1e-7 * expected));
        }
        // The light of the sheet's edge comes to 0.3 + 1.7 · 12 / 8 = 2.85.
        assertThat(ask(lookup, 2.8499, 0)).isPositive();
        assertThat(ask(lookup, 2.8501, 0)).isZero();
    }

    /** Each of a lamp's points has its share: the same light as that of the triangles, which is off by their size. */
    @Test
    void irradiance_givenALampWithExtent_isNearThatOfTheTriangles() {
        Light lamp = new SphereLight(new Vector3(0, 5, 0), 0.2, Color.WHITE, new Falloff.InverseSquare(), 16);
        Scene scene = overFloor(lamp, Forward.square(2, 2), water());
        Lookups lookups = lookups(scene, "own-map", 4, 1 << 15);
        double ratios = 0;
        for (int i = 0; i < POINTS; i++) {
            double x = random.nextDouble(-1.5, 1.5);
            double z = random.nextDouble(-1.5, 1.5);
            ratios += ask(lookups.exact, x, z) / ask(lookups.flat, x, z);
        }
        assertThat(ratios / POINTS).isCloseTo(1, within(0.002));
    }

    /** Coarse cells under a focus, folded, mixed and torn. */
    @ParameterizedTest
    @ValueSource(strings = {"own-map", "planar", "cube"})
    void irradiance_givenCoarseCellsAtFolds_isFinite(String preProcessor) {
        FootprintLookup lookup = lookups(ballUnderLamp(1.2), preProcessor, 6, 1 << 10).exact;
        for (int i = 0; i < 500; i++) {
            assertThat(askAround(lookup, random.nextDouble(3))).isPositive().isFinite();
        }
    }

    @Test
    void irradiance_givenWarmLookup_allocatesNothing() {
        // Sines and cosines of later versions allocate 32 bytes each, and the chart of a ball needs them.
        assumeThat(Runtime.version().feature()).isLessThan(21);
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        FootprintLookup lookup = lookups(ballUnderLamp(1.2), "own-map", 6, 1 << 12).exact;
        long least = Long.MAX_VALUE;
        for (int stretch = 0; stretch < 6; stretch++) {
            long before = threads.getCurrentThreadAllocatedBytes();
            for (int i = 0; i < 100; i++) {
                askAround(lookup, random.nextDouble(0.5));
            }
            least = Math.min(least, threads.getCurrentThreadAllocatedBytes() - before);
        }
        assertThat(least).isZero();
    }

    /** @param exact follows rays; {@code flat} does not */
    private record Lookups(FootprintLookup exact, FootprintLookup flat) {}
}
