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

class PointTreeTest {
    private static final Workers ONE = new Workers(1);

    private final PointWalk walk = new PointWalk();

    @Test
    void over_givenACoordinateThatIsNotFinite_throws() {
        PointClouds cloud = PointClouds.cube(100, 1).set(70, 0, Float.NaN, 0);
        assertThatThrownBy(() -> arrange(cloud, ONE))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("point 70");
        PointClouds infinite = PointClouds.cube(100, 1).set(3, 0, 0, Float.NEGATIVE_INFINITY);
        assertThatThrownBy(() -> arrange(infinite, ONE)).isInstanceOf(IllegalArgumentException.class);
    }

    @Test
    void over_givenTooFewCoordinates_throws() {
        assertThatThrownBy(() -> PointTree.over(new float[4], new float[3], new float[4], new int[4], ONE))
                .isInstanceOf(IllegalArgumentException.class);
    }

    @Test
    void start_givenWhatIsNotANumber_throws() {
        PointTree tree = arrange(PointClouds.cube(100, 1), ONE).tree;
        assertThatThrownBy(() -> tree.start(walk, Float.NaN, 0, 0, 1)).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> tree.start(walk, 0, 0, 0, Float.NaN)).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> tree.start(walk, 0, 0, 0, -1)).isInstanceOf(IllegalArgumentException.class);
    }

    @Test
    void next_givenNoPoints_isDone() {
        PointTree tree = arrange(new PointClouds(0), ONE).tree;
        tree.start(walk, 0, 0, 0, Float.POSITIVE_INFINITY);
        assertThat(tree.next(walk)).isEqualTo(PointTree.DONE);
        assertThat(tree.depth()).isZero();
        assertThat(tree.size()).isZero();
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 31, 32, 33, 511, 512, 513, 1023, 1024, 1025, 20000})
    void over_givenAnyNumberOfPoints_keepsEachOnceInBalancedLeaves(int size) {
        Arranged arranged = arrange(PointClouds.cube(size, 42), new Workers(2));
        assertThat(Arrays.stream(arranged.numbers).sorted().toArray()).isEqualTo(range(size));
        assertThat(arranged.largestLeaf()).isBetween(1, PointTree.LARGEST_LEAF);
        assertThat(arranged.leafCount()).isEqualTo(1 << arranged.tree.depth() - 1);
        // A tree with one point a node has ceil(log2(n + 1)) levels.
        assertThat(arranged.tree.depth()).isLessThanOrEqualTo(32 - Integer.numberOfLeadingZeros(size));
    }

    @Test
    void over_givenEqualOrCollinearPoints_isAsBalanced() {
        PointClouds line = new PointClouds(5000);
        for (int i = 0; i < 5000; i++) {
            line.set(i, i % 100, i % 100, i % 100);
        }
        for (PointClouds cloud : new PointClouds[] {PointClouds.equal(5000, 0.5f, 0.25f, 0.125f), line}) {
            Arranged arranged = arrange(cloud, ONE);
            assertThat(arranged.tree.depth()).isEqualTo(9);
            assertThat(arranged.largestLeaf()).isLessThanOrEqualTo(PointTree.LARGEST_LEAF);
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {1000, 50000})
    void over_givenAnyNumberOfThreads_givesTheSameOrder(int size) {
        PointClouds cloud = PointClouds.clusters(size, 9);
        int[] once = arrange(cloud, ONE).numbers;
        assertThat(arrange(cloud, new Workers(2)).numbers).isEqualTo(once);
        assertThat(arrange(cloud, new Workers(7)).numbers).isEqualTo(once);
    }

    @Test
    void over_givenPointsThatAreSorted_buildsInTheSameTime() {
        int size = 200_000;
        PointClouds sorted = new PointClouds(size);
        PointClouds organPipes = new PointClouds(size);
        for (int i = 0; i < size; i++) {
            sorted.set(i, i, 0, 0);
            organPipes.set(i, Math.min(i, size - i), 0, 0);
        }
        // Quadratic selection would take minutes.
        assertThat(arrange(sorted, ONE).tree.depth()).isEqualTo(14);
        assertThat(arrange(organPipes, ONE).tree.depth()).isEqualTo(14);
    }

    @ParameterizedTest
    @ValueSource(strings = {"cube", "clusters", "lattice", "equal"})
    void next_givenABall_handsOutEveryPointInIt(String kind) {
        PointClouds cloud = switch (kind) {
            case "cube" -> PointClouds.cube(3000, 5);
            case "clusters" -> PointClouds.clusters(3000, 5);
            case "lattice" -> PointClouds.lattice();
            default -> PointClouds.equal(3000, 0.5f, 0.5f, 0.5f);
        };
        Arranged arranged = arrange(cloud, ONE);
        SplittableRandom random = new SplittableRandom(3);
        float[] radii = {0, 0x1p-8f, 0x1p-4f, 0.3f, 5, Float.POSITIVE_INFINITY};
        for (int i = 0; i < 100; i++) {
            // Some balls are centred on points, so that others lie exactly on their surfaces.
            int on = random.nextInt(cloud.size());
            float px = i % 2 == 0 ? cloud.x[on] : (float) random.nextDouble(-0.5, 1.5);
            float py = i % 2 == 0 ? cloud.y[on] : (float) random.nextDouble(-0.5, 1.5);
            float pz = i % 2 == 0 ? cloud.z[on] : (float) random.nextDouble(-0.5, 1.5);
            float radius = radii[i / 2 % radii.length];
            long expected = IntStream.range(0, cloud.size())
                    .filter(p -> cloud.distanceSquared(p, px, py, pz) <= radius * radius)
                    .count();
            assertThat(arranged.count(walk, px, py, pz, radius * radius)).isEqualTo(expected);
        }
    }

    @Test
    void next_givenACentreAtInfinity_handsOutEverythingForAnInfiniteRadiusOnly() {
        Arranged arranged = arrange(PointClouds.cube(100, 5), ONE);
        assertThat(arranged.count(walk, Float.POSITIVE_INFINITY, 0, 0, 1e30f)).isZero();
        assertThat(arranged.count(walk, Float.POSITIVE_INFINITY, 0, 0, Float.POSITIVE_INFINITY))
                .isEqualTo(100);
    }

    @Test
    void next_givenASmallBall_looksAtFewNodes() {
        Arranged arranged = arrange(PointClouds.clusters(100_000, 5), ONE);
        arranged.count(walk, 0.5f, 0, 0.3f * (float) Math.sin(3.5), 1e-8f);
        assertThat(walk.examined()).isBetween(12L, 300L);
    }

    private static int[] range(int size) {
        return IntStream.range(0, size).toArray();
    }

    static Arranged arrange(PointClouds cloud, Workers workers) {
        PointClouds points = cloud.copy();
        int[] numbers = range(cloud.size());
        return new Arranged(PointTree.over(points.x, points.y, points.z, numbers, workers), points, numbers);
    }

    /** A tree, and its points in its order. */
    record Arranged(PointTree tree, PointClouds points, int[] numbers) {
        int leafCount() {
            int leaf = 0;
            while (tree.first(leaf) < tree.size()) {
                leaf++;
            }
            return leaf;
        }

        int largestLeaf() {
            return IntStream.range(0, leafCount())
                    .map(leaf -> tree.end(leaf) - tree.first(leaf))
                    .max()
                    .orElse(0);
        }

        int count(PointWalk walk, float px, float py, float pz, float radiusSquared) {
            int count = 0;
            tree.start(walk, px, py, pz, radiusSquared);
            for (int leaf = tree.next(walk); leaf != PointTree.DONE; leaf = tree.next(walk)) {
                for (int i = tree.first(leaf); i < tree.end(leaf); i++) {
                    count += points.distanceSquared(i, px, py, pz) <= radiusSquared ? 1 : 0;
                }
            }
            return count;
        }
    }
}
