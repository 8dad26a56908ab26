package org.diacaustic.preprocess;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import org.diacaustic.light.DirectionalLight;
import org.diacaustic.light.Light;
import org.diacaustic.light.LightPoint;
import org.diacaustic.light.PointLight;
import org.diacaustic.math.Color;
import org.diacaustic.math.Ray;
import org.diacaustic.math.Transform;
import org.diacaustic.math.Vector3;
import org.diacaustic.scene.Scene;
import org.diacaustic.shape.Box;
import org.diacaustic.shape.Disc;
import org.diacaustic.shape.Ellipsoid;
import org.diacaustic.shape.Shape;
import org.diacaustic.shape.Sphere;
import org.diacaustic.shape.Transformed;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Charts that fit an object: what they measure is what the light sees of it, and all their rays meet it. */
class OwnChartsTest {
    private static final int CELLS = 64;

    private static Optional<EmissionChart> chart(Light light, Shape... shapes) {
        Scene.Builder scene = Scene.builder().camera(Forward.camera()).light(light);
        for (Shape shape : shapes) {
            scene.object("glass " + shape.bounds(), shape, Forward.clear(1.5, 1));
        }
        Beam beam = Forward.plan(scene.build(), Forward.settings(s -> s), "own-map", 1000)
                .beams()
                .get(0);
        LightPoint from = new LightPoint();
        light.emitFrom(0.5, 0.5, from);
        return OwnCharts.of(beam, from);
    }

    private static EmissionChart chart(Vector3 lamp, Shape shape) {
        return chart(new PointLight(lamp, Color.WHITE), shape).orElseThrow();
    }

    /** The measures of all cells of a lattice. */
    private static double total(EmissionChart chart) {
        double step = 1.0 / CELLS;
        double sum = 0;
        for (int i = 0; i < CELLS * CELLS; i++) {
            double p = i % CELLS * step;
            double q = i / CELLS * step;
            sum += chart.measure(p, q, p + step, q, p + step, q + step);
            sum += chart.measure(p, q, p + step, q + step, p, q + step);
        }
        return sum;
    }

    private static Vector3 v(double x, double y, double z) {
        return new Vector3(x, y, z);
    }

    private static void assertRaysMeet(EmissionChart chart, Shape shape) {
        LightRay aimed = new LightRay();
        Ray ray = new Ray();
        SplittableRandom random = new SplittableRandom(7);
        for (int i = 0; i < 4000; i++) {
            // A quarter of them along the border of the square, which is the rim of what is seen.
            double p = i % 8 == 0 ? i / 8 % 2 : random.nextDouble();
            double q = i % 8 == 1 ? i / 8 % 2 : random.nextDouble();
            chart.aim(p, q, aimed);
            ray.set(aimed.originX, aimed.originY, aimed.originZ, aimed.directionX, aimed.directionY, aimed.directionZ);
            assertThat(shape.intersect(ray)).as("%s, %s", p, q).isTrue();
            assertThat(aimed.measure).isCloseTo(chart.density(p, q), within(1e-12 * aimed.measure));
        }
    }

    /** A ball of radius r at distance D is a cone of sinθ = r ÷ D: 2π · (1 − cosθ) = 2π · sin²θ ÷ (1 + cosθ). */
    @ParameterizedTest
    @CsvSource({"1.02, 1", "1.1, 1", "2, 1", "10, 1", "1000, 1", "1e6, 1", "5, 4.9", "3e-6, 1e-6", "4e9, 1e9"})
    void charts_givenBall_measureItsSolidAngle(double distance, double radius) {
        Sphere ball = new Sphere(v(3 * radius, -radius, 2 * radius), radius);
        Vector3 lamp = ball.centre().plus(v(0.36, 0.48, -0.8).times(distance));
        EmissionChart chart = chart(lamp, ball);
        double sine = radius / distance;
        double expected = 2 * Math.PI * sine * sine / (1 + Math.sqrt((1 - sine) * (1 + sine)));
        assertThat(total(chart)).isCloseTo(expected, within(1e-6 * expected));
        assertRaysMeet(chart, ball);
    }

