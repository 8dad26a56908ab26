package org.diacaustic.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.SplittableRandom;
import org.diacaustic.math.Color;
import org.diacaustic.math.Transform;
import org.diacaustic.math.Vector3;
import org.diacaustic.shape.Box;
import org.diacaustic.shape.Combination;
import org.diacaustic.shape.Shape;
import org.diacaustic.shape.Sphere;
import org.diacaustic.shape.Transformed;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Solids of solids, of glass. */
class CombinedGlassTest {
    private static final double DIM = 0x1p-12;

    static List<Shape> solids() {
        Shape lens = new Combination(
                Combination.Kind.INTERSECTION, new Sphere(Eye.v(0, 0, -1), 1.5), new Sphere(Eye.v(0, 0, 1), 1.5));
        Shape bowl = Combination.of(
                Combination.Kind.DIFFERENCE,
                List.of(
                        new Sphere(Vector3.ZERO, 1),
                        new Sphere(Vector3.ZERO, 0.8),
                        new Box(Eye.v(-2, 0.3, -2), Eye.v(2, 2, 2))));
        Transform turn = Transform.identity().rotate(Eye.v(1, -2, 0.3), 33);
        Shape bar = new Combination(
                Combination.Kind.UNION,
                new Transformed(new Box(Eye.v(-1, -0.5, -0.5), Eye.v(0.1, 0.5, 0.5)), turn),
                new Transformed(new Box(Eye.v(0.1, -0.5, -0.5), Eye.v(1, 0.5, 0.5)), turn));
        return List.of(lens, bowl, bar);
    }

    /** In a furnace of radiance 1 clear glass is not to be seen, whatever its form: all that it bends and mirrors is 1. */
    @ParameterizedTest
    @MethodSource("solids")
    void eye_givenClearGlassInAFurnace_seesNothingOfIt(Shape solid) {
        Eye eye = new Eye().glass(solid, 1.5).background(1);
        eye.settings().minimumThroughput(DIM).maxDepth(100);
        SplittableRandom random = new SplittableRandom(8);
        for (int i = 0; i < 300; i++) {
            Vector3 from = Eye.v(random.nextDouble(-3, 3), random.nextDouble(-3, 3), 4);
            Vector3 to = Eye.v(random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1));
            // What is too weak to be followed is missing; boxes keep a part of the light that comes in at a corner.
            Color seen = eye.sees(from, to.minus(from));
            assertThat(seen.green()).as("from %s to %s", from, to).isBetween(0.9, 1 + 1e-9);
        }
    }

    @ParameterizedTest
    @MethodSource("solids")
    void eye_givenGlassThatBendsNothing_seesThroughItAsThroughAir(Shape solid) {
        Eye eye = new Eye().glass(solid, 1).background(1);
        SplittableRandom random = new SplittableRandom(9);
        for (int i = 0; i < 2000; i++) {
            Vector3 from = Eye.v(random.nextDouble(-3, 3), random.nextDouble(-3, 3), 4);
            Vector3 to = Eye.v(random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1));
            assertThat(eye.sees(from, to.minus(from)).green()).isCloseTo(1, within(1e-12));
        }
    }
}
