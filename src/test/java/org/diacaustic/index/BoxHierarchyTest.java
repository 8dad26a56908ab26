package org.diacaustic.index;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.diacaustic.math.Bounds;
import org.diacaustic.math.Ray;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class BoxHierarchyTest {

    @Test
    void over_givenBoxesThatAreNone_throws() {
        assertThatThrownBy(() -> BoxHierarchy.over(new double[5])).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> BoxHierarchy.over(new double[] {0, 0, 0, 1, 1, 1, 0, 2, 0, 1, 1, 1}))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("item 1");
        assertThatThrownBy(() -> BoxHierarchy.over(new double[] {0, 0, 0, 1, Double.NaN, 1}))
                .isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> BoxHierarchy.over(new double[] {0, 0, 0, 1, 1, Double.POSITIVE_INFINITY}))
                .isInstanceOf(IllegalArgumentException.class);
    }

    @Test
    void next_givenNoBoxes_isDone() {
        BoxHierarchy tree = BoxHierarchy.over(new double[0]);
        assertThat(visited(tree, ray(0, 0, 0, 1, 0, 0))).isEmpty();
        assertThat(tree.bounds()).isEqualTo(Bounds.EMPTY);
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 9, 40})
    void next_givenBoxesInARow_findsAllAlongAndNoneBeside(int n) {
        double[] boxes = new double[6 * n];
        for (int i = 0; i < n; i++) {
            set(boxes, i, 2 * i, 0, 0, 2 * i + 1, 1, 1);
        }
        BoxHierarchy tree = BoxHierarchy.over(boxes);
        assertThat(visited(tree, ray(-1, 0.5, 0.5, 1, 0, 0)))
                .containsExactlyInAnyOrderElementsOf(
                        IntStream.range(0, n).boxed().toList());
        assertThat(visited(tree, ray(-1, 1.5, 0.5, 1, 0, 0))).isEmpty();
        assertThat(visited(tree, ray(-1, 0.5, 0.5, -1, 0, 0))).isEmpty();
    }

    @Test
    void next_givenRandomBoxesOfAllSizes_missesNoneThatTheRayEnters() {
        SplittableRandom random = new SplittableRandom(11);
        double[] boxes = randomBoxes(random, 500, 0);
        BoxHierarchy tree = BoxHierarchy.over(boxes);
        Ray ray = new Ray();
        boolean[] seen = new boolean[500];
        for (int i = 0; i < 20_000; i++) {
            setRandomly(ray, random, i % 3 == 0 ? 1e6 : 2);
            ray.tMax = i % 2 == 0 ? Double.POSITIVE_INFINITY : random.nextDouble(3);
            java.util.Arrays.fill(seen, false);
            int base = tree.enter(ray);
            for (int leaf = tree.next(ray, base); leaf != BoxHierarchy.DONE; leaf = tree.next(ray, base)) {
                for (int at = BoxHierarchy.first(leaf); at < BoxHierarchy.end(leaf); at++) {
                    assertThat(seen[tree.item(at)]).isFalse();
                    seen[tree.item(at)] = true;
                }
            }
            for (int box = 0; box < 500; box++) {
                if (!seen[box]) {
                    assertThat(box(boxes, box).isHitBy(ray)).isFalse();
                }
            }
        }
    }

    @Test
    void next_givenAThousandBoxesInOnePlace_findsAllInTheirOrder() {
        double[] boxes = new double[6000];
        for (int i = 0; i < 1000; i++) {
            set(boxes, i, 1, 2, 3, 2, 3, 4);
        }
        BoxHierarchy tree = BoxHierarchy.over(boxes);
        Ray ray = ray(0, 2.5, 3.5, 1, 0, 0);
        int room = ray.stack.length;
        assertThat(visited(tree, ray))
                .isEqualTo(IntStream.range(0, 1000).boxed().toList());
        assertThat(ray.stack).hasSize(room);
    }

    @Test
    void next_givenBoxesThatHalveInSize_staysWithinItsStack() {
        // Every cut of the heuristic splits off a single box, so only the bound on the depth ends it.
        double[] boxes = new double[6 * 1000];
        for (int i = 0; i < 1000; i++) {
            double x = Math.scalb(1.0, -i);
            set(boxes, i, x, 0, 0, x, 0, 0);
        }
        BoxHierarchy tree = BoxHierarchy.over(boxes);
        assertThat(visited(tree, ray(-1, 0, 0, 1, 0, 0))).hasSize(1000);
        assertThat(visited(tree, ray(2, 0, 0, -1, 0, 0))).hasSize(1000);
    }

    @Test
    void next_givenRaysInThePlanesOfFaces_findsTheBoxForEitherZero() {
        double[] boxes = new double[6 * 8];
        for (int i = 0; i < 8; i++) {
            set(boxes, i, i & 1, i >> 1 & 1, i >> 2, (i & 1) + 1, (i >> 1 & 1) + 1, (i >> 2) + 1);
        }
        BoxHierarchy tree = BoxHierarchy.over(boxes);
        for (double zero : new double[] {0.0, -0.0}) {
            assertThat(visited(tree, ray(1, 0.5, -1, zero, zero, 1))).contains(0, 1, 4, 5);
            assertThat(visited(tree, ray(2, 2, -1, zero, zero, 1))).contains(3, 7);
            assertThat(visited(tree, ray(0, 5, 0, zero, -1, zero))).contains(0, 2);
        }
    }

    @Test
    void next_givenFlatBoxes_findsThem() {
        double[] boxes = new double[6 * 20];
        for (int i = 0; i < 20; i++) {
            set(boxes, i, i, 0, 0, i + 1, 0, 1);
        }
        BoxHierarchy tree = BoxHierarchy.over(boxes);
        assertThat(visited(tree, ray(7.5, 1, 0.5, 0, -1, 0))).contains(7);
        assertThat(visited(tree, ray(-1, 0, 0.5, 1, 0, 0))).hasSize(20);
    }

    @Test
    void next_givenAHitInTheNearestBox_skipsWhatLiesBehindIt() {
        double[] boxes = new double[6 * 100];
        for (int i = 0; i < 100; i++) {
            set(boxes, i, 2 * i, 0, 0, 2 * i + 1, 1, 1);
        }
        BoxHierarchy tree = BoxHierarchy.over(boxes);
        Ray ray = ray(300, 0.5, 0.5, -1, 0, 0);
        int base = tree.enter(ray);
        int leaf = tree.next(ray, base);
        assertThat(BoxHierarchy.end(leaf) - BoxHierarchy.first(leaf)).isLessThanOrEqualTo(8);
        ray.tMax = 300 - 199;
        assertThat(tree.next(ray, base)).isEqualTo(BoxHierarchy.DONE);
        assertThat(ray.stackTop).isZero();
    }

    @Test
    void leave_givenAWalkThatIsNotDone_freesTheStack() {
        BoxHierarchy tree = BoxHierarchy.over(new double[] {0, 0, 0, 1, 1, 1});
        Ray ray = ray(-1, 0.5, 0.5, 1, 0, 0);
        ray.stackTop = 5;
        int base = tree.enter(ray);
        assertThat(tree.next(ray, base)).isNotEqualTo(BoxHierarchy.DONE);
        tree.leave(ray, base);
        assertThat(ray.stackTop).isEqualTo(5);
    }

    @ParameterizedTest
    @ValueSource(ints = {-300, -20, 20, 300})
    void over_givenBoxesScaledByAPowerOfTwo_isTheSameTree(int exponent) {
        double[] boxes = randomBoxes(new SplittableRandom(5), 2000, 3);
        double[] scaled = new double[boxes.length];
        for (int i = 0; i < boxes.length; i++) {
            scaled[i] = Math.scalb(boxes[i], exponent);
        }
        BoxHierarchy tree = BoxHierarchy.over(boxes);
        BoxHierarchy scaledTree = BoxHierarchy.over(scaled);
        SplittableRandom random = new SplittableRandom(6);
        double scale = Math.scalb(1.0, exponent);
        for (int i = 0; i < 200; i++) {
            Ray ray = new Ray();
            setRandomly(ray, random, 10);
            Ray scaledRay = ray(
                    ray.originX * scale,
                    ray.originY * scale,
                    ray.originZ * scale,
                    ray.directionX,
                    ray.directionY,
                    ray.directionZ);
            assertThat(visited(scaledTree, scaledRay)).isEqualTo(visited(tree, ray));
            assertThat(scaledRay.tests).isEqualTo(ray.tests);
        }
    }

    @Test
    void over_givenManyBoxes_isTheSameTreeEveryTime() {
        double[] boxes = randomBoxes(new SplittableRandom(8), 60_000, 0);
        BoxHierarchy tree = BoxHierarchy.over(boxes);
        BoxHierarchy again = BoxHierarchy.over(boxes);
        SplittableRandom random = new SplittableRandom(9);
        for (int i = 0; i < 20; i++) {
            Ray ray = new Ray();
            setRandomly(ray, random, 2);
            assertThat(visited(again, ray)).isEqualTo(visited(tree, ray)).isNotEmpty();
        }
    }

    @Test
    void next_givenATreeFarFromTheOrigin_testsAsFewBoxes() {
        double[] boxes = randomBoxes(new SplittableRandom(5), 2000, 0);
        double[] far = new double[boxes.length];
        for (int i = 0; i < boxes.length; i++) {
            far[i] = boxes[i] + 1e9;
        }
        BoxHierarchy tree = BoxHierarchy.over(boxes);
        BoxHierarchy farTree = BoxHierarchy.over(far);
        Ray near = ray(-3, 0.1, 0.2, 1, 0.1, 0.05);
        Ray distant = ray(1e9 - 3, 1e9 + 0.1, 1e9 + 0.2, 1, 0.1, 0.05);
        visited(tree, near);
        visited(farTree, distant);
        assertThat((double) distant.tests).isBetween(0.9 * near.tests, 1.1 * near.tests);
    }

    private static Ray ray(double ox, double oy, double oz, double dx, double dy, double dz) {
        Ray ray = new Ray();
        ray.set(ox, oy, oz, dx, dy, dz);
        return ray;
    }

    /** From about the origin, or from {@code distance} away towards it. */
    private static void setRandomly(Ray ray, SplittableRandom random, double distance) {
        double dx = random.nextDouble(-1, 1);
        double dy = random.nextDouble(-1, 1);
        double dz = random.nextDouble(-1, 1);
        ray.set(
                random.nextDouble(-1, 1) - dx * distance,
                random.nextDouble(-1, 1) - dy * distance,
                random.nextDouble(-1, 1) - dz * distance,
                dx,
                dy,
                dz);
    }

    private static List<Integer> visited(BoxHierarchy tree, Ray ray) {
        List<Integer> items = new ArrayList<>();
        int base = tree.enter(ray);
        for (int leaf = tree.next(ray, base); leaf != BoxHierarchy.DONE; leaf = tree.next(ray, base)) {
            for (int at = BoxHierarchy.first(leaf); at < BoxHierarchy.end(leaf); at++) {
                items.add(tree.item(at));
            }
        }
        assertThat(ray.stackTop).isZero();
        return items;
    }

    /** Boxes within about ±1 of an offset, most small, some flat, some points. */
    private static double[] randomBoxes(SplittableRandom random, int n, double offset) {
        double[] boxes = new double[6 * n];
        for (int i = 0; i < n; i++) {
            for (int axis = 0; axis < 3; axis++) {
                double low = random.nextDouble(-1, 1) + offset;
                double size = random.nextInt(5) == 0 ? 0 : 0.3 * Math.pow(random.nextDouble(), 3);
                boxes[6 * i + axis] = low;
                boxes[6 * i + 3 + axis] = low + size;
            }
        }
        return boxes;
    }

    private static void set(double[] boxes, int box, double x0, double y0, double z0, double x1, double y1, double z1) {
        System.arraycopy(new double[] {x0, y0, z0, x1, y1, z1}, 0, boxes, 6 * box, 6);
    }

    private static Bounds box(double[] boxes, int box) {
        int i = 6 * box;
        return new Bounds(boxes[i], boxes[i + 1], boxes[i + 2], boxes[i + 3], boxes[i + 4], boxes[i + 5]);
    }
}