    /**
     * From a point at distance D on an axis of an ellipsoid, its half axis there c, it is an elliptic cone: the tangents of its
     * half angles are a ÷ √(D² − c²) and b ÷ √(D² − c²). Its solid angle is the integral over φ of 1 − cosθ(φ).
     */
    private static double coneOfEllipsoid(double a, double b, double c, double distance) {
        double depth = Math.sqrt((distance - c) * (distance + c));
        int steps = 4000;
        double sum = 0;
        for (int i = 0; i < steps; i++) {
            double angle = 2 * Math.PI * (i + 0.5) / steps;
            double inverse = Math.pow(Math.cos(angle) * depth / a, 2) + Math.pow(Math.sin(angle) * depth / b, 2);
            sum += 1 - 1 / Math.sqrt(1 + 1 / inverse);
        }
        return 2 * Math.PI * sum / steps;
    }

    @ParameterizedTest
    @CsvSource({"1, 1, 0.5, 2", "1.4, 0.4, 1.6, 2", "0.3, 0.2, 3, 3.2", "2, 1, 0.01, 0.5", "1, 0.05, 1, 7"})
    void charts_givenEllipsoid_measureItsSolidAngle(double a, double b, double c, double distance) {
        double expected = coneOfEllipsoid(a, b, c, distance);
        Ellipsoid upright = new Ellipsoid(v(1, 2, 3), v(a, b, c));
        EmissionChart chart = chart(v(1, 2, 3 - distance), upright);
        assertThat(total(chart)).isCloseTo(expected, within(1e-4 * expected));
        assertRaysMeet(chart, upright);
        // Turned, moved and made twice as large, with the lamp, it is seen the same.
        Transform turn = Transform.identity().rotate(v(1, -2, 0.5), 77).scale(2).translate(v(-4, 0.3, 9));
        Transformed turned = new Transformed(upright, turn);
        EmissionChart moved = chart(turn.point(v(1, 2, 3 - distance)), turned);
        assertThat(total(moved)).isCloseTo(expected, within(1e-4 * expected));
        assertRaysMeet(moved, turned);
        // And made of a ball, mirrored on the way.
        Transform stretch =
                Transform.identity().scale(a, b, -c).translate(v(1, 2, 3)).then(turn);
        Transformed stretched = new Transformed(new Sphere(Vector3.ZERO, 1), stretch);
        EmissionChart same = chart(turn.point(v(1, 2, 3 - distance)), stretched);
        assertThat(total(same)).isCloseTo(expected, within(1e-4 * expected));
        assertRaysMeet(same, stretched);
    }

    static List<Transform> shears() {
        return List.of(
                Transform.ofColumns(v(1, 0, 0), v(0.7, 1, 0), v(0, 0, 1), Vector3.ZERO),
                Transform.ofColumns(v(1, 0.2, 0), v(0.7, 0.5, -0.4), v(0.3, 0, 1.2), v(0.1, 0.2, 0.3)));
    }

    /** Against a count of the directions that meet it, of 1000 × 1000 on the face of a cube. */
    @ParameterizedTest
    @MethodSource("shears")
    void charts_givenShearedBall_measureItsSolidAngle(Transform shear) {
        Transformed ball = new Transformed(new Sphere(Vector3.ZERO, 1), shear);
        Vector3 lamp = v(0, 0, 4);
        int steps = 1000;
        double expected = 0;
        Ray ray = new Ray();
        for (int i = 0; i < steps * steps; i++) {
            double x = 2 * (i % steps + 0.5) / steps - 1;
            double y = 2 * (i / steps + 0.5) / steps - 1;
            Vector3 direction = v(x, y, -1);
            ray.set(lamp, direction.normalized());
            expected += ball.intersect(ray) ? 4.0 / steps / steps / Math.pow(direction.length(), 3) : 0;
        }
        EmissionChart chart = chart(lamp, ball);
        assertThat(total(chart)).isCloseTo(expected, within(1e-3 * expected));
        assertRaysMeet(chart, ball);
    }

    /** A square of half side 1 at distance 1 is a face of a cube around the lamp: 4π ÷ 6. */
    @Test
    void charts_givenSquare_measureItsSolidAngle() {
        EmissionChart chart = chart(v(0, 5, 0), Forward.square(4, 1));
        assertThat(total(chart)).isCloseTo(4 * Math.PI / 6, within(1e-7));
        assertRaysMeet(chart, Forward.square(4, 1));
        Transform turn = Transform.identity().rotate(v(1, 2, 3), 40).scale(0.5).translate(v(1, 0, 0));
        Transformed turned = new Transformed(Forward.square(4, 1), turn);
        EmissionChart moved = chart(turn.point(v(0, 5, 0)), turned);
        assertThat(total(moved)).isCloseTo(4 * Math.PI / 6, within(1e-7));
        assertRaysMeet(moved, turned);
    }

