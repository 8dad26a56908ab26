package org.diacaustic.index;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.diacaustic.parallel.Workers;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class BoxTreeTest {
    private static final int LEAF = 4;
    private static final Workers ONE = new Workers(1);

    private final SplittableRandom random = new SplittableRandom(4);
    private final BoxWalk walk = new BoxWalk();

    @Test
    void over_givenAPlaceThatIsNotFinite_throws() {
        Boxes boxes = Boxes.random(100, 0.1f, 1);
        boxes.middle[1][70] = Float.NaN;
        assertThatThrownBy(() -> boxes.tree(ONE)).isInstanceOf(IllegalArgumentException.class);
    }

    @Test
    void next_givenNoItems_isDone() {
        BoxTree tree = Boxes.random(0, 0, 1).tree(ONE);
        everywhere();
        tree.start(walk);
        assertThat(tree.next(walk)).isEqualTo(BoxTree.DONE);
        assertThat(tree.depth()).isZero();
        assertThat(tree.leafCount()).isZero();
        assertThat(tree.bytes()).isZero();
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 4, 5, 63, 64, 65, 255, 256, 257, 20000})
    void next_givenAllSpace_givesEachItemOnceInOrder(int size) {
        Boxes boxes = Boxes.random(size, 0.01f, size);
        BoxTree tree = boxes.tree(new Workers(2));
        everywhere();
        tree.start(walk);
        int next = 0;
        for (int leaf = tree.next(walk); leaf != BoxTree.DONE; leaf = tree.next(walk)) {
            assertThat(tree.first(leaf)).isEqualTo(next);
            assertThat(tree.end(leaf) - next).isBetween(1, LEAF);
            assertThat(walk.cutting()).isZero();
            next = tree.end(leaf);
        }
        assertThat(next).isEqualTo(size);
        assertThat(Arrays.stream(boxes.numbers).sorted().toArray())
                .isEqualTo(IntStream.range(0, size).toArray());
        assertThat(tree.leafCount()).isEqualTo(1 << tree.depth() - 1);
    }

    @ParameterizedTest
    @ValueSource(floats = {0, 0.001f, 0.3f})
    void next_givenAConvexRegion_missesNoItemThatTouchesIt(float extent) {
        Boxes boxes = Boxes.random(3000, extent, 7);
        BoxTree tree = boxes.tree(ONE);
        long given = 0;
        long touching = 0;
        for (int query = 0; query < 300; query++) {
            double[] region = new double[6 + 4 * random.nextInt(5)];
            randomRegion(region);
            boolean[] found = new boolean[boxes.size()];
            tree.start(walk);
            for (int leaf = tree.next(walk); leaf != BoxTree.DONE; leaf = tree.next(walk)) {
                for (int i = tree.first(leaf); i < tree.end(leaf); i++) {
                    found[i] = true;
                    for (int plane = 0; 6 + 4 * plane < region.length; plane++) {
                        assertThat((walk.cutting() >> plane & 1) != 0 || nearest(boxes, i, region, plane) > 0)
                                .as("a plane that does not cut the leaf has its items inside")
                                .isTrue();
                    }
                    given++;
                }
            }
            for (int i = 0; i < found.length; i++) {
                boolean touches = touches(boxes, i, region);
                assertThat(found[i] || !touches).isTrue();
                touching += touches ? 1 : 0;
            }
        }
        assertThat(touching).isPositive();
        // Leaves hold up to 4 items, and boxes between two planes may be taken to touch.
        assertThat(given).isLessThan(9 * touching);
    }

    @Test
    void next_givenBoundsThatAreNotNumbers_boundsNothingThere() {
        Boxes boxes = Boxes.random(1000, 0.01f, 2);
        BoxTree tree = boxes.tree(ONE);
        walk.box(Double.NaN, Double.NEGATIVE_INFINITY, 0.4, Double.NaN, Double.POSITIVE_INFINITY, 0.6);
        tree.start(walk);
        int touching = 0;
        for (int leaf = tree.next(walk); leaf != BoxTree.DONE; leaf = tree.next(walk)) {
            for (int i = tree.first(leaf); i < tree.end(leaf); i++) {
                touching += boxes.low(2, i) <= 0.6f && boxes.high(2, i) >= 0.4f ? 1 : 0;
            }
        }
        int expected = (int) IntStream.range(0, 1000)
                .filter(i -> boxes.low(2, i) <= 0.6f && boxes.high(2, i) >= 0.4f)
                .count();
        assertThat(touching).isEqualTo(expected).isGreaterThan(150);
    }

    @Test
    void next_givenASmallRegion_looksAtFewNodes() {
        BoxTree tree = Boxes.random(100_000, 0.001f, 3).tree(new Workers(2));
        walk.box(0.5, 0.5, 0.5, 0.501, 0.501, 0.501);
        tree.start(walk);
        while (tree.next(walk) != BoxTree.DONE) {
            continue;
        }
        assertThat(walk.examined()).isBetween(1L, 150L);
    }

    @ParameterizedTest
    @ValueSource(ints = {20, 300, 3000})
    void over_givenLargeItemsAmongSmallOnes_looksAtFewerNodesForTheirExtents(int large) {
        Boxes plain = Boxes.random(20_000, 0.002f, 3).enlarged(large);
        Boxes sized = Boxes.random(20_000, 0.002f, 3).enlarged(large);
        BoxTree blind = plain.tree(ONE);
        BoxTree tree = BoxTree.over(
                sized.middle[0],
                sized.middle[1],
                sized.middle[2],
                sized.extents(),
                sized.numbers,
                LEAF,
                () -> sized::box,
                ONE);
        assertThat(2 * examined(tree)).isLessThan(examined(blind));
    }

    private static long examined(BoxTree tree) {
        BoxWalk some = new BoxWalk();
        for (double at = 0.1; at < 0.9; at += 0.005) {
            some.box(at, at, at, at + 0.002, at + 0.002, at + 0.002);
            tree.start(some);
            while (tree.next(some) != BoxTree.DONE) {
                continue;
            }
        }
        return some.examined();
    }

    @Test
    void over_givenEqualPlaces_isAsBalanced() {
        BoxTree tree = Boxes.random(4096, 0, 3).atOnePlace().tree(ONE);
        assertThat(tree.depth()).isEqualTo(11);
    }

    @ParameterizedTest
    @ValueSource(ints = {1000, 50000})
    void over_givenAnyNumberOfThreads_givesTheSameTree(int size) {
        Boxes once = Boxes.random(size, 0.01f, 9);
        Boxes again = Boxes.random(size, 0.01f, 9);
        BoxTree first = once.tree(ONE);
        BoxTree second = again.tree(new Workers(3));
        assertThat(again.numbers).isEqualTo(once.numbers);
        for (int leaf = 0; leaf < first.leafCount(); leaf++) {
            for (int axis = 0; axis < 3; axis++) {
                assertThat(second.middle(leaf, axis)).isEqualTo(first.middle(leaf, axis));
            }
        }
    }

    private void everywhere() {
        double all = Double.POSITIVE_INFINITY;
        walk.box(-all, -all, -all, all, all, all);
    }

    /** A box and planes: six bounds, then n and c of each plane. */
    private void randomRegion(double[] region) {
        for (int axis = 0; axis < 3; axis++) {
            double middle = random.nextDouble();
            double half = 0.3 * random.nextDouble();
            region[axis] = middle - half;
            region[3 + axis] = middle + half;
        }
        walk.box(region[0], region[1], region[2], region[3], region[4], region[5]);
        for (int i = 6; i < region.length; i += 4) {
            double through = 0;
            // Any length: only the sign of a distance counts.
            double length = StrictMath.pow(10, random.nextDouble(-20, 20));
            for (int axis = 0; axis < 3; axis++) {
                region[i + axis] = length * random.nextDouble(-1, 1);
                through -= region[i + axis] * (0.5 * (region[axis] + region[3 + axis]) + random.nextDouble(-0.1, 0.1));
            }
            region[i + 3] = through;
            walk.cut(region[i], region[i + 1], region[i + 2], through, 0x1p-20 * length);
        }
    }

    private static boolean touches(Boxes boxes, int item, double[] region) {
        for (int axis = 0; axis < 3; axis++) {
            if (boxes.low(axis, item) > region[3 + axis] || boxes.high(axis, item) < region[axis]) {
                return false;
            }
        }
        for (int i = 6; i < region.length; i += 4) {
            double farthest = region[i + 3];
            for (int axis = 0; axis < 3; axis++) {
                farthest +=
                        Math.max(region[i + axis] * boxes.low(axis, item), region[i + axis] * boxes.high(axis, item));
            }
            if (farthest < 0) {
                return false;
            }
        }
        return true;
    }

    private static double nearest(Boxes boxes, int item, double[] region, int plane) {
        int i = 6 + 4 * plane;
        double nearest = region[i + 3];
        for (int axis = 0; axis < 3; axis++) {
            nearest += Math.min(region[i + axis] * boxes.low(axis, item), region[i + axis] * boxes.high(axis, item));
        }
        return nearest;
    }

    /** Boxes of one size class, in a unit cube. */
    private static final class Boxes {
        final float[][] middle;
        final float[][] half;
        final int[] numbers;

        private Boxes(int size) {
            middle = new float[3][size];
            half = new float[3][size];
            numbers = IntStream.range(0, size).toArray();
        }

        static Boxes random(int size, float extent, long seed) {
            SplittableRandom random = new SplittableRandom(seed);
            Boxes boxes = new Boxes(size);
            for (int i = 0; i < size; i++) {
                for (int axis = 0; axis < 3; axis++) {
                    boxes.middle[axis][i] = (float) random.nextDouble();
                    boxes.half[axis][i] = (float) (extent * random.nextDouble());
                }
            }
            return boxes;
        }

        /** Makes the first boxes much larger than all. */
        Boxes enlarged(int count) {
            for (float[] halves : half) {
                Arrays.fill(halves, 0, count, 2);
            }
            return this;
        }

        float[] extents() {
            float[] extents = new float[size()];
            for (int i = 0; i < extents.length; i++) {
                extents[i] = 2 * Math.max(half[0][i], Math.max(half[1][i], half[2][i]));
            }
            return extents;
        }

        Boxes atOnePlace() {
            for (float[] coordinates : middle) {
                Arrays.fill(coordinates, 0.5f);
            }
            return this;
        }

        /** Middles are in the tree's order afterwards, extents in the first. */
        BoxTree tree(Workers workers) {
            return BoxTree.over(
                    middle[0],
                    middle[1],
                    middle[2],
                    new float[numbers.length],
                    numbers,
                    LEAF,
                    () -> this::box,
                    workers);
        }

        private void box(int leaf, int first, int end, float[] boxes, int place) {
            for (int axis = 0; axis < 3; axis++) {
                float low = Float.POSITIVE_INFINITY;
                float high = Float.NEGATIVE_INFINITY;
                for (int i = first; i < end; i++) {
                    low = Math.min(low, low(axis, i));
                    high = Math.max(high, high(axis, i));
                }
                boxes[place + axis] = low;
                boxes[place + 3 + axis] = high;
            }
        }

        int size() {
            return numbers.length;
        }

        float low(int axis, int item) {
            return middle[axis][item] - half[axis][numbers[item]];
        }

        float high(int axis, int item) {
            return middle[axis][item] + half[axis][numbers[item]];
        }
    }
}
