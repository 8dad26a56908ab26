package org.diacaustic.shape;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;

class MeshDataTest {
    private static final double[] VERTICES = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    private static final int[] TRIANGLE = {0, 1, 2};

    @Test
    void constructor_givenNumbersThatDoNotFit_throwsAndNamesThem() {
        assertRefused(new double[8], TRIANGLE, null, null, "vertices");
        assertRefused(VERTICES, new int[] {0, 1}, null, null, "triangles");
        assertRefused(VERTICES, new int[] {0, 1, 3}, null, null, "triangle 0 names vertex 3");
        assertRefused(VERTICES, new int[] {0, 1, 2, 0, -1, 2}, null, null, "triangle 1 names vertex -1");
        assertRefused(VERTICES, TRIANGLE, new double[6], null, "normals");
        assertRefused(VERTICES, TRIANGLE, null, new double[9], "maps");
    }

    @Test
    void constructor_givenNumbersThatAreNotFinite_throwsAndNamesTheVertex() {
        double[] vertices = VERTICES.clone();
        vertices[5] = Double.NaN;
        assertRefused(vertices, TRIANGLE, null, null, "vertex 1");
        assertRefused(VERTICES, TRIANGLE, null, new double[] {0, 0, 0, 0, 0, Double.POSITIVE_INFINITY}, "vertex 2");
    }

    @Test
    void counts_givenOneTriangle_areThreeAndOne() {
        MeshData data = new MeshData(VERTICES, TRIANGLE, null, null);
        assertThat(data.vertexCount()).isEqualTo(3);
        assertThat(data.triangleCount()).isEqualTo(1);
    }

    private static void assertRefused(
            double[] vertices, int[] triangles, double[] normals, double[] maps, String message) {
        assertThatThrownBy(() -> new MeshData(vertices, triangles, normals, maps))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining(message);
    }
}