    /** Of a disc the chart is the square around it: from height h over its middle, 4 · asin(r² ÷ (r² + h²)). */
    @Test
    void charts_givenDisc_coverTheSquareAroundIt() {
        EmissionChart chart = chart(v(1, 4, 2), new Disc(v(1, 1, 2), Vector3.UNIT_Y, 2));
        assertThat(total(chart)).isCloseTo(4 * Math.asin(4.0 / 13), within(1e-7));
    }

    /** The sun sees of a square of 4 what its slope leaves: 4 · 0.8; its rays start above it. */
    @Test
    void charts_givenSquareInTheSun_measureItsAreaAcrossTheRays() {
        EmissionChart chart = chart(new DirectionalLight(v(0.6, -0.8, 0), Color.WHITE, 0), Forward.square(1, 1))
                .orElseThrow();
        assertThat(total(chart)).isCloseTo(3.2, within(1e-7));
        assertRaysMeet(chart, Forward.square(1, 1));
    }

    /** Where nothing fits. */
    @Test
    void charts_givenWhatHasNone_areNone() {
        Light lamp = new PointLight(v(0, 5, 0), Color.WHITE);
        Sphere ball = new Sphere(Vector3.ZERO, 1);
        assertThat(chart(lamp, new Box(v(-1, -1, -1), v(1, 1, 1)))).isEmpty();
        assertThat(chart(new DirectionalLight(v(0, -1, 0), Color.WHITE, 0), ball))
                .isEmpty();
        assertThat(chart(new PointLight(v(0, 0.9, 0), Color.WHITE), ball)).isEmpty();
    }

    /** So near that its rim cannot be told from rounding. */
    @ParameterizedTest
    @ValueSource(doubles = {1, 1 + 0x1p-40, 1 + 0x1p-11})
    void charts_givenLampAtTheSurfaceOfABall_areNone(double distance) {
        assertThat(chart(new PointLight(v(0, distance, 0), Color.WHITE), new Sphere(Vector3.ZERO, 1)))
                .isEmpty();
    }

    /** A light sees nothing of a square in whose plane it is. */
    @Test
    void charts_givenLampInThePlaneOfASquare_areNone() {
        assertThat(chart(new PointLight(v(5, 1, 0), Color.WHITE), Forward.square(1, 1)))
                .isEmpty();
    }

    /** Equal steps from the middle of the chart outwards are equal steps of the angle of incidence. */
    @Test
    void aim_givenBall_stepsEvenlyInIncidence() {
        Sphere ball = new Sphere(Vector3.ZERO, 1);
        EmissionChart chart = chart(v(0, 0, 3), ball);
        LightRay ray = new LightRay();
        for (int i = 0; i <= 10; i++) {
            chart.aim(0.5 + 0.05 * i, 0.5, ray);
            // The distance of the ray from the middle of the unit ball is the sine of its incidence.
            Vector3 direction = v(ray.directionX, ray.directionY, ray.directionZ);
            double sine = v(0, 0, 3).cross(direction).length();
            assertThat(Math.asin(Math.min(1, sine))).isCloseTo(i * Math.PI / 20, within(1e-4));
        }
    }

    /** The solid angle of a ball at a distance of d radii is 2π(1 − √(1 − 1/d²)), wherever the light is; too far away it has no chart. */
    @ParameterizedTest
    @ValueSource(doubles = {1.01, 10, 1e4, 1e8, 1e11})
    void ball_givenAnyDistance_hasAllOfItsSolidAngle(double distance) {
        double sine = 1 / distance;
        double versine = sine * sine / (1 + Math.sqrt((1 - sine) * (1 + sine)));
        EmissionChart chart = chart(new Vector3(0, distance, 0), new Sphere(Vector3.ZERO, 1));
        assertThat(total(chart)).isCloseTo(2 * Math.PI * versine, within(1e-4 * 2 * Math.PI * versine));
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e13, 1e15, 1e20})
    void ball_givenALampSoFarThatRoundingMatters_hasNoChart(double distance) {
        Light lamp = new PointLight(new Vector3(0, distance, 0), Color.WHITE);
        assertThat(chart(lamp, new Sphere(Vector3.ZERO, 1))).isEmpty();
    }
}
