package org.diacaustic.shape;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import java.util.function.DoubleFunction;
import org.diacaustic.math.Ray;
import org.diacaustic.math.Vector3;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Intersections of curved shapes held against their equations: a change of sign at the root, and none before. */
class ImplicitFormTest {
    private static final int RAYS = 3000;
    private static final int SAMPLES = 60;

    /** Left sides of equations, negative inside, of shapes about the origin that are as large as a factor says. */
    enum Form {
        SPHERE(k -> new Sphere(Vector3.ZERO, 1.25 * k), (x, y, z) -> x * x + y * y + z * z - 1.25 * 1.25),
        ELLIPSOID(
                k -> new Ellipsoid(Vector3.ZERO, new Vector3(1.5, 0.03, 0.8).times(k)),
                (x, y, z) -> square(x / 1.5) + square(y / 0.03) + square(z / 0.8) - 1),
        TORUS(
                k -> new Torus(Vector3.ZERO, Vector3.UNIT_Y, 1.1 * k, 0.3 * k),
                (x, y, z) -> square(Math.hypot(x, z) - 1.1) + y * y - 0.09),
        THIN_TORUS(
                k -> new Torus(Vector3.ZERO, Vector3.UNIT_Z, 1.3 * k, 0.01 * k),
                (x, y, z) -> square(Math.hypot(x, y) - 1.3) + z * z - 1e-4),
        QUADRIC(k -> Quadric.of(1, 0.5, 0, 0, 1, 0, 0, 1, 0, -k * k), (x, y, z) -> x * x + x * y + y * y + z * z - 1),
        CYLINDER(
                k -> Frustum.cylinder(new Vector3(0, -k, 0), new Vector3(0, k, 0), 0.7 * k, true),
                (x, y, z) -> Math.max(x * x + z * z - 0.49, Math.abs(y) - 1)),
        CONE(
                k -> Frustum.cone(new Vector3(0, -k, 0), 0.8 * k, new Vector3(0, k, 0), true),
                (x, y, z) -> Math.max(Math.hypot(x, z) - 0.4 * (1 - y), Math.abs(y) - 1)),
        FRUSTUM(
                k -> Frustum.between(new Vector3(0, -k, 0), 0.2 * k, new Vector3(0, k, 0), k, true),
                (x, y, z) -> Math.max(Math.hypot(x, z) - 0.2 - 0.4 * (1 + y), Math.abs(y) - 1));

        private final DoubleFunction<Shape> make;
        private final Value value;

        Form(DoubleFunction<Shape> make, Value value) {
            this.make = make;
            this.value = value;
        }
    }

    private interface Value {
        double at(double x, double y, double z);
    }

    private static double square(double x) {
        return x * x;
    }

    @ParameterizedTest
    @EnumSource
    void intersect_givenAnyScale_isTheFirstChangeOfSign(Form form) {
        for (int exponent : new int[] {-20, -7, 0, 20}) {
            double k = Math.scalb(1.0, exponent);
            Shape shape = form.make.apply(k);
            SplittableRandom random = new SplittableRandom(5);
            int hits = 0;
            for (int i = 0; i < RAYS; i++) {
                double[] o = {random.nextDouble(-3, 3), random.nextDouble(-3, 3), random.nextDouble(-3, 3)};
                double[] d = {
                    random.nextDouble(-1.2, 1.2) - o[0],
                    random.nextDouble(-0.5, 0.5) - o[1],
                    random.nextDouble(-1.2, 1.2) - o[2]
                };
                Ray ray = new Ray();
                ray.set(k * o[0], k * o[1], k * o[2], k * d[0], k * d[1], k * d[2]);
                boolean hit = shape.intersect(ray);
                double end = hit ? ray.tMax : 4;
                double start = value(form, o, d, 0);
                for (int sample = 1; sample < SAMPLES; sample++) {
                    double before = value(form, o, d, end * (1 - 1e-7) * sample / SAMPLES);
                    assertThat(before * start)
                            .as("%s %d before %s", form, i, end)
                            .isGreaterThan(-1e-12);
                }
                if (hit) {
                    hits++;
                    double before = value(form, o, d, end * (1 - 1e-9));
                    double after = value(form, o, d, end * (1 + 1e-9));
                    assertThat(before * after).as("%s %d at %s", form, i, end).isLessThan(1e-12);
                }
            }
            assertThat(hits).isBetween(RAYS / 100, RAYS);
        }
    }

    private static double value(Form form, double[] o, double[] d, double t) {
        return form.value.at(o[0] + t * d[0], o[1] + t * d[1], o[2] + t * d[2]);
    }
}
