package org.diacaustic.reproduction;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class InsertionTreeTest {

    @Test
    void lookUp_givenEmptyTree_examinesNothing() {
        InsertionTree tree = new InsertionTree();
        tree.lookUp(0, 0, 0, 1, 0);
        assertThat(tree.nodesExamined()).isZero();
        assertThat(tree.height()).isZero();
        assertThat(tree.lookups()).isEqualTo(1);
    }

    @Test
    void lookUp_givenRandomPoints_usesThoseOfTheBallAndNoOthers() {
        SplittableRandom random = new SplittableRandom(5);
        InsertionTree tree = new InsertionTree();
        float[] points = new float[3 * 2000];
        for (int i = 0; i < 2000; i++) {
            // Few different coordinates, so that ties are many.
            for (int axis = 0; axis < 3; axis++) {
                points[3 * i + axis] = random.nextInt(12) / 4f;
            }
            tree.insert(points[3 * i], points[3 * i + 1], points[3 * i + 2], i % 2);
        }
        long used = 0;
        long foreign = 0;
        for (int lookup = 0; lookup < 200; lookup++) {
            float x = random.nextInt(12) / 4f;
            float y = random.nextInt(12) / 4f;
            float z = random.nextInt(12) / 4f;
            for (int i = 0; i < 2000; i++) {
                float dx = points[3 * i] - x;
                float dy = points[3 * i + 1] - y;
                float dz = points[3 * i + 2] - z;
                if (dx * dx + dy * dy + dz * dz <= 0.25f) {
                    used++;
                    foreign += i % 2 == 1 ? 1 : 0;
                }
            }
            tree.lookUp(x, y, z, 0.5f, 0);
            assertThat(tree.photonsUsed()).isEqualTo(used);
            assertThat(tree.foreignPhotonsUsed()).isEqualTo(foreign);
        }
        assertThat(used).isGreaterThan(1000);
        assertThat(tree.mostNodes()).isLessThanOrEqualTo(2000);
        assertThat(tree.nodesExamined()).isLessThan(200 * 2000);
    }

    @Test
    void insert_givenPointsInOnePlace_growsByALevelForEach() {
        // What is not smaller goes right, so equal points hang below each other: the worst case, N levels.
        InsertionTree tree = new InsertionTree();
        for (int i = 0; i < 50; i++) {
            tree.insert(1, 2, 3, 0);
        }
        assertThat(tree.height()).isEqualTo(50);
        tree.lookUp(1, 2, 3, 0, 0);
        assertThat(tree.nodesExamined()).isEqualTo(50);
        assertThat(tree.photonsUsed()).isEqualTo(50);
    }

    @Test
    void insert_givenPointsInAGoodOrder_isAsFlatAsCanBe() {
        // Middle first, then the middles of the halves: x splits 4, then y is the same for all, then z: 7 points, 3
        // levels.
        InsertionTree tree = new InsertionTree();
        float[][] points = {
            {4, 0, 0}, {2, 1, 0}, {2, 0, 0}, {2, 2, 0}, {6, 1, 0}, {6, 0, 0}, {6, 2, 0},
        };
        for (float[] point : points) {
            tree.insert(point[0], point[1], point[2], 0);
        }
        assertThat(tree.size()).isEqualTo(7);
        assertThat(tree.height()).isEqualTo(3);
        // Far to the left: the root, and of the left half only what lies towards y = 0.
        tree.lookUp(0, -5, 0, 1, 0);
        assertThat(tree.nodesExamined()).isEqualTo(3);
        assertThat(tree.photonsUsed()).isZero();
    }
}
