package org.diacaustic.shape;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;
import static org.diacaustic.shape.Combination.Kind.DIFFERENCE;
import static org.diacaustic.shape.Combination.Kind.INTERSECTION;
import static org.diacaustic.shape.Combination.Kind.UNION;
import static org.diacaustic.shape.Line.v;

import java.lang.management.ManagementFactory;
import java.util.Arrays;
import java.util.SplittableRandom;
import org.diacaustic.math.Ray;
import org.diacaustic.math.Vector3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class CombinationTest {
    private static final double INFINITY = Double.POSITIVE_INFINITY;

    private final Ray ray = new Ray();
    private final Hit hit = new Hit();

    @Test
    void combination_givenWhatIsNoSolid_isRefused() {
        Sphere ball = new Sphere(Vector3.ZERO, 1);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Combination(UNION, ball, new Disc(Vector3.ZERO, Vector3.UNIT_Y, 1)))
                .withMessageContaining("closed");
        // A cylinder without end.
        Quadric endless = Quadric.of(1, 0, 0, 0, 1, 0, 0, 0, 0, -1);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Combination(DIFFERENCE, endless, ball))
                .withMessageContaining("end");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Combination(INTERSECTION, ball, new Sphere(v(3, 0, 0), 1)))
                .withMessageContaining("overlap");
        Shape deep = ball;
        for (int i = 0; i < 12; i++) {
            deep = new Combination(UNION, deep, ball);
        }
        Shape deepest = deep;
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Combination(UNION, ball, deepest))
                .withMessageContaining("12");
    }

    @Test
    void intervals_givenStretchesThatTouchOrCoincide_leaveNoSlivers() {
        double[] a = {1, 3};
        double[] b = {3, 4};
        assertThat(UNION.intervals(a, b)).containsExactly(1, 4);
        assertThat(INTERSECTION.intervals(a, b)).isEmpty();
        assertThat(DIFFERENCE.intervals(a, b)).containsExactly(1, 3);
        assertThat(UNION.intervals(a, a)).containsExactly(1, 3);
        assertThat(INTERSECTION.intervals(a, a)).containsExactly(1, 3);
        assertThat(DIFFERENCE.intervals(a, a)).isEmpty();
        assertThat(DIFFERENCE.intervals(a, new double[] {1, 2})).containsExactly(2, 3);
        assertThat(DIFFERENCE.intervals(a, new double[] {2, 2.5})).containsExactly(1, 2, 2.5, 3);
        assertThat(UNION.intervals(a, new double[0])).containsExactly(1, 3);
        assertThat(DIFFERENCE.intervals(new double[] {-INFINITY, INFINITY}, a))
                .containsExactly(-INFINITY, 1, 3, INFINITY);
        assertThat(INTERSECTION.intervals(new double[] {-INFINITY, 2}, new double[] {1, INFINITY}))
                .containsExactly(1, 2);
    }

    @ParameterizedTest
    @EnumSource
    void intervals_givenRandomStretches_holdWhatTheKindSays(Combination.Kind kind) {
        SplittableRandom random = new SplittableRandom(5);
        for (int i = 0; i < 2000; i++) {
            // On a lattice, so that ends often coincide; asked halfway between.
            double[] a = stretches(random);
            double[] b = stretches(random);
            double[] got = kind.intervals(a, b);
            for (int j = 1; j < got.length; j++) {
                assertThat(got[j]).isGreaterThan(got[j - 1]);
            }
            for (double x = -0.5; x < 17; x++) {
                assertThat(holds(got, x))
                        .as("%s of %s and %s at %s", kind, Arrays.toString(a), Arrays.toString(b), x)
                        .isEqualTo(kind.holds(holds(a, x), holds(b, x)));
            }
        }
    }

    private static double[] stretches(SplittableRandom random) {
        return random.ints(2 * random.nextInt(4), 0, 17)
                .distinct()
                .sorted()
                .asDoubleStream()
                .boxed()
                .collect(java.util.stream.Collectors.collectingAndThen(
                        java.util.stream.Collectors.toList(),
                        ends -> ends.subList(0, ends.size() & ~1).stream()
                                .mapToDouble(Double::doubleValue)
                                .toArray()));
    }

    private static boolean holds(double[] stretches, double x) {
        for (int i = 0; i < stretches.length; i += 2) {
            if (x > stretches[i] && x < stretches[i + 1]) {
                return true;
            }
        }
        return false;
    }

    @Test
    void intersect_givenLens_meetsTheFarCapsInTurn() {
        // The caps of spheres about z = -1 and z = 1 of radius 1.5 are half a unit off the middle.
        Shape lens = new Combination(INTERSECTION, new Sphere(v(0, 0, -1), 1.5), new Sphere(v(0, 0, 1), 1.5));
        assertThat(Line.crossings(lens, v(0, 0, -4), v(0, 0, 1))).containsExactly(3.5, 4.5);
        Hit near = Line.meet(lens, v(0, 0, -4), v(0, 0, 1));
        assertThat(near.primitive).isEqualTo(1);
        assertThat(near.normalZ).isEqualTo(-1);
        assertThat(lens.piece(near)).isEqualTo(1);
        // Beyond the rim, of radius √1.25, there is nothing.
        assertThat(Line.crossings(lens, v(1.2, 0, -4), v(0, 0, 1))).isEmpty();
        assertThat(lens.bounds().maxZ()).isCloseTo(0.5, within(1e-12));
    }

    @Test
    void complete_givenWhatWasTakenAway_turnsNormalsAndKeepsTheMap() {
        Sphere hole = new Sphere(Vector3.ZERO, 0.5);
        Shape shell = new Combination(DIFFERENCE, new Sphere(Vector3.ZERO, 1), hole);
        assertThat(Line.crossings(shell, v(-3, 0, 0), v(1, 0, 0))).containsExactly(2.0, 2.5, 3.5, 4.0);
        Hit inner = Line.meet(shell, v(0, 0, 0), v(1, 0, 0));
        assertThat(inner.primitive).isEqualTo(1);
        assertThat(inner.normalX).isEqualTo(-1);
        assertThat(inner.shadingX).isEqualTo(-1);
        shell.inverseMap(inner);
        Hit outside = Line.meet(hole, v(3, 0, 0), v(-1, 0, 0));
        hole.inverseMap(outside);
        assertThat(inner.u).isEqualTo(outside.u);
        assertThat(inner.v).isEqualTo(outside.v);
        assertThat(inner.normalX).isEqualTo(-1);
    }

    @Test
    void intersect_givenFacesThatCoincide_leavesNoSliver() {
        // Turned, so that rounding puts either of the common faces in front.
        var turn = org.diacaustic.math.Transform.identity().rotate(v(1, -2, 0.3), 33);
        Box left = new Box(v(0, 0, 0), v(1, 1, 1));
        Box right = new Box(v(1, 0, 0), v(2, 1, 1));
        Shape joined = new Combination(UNION, new Transformed(left, turn), new Transformed(right, turn));
        Shape rest = new Combination(
                DIFFERENCE,
                new Transformed(new Box(v(0, 0, 0), v(2, 1, 1)), turn),
                new Transformed(new Box(v(1, 0, 0), v(2, 1, 1)), turn));
        Shape none = new Combination(DIFFERENCE, new Transformed(left, turn), new Transformed(left, turn));
        SplittableRandom random = new SplittableRandom(6);
        for (int i = 0; i < 20_000; i++) {
            Vector3 from = turn.point(v(-3, random.nextDouble(-1, 2), random.nextDouble(-1, 2)));
            Vector3 to = turn.point(v(4, random.nextDouble(-1, 2), random.nextDouble(-1, 2)));
            Vector3 direction = to.minus(from);
            assertThat(Line.crossings(joined, from, direction).size()).isIn(0, 2);
            assertThat(Line.crossings(rest, from, direction).size()).isIn(0, 2);
            assertThat(Line.crossings(none, from, direction)).isEmpty();
        }
    }

    @Test
    void intersect_givenRaysAtRims_goesInAndOutInTurn() {
        Shape lens = new Combination(INTERSECTION, new Sphere(v(0, 0, -1), 1.5), new Sphere(v(0, 0, 1), 1.5));
        Shape cut = new Combination(DIFFERENCE, new Sphere(v(0, 0, 0), 1.5), new Box(v(0, -2, -2), v(2, 2, 2)));
        SplittableRandom random = new SplittableRandom(7);
        for (int i = 0; i < 50_000; i++) {
            double angle = random.nextDouble(2 * Math.PI);
            double rim = Math.sqrt(1.25);
            crossesInTurn(lens, v(rim * Math.cos(angle), rim * Math.sin(angle), 0), random);
            crossesInTurn(cut, v(0, 1.5 * Math.cos(angle), 1.5 * Math.sin(angle)), random);
        }
    }

    private void crossesInTurn(Shape shape, Vector3 at, SplittableRandom random) {
        Vector3 from = v(random.nextDouble(-4, 4), random.nextDouble(-4, 4), random.nextDouble(-4, 4));
        Vector3 direction = at.minus(from).normalized();
        Vector3 start = at.minus(direction.times(10));
        ray.set(start, direction);
        int crossings = 0;
        while (shape.intersect(ray)) {
            hit.take(ray);
            shape.complete(ray, hit);
            double along = direction.x() * hit.normalX + direction.y() * hit.normalY + direction.z() * hit.normalZ;
            assertThat(along < 0)
                    .as("crossing %s towards %s from %s", crossings, at, from)
                    .isEqualTo(crossings % 2 == 0);
            crossings++;
            ray.set(hit.x, hit.y, hit.z, direction.x(), direction.y(), direction.z());
            ray.leaving = hit.primitive;
            ray.departureError = hit.pointError;
        }
        assertThat(crossings % 2).as("crossings towards %s from %s", at, from).isZero();
    }

    @Test
    void intersect_givenAWarmVirtualMachine_allocatesNothing() {
        Shape bowl = ShapeSample.BOWL.shape();
        cast(bowl, 2000);
        com.sun.management.ThreadMXBean threads = (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
        long thread = Thread.currentThread().getId();
        long before = threads.getThreadAllocatedBytes(thread);
        long nothing = threads.getThreadAllocatedBytes(thread) - before;
        before = threads.getThreadAllocatedBytes(thread);
        cast(bowl, 5000);
        assertThat(threads.getThreadAllocatedBytes(thread) - before - nothing).isZero();
    }

    private void cast(Shape shape, int rays) {
        for (int i = 0; i < rays; i++) {
            ray.set(-3, -3, -3, 1 + i % 7, 1 + i % 11, 1 + i % 13);
            if (shape.intersect(ray)) {
                hit.take(ray);
                shape.complete(ray, hit);
            }
        }
    }
}
