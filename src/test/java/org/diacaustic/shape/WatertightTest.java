package org.diacaustic.shape;

import static org.assertj.core.api.Assertions.assertThat;
import static org.diacaustic.shape.Line.v;

import java.util.SplittableRandom;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import org.diacaustic.math.Transform;
import org.diacaustic.math.Vector3;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Closed shapes from within: rays aimed at their very edges and corners come out, and an odd number of times. */
class WatertightTest {
    /** A million over all shapes. */
    private static final int RAYS = 80_000;

    /** A shape, a point well inside, and points of its edges. */
    enum Closed {
        BOX(new Box(v(-1, 0.25, -0.75), v(0.5, 1, 2)), v(-0.2, 0.6, 0.5), Closed::edgeOfBox),
        FAR_BOX(
                new Box(v(1e6 - 1, -1e6 + 0.25, 3e6 - 0.75), v(1e6 + 0.5, -1e6 + 1, 3e6 + 2)),
                v(1e6 - 0.2, -1e6 + 0.6, 3e6 + 0.5),
                random -> edgeOfBox(random).plus(v(1e6, -1e6, 3e6))),
        MOVED_BOX(
                new Transformed(new Box(v(-1, 0.25, -0.75), v(0.5, 1, 2)), turned()),
                turned().point(v(-0.2, 0.6, 0.5)),
                random -> turned().point(edgeOfBox(random))),
        CYLINDER(
                Frustum.cylinder(v(0, 0, 0), v(0, 2, 0), 0.75, true),
                v(0.1, 0.9, -0.2),
                random -> rim(random, random.nextBoolean() ? 0 : 2, 0.75)),
        CONE(
                Frustum.cone(v(0, 0, 0), 1.25, v(0, 2, 0), true),
                v(0.1, 0.5, -0.2),
                random -> random.nextInt(3) == 0 ? v(0, 2, 0) : rim(random, 0, 1.25)),
        FRUSTUM(
                Frustum.between(v(0, 0, 0), 0.25, v(0, 2, 0), 1.5, true),
                v(0.1, 1.1, -0.2),
                random -> random.nextBoolean() ? rim(random, 0, 0.25) : rim(random, 2, 1.5)),
        LEANING_FRUSTUM(
                new Transformed(Frustum.between(v(0, 0, 0), 0.25, v(0, 2, 0), 1.5, true), turned()),
                turned().point(v(0.1, 1.1, -0.2)),
                random -> turned().point(random.nextBoolean() ? rim(random, 0, 0.25) : rim(random, 2, 1.5))),
        SPHERE(new Sphere(v(0.3, -0.2, 0.1), 1.25), v(0.3, 0.9, 0.1), random -> rim(random, -0.2, 1.25)),
        ELLIPSOID(new Ellipsoid(v(0, 0, 0), v(1.5, 0.25, 1.5)), v(0.4, 0.1, 0), random -> rim(random, 0, 1.5)),
        TORUS(new Torus(v(0, 0, 0), v(0, 1, 0), 1, 0.25), v(1.1, 0.05, 0), random -> rim(random, 0.25, 1)),
        // Spheres of radius 1.25 about ±0.8 meet in a circle of radius √(1.25² − 0.8²).
        LENS(
                new Combination(
                        Combination.Kind.INTERSECTION, new Sphere(v(0, -0.8, 0), 1.25), new Sphere(v(0, 0.8, 0), 1.25)),
                v(0.2, 0.05, -0.1),
                random -> rim(random, 0, Math.sqrt(1.25 * 1.25 - 0.8 * 0.8))),
        JOINED_BOXES(
                new Combination(
                        Combination.Kind.UNION,
                        new Box(v(-1, 0.25, -0.75), v(0.1, 1, 2)),
                        new Box(v(0.1, 0.25, -0.75), v(0.5, 1, 2))),
                v(-0.2, 0.6, 0.5),
                Closed::edgeOfBox);

        private final Shape shape;
        private final Vector3 inside;
        private final Function<SplittableRandom, Vector3> edge;

        Closed(Shape shape, Vector3 inside, Function<SplittableRandom, Vector3> edge) {
            this.shape = shape;
            this.inside = inside;
            this.edge = edge;
        }

        private static Transform turned() {
            return Transform.identity().rotate(v(1, -2, 0.3), 77).translate(v(100, 200, -300));
        }

        /** A corner, or a point of an edge. */
        private static Vector3 edgeOfBox(SplittableRandom random) {
            double[] low = {-1, 0.25, -0.75};
            double[] high = {0.5, 1, 2};
            double[] at = new double[3];
            for (int i = 0; i < 3; i++) {
                at[i] = random.nextBoolean() ? low[i] : high[i];
            }
            if (random.nextBoolean()) {
                int along = random.nextInt(3);
                at[along] = low[along] + (high[along] - low[along]) * random.nextDouble();
            }
            return v(at[0], at[1], at[2]);
        }

        private static Vector3 rim(SplittableRandom random, double height, double radius) {
            double angle = 2 * Math.PI * random.nextDouble();
            return v(radius * Math.cos(angle), height, radius * Math.sin(angle));
        }
    }

    @ParameterizedTest
    @EnumSource
    void crossings_givenRaysFromWithinAtEdgesAndCorners_areOddInNumber(Closed closed) {
        SplittableRandom random = new SplittableRandom(6);
        UnaryOperator<Vector3> nearby = point -> point.plus(
                v(random.nextDouble(-0.05, 0.05), random.nextDouble(-0.05, 0.05), random.nextDouble(-0.05, 0.05)));
        int lost = 0;
        for (int i = 0; i < RAYS; i++) {
            Vector3 origin = nearby.apply(closed.inside);
            Vector3 direction = closed.edge.apply(random).minus(origin);
            lost += Line.crossings(closed.shape, origin, direction).size() % 2 == 1 ? 0 : 1;
        }
        assertThat(lost).isZero();
    }
}
