package org.diacaustic.scenefile;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import java.util.stream.IntStream;
import org.diacaustic.math.Vector3;
import org.junit.jupiter.api.Test;

class PolygonCutterTest {
    private final IntList triangles = new IntList();

    private static Vector3 corner(double[] vertices, int index) {
        return new Vector3(vertices[3 * index], vertices[3 * index + 1], vertices[3 * index + 2]);
    }

    /** Twice the area vector of each triangle. */
    private Vector3[] areas(double[] vertices) {
        Vector3[] areas = new Vector3[triangles.size() / 3];
        for (int i = 0; i < areas.length; i++) {
            Vector3 a = corner(vertices, triangles.get(3 * i));
            Vector3 b = corner(vertices, triangles.get(3 * i + 1));
            Vector3 c = corner(vertices, triangles.get(3 * i + 2));
            areas[i] = b.minus(a).cross(c.minus(a));
        }
        return areas;
    }

    private static int[] all(double[] vertices) {
        return IntStream.range(0, vertices.length / 3).toArray();
    }

    @Test
    void cut_givenLShape_coversItWithoutOverlap() {
        double[] vertices = {0, 0, 5, 2, 0, 5, 2, 1, 5, 1, 1, 5, 1, 2, 5, 0, 2, 5};
        PolygonCutter cutter = new PolygonCutter(vertices, triangles);

        assertThat(cutter.cut(all(vertices))).isTrue();
        // Area 3 in 4 triangles that all face +z: none lies outside, for the sum would then exceed it.
        assertThat(areas(vertices))
                .hasSize(4)
                .allSatisfy(area -> assertThat(area.z()).isPositive());
        assertThat(IntStream.range(0, 4)
                        .mapToDouble(i -> areas(vertices)[i].z())
                        .sum())
                .isEqualTo(6);
        assertThat(cutter.uncertainCount()).isZero();
    }

    @Test
    void cut_givenConcaveQuadWhoseFirstDiagonalLiesOutside_takesTheOther() {
        // An arrowhead; the fan from corner 0 would turn over one triangle.
        double[] vertices = {2, 0, 0, 0, 1, 0, 0.5, 0, 0, 0, -1, 0};
        int[] turned = {1, 2, 3, 0};
        new PolygonCutter(vertices, triangles).cut(turned);

        assertThat(areas(vertices))
                .hasSize(2)
                .allSatisfy(area -> assertThat(area.z()).isPositive());
    }

    @Test
    void cut_givenOutlineThatCrossesItself_endsAndCountsIt() {
        // A bow tie with one wing larger than the other.
        double[] vertices = {0, 0, 0, 4, 3, 0, 4, 0, 0, 0, 1, 0};
        PolygonCutter cutter = new PolygonCutter(vertices, triangles);
        cutter.cut(all(vertices));

        assertThat(triangles.size()).isEqualTo(6);
        assertThat(cutter.uncertainCount()).isEqualTo(1);
    }

    @Test
    void cut_givenHoleJoinedToTheRim_leavesTheHoleOpen() {
        // A 4×4 square with a 2×2 hole, joined by a seam that is walked both ways: area 16 − 4.
        double[] vertices = {0, 0, 0, 4, 0, 0, 4, 4, 0, 0, 4, 0, 0, 0, 0, 1, 1, 0, 1, 3, 0, 3, 3, 0, 3, 1, 0, 1, 1, 0};
        PolygonCutter cutter = new PolygonCutter(vertices, triangles);
        cutter.cut(all(vertices));

        Vector3[] areas = areas(vertices);
        assertThat(areas).allSatisfy(area -> assertThat(area.z()).isNotNegative());
        assertThat(IntStream.range(0, areas.length)
                        .mapToDouble(i -> areas[i].z())
                        .sum())
                .isEqualTo(24);
    }

    @Test
    void cut_givenRandomStarShapes_coversTheOutlinesAreaInAnyPlane() {
        Random random = new Random(3);
        for (int trial = 0; trial < 200; trial++) {
            int corners = 4 + random.nextInt(30);
            Vector3 u = new Vector3(random.nextGaussian(), random.nextGaussian(), random.nextGaussian()).normalized();
            Vector3 v = u.perpendicular();
            double[] vertices = new double[3 * corners];
            double outline = 0;
            double[] radii = new double[corners];
            for (int i = 0; i < corners; i++) {
                radii[i] = 0.2 + random.nextDouble();
                double angle = 2 * Math.PI * i / corners;
                Vector3 p = u.times(radii[i] * StrictMath.cos(angle)).plus(v.times(radii[i] * StrictMath.sin(angle)));
                vertices[3 * i] = p.x();
                vertices[3 * i + 1] = p.y();
                vertices[3 * i + 2] = p.z();
            }
            for (int i = 0; i < corners; i++) {
                outline += radii[i] * radii[(i + 1) % corners] * StrictMath.sin(2 * Math.PI / corners);
            }
            IntList cut = new IntList();
            PolygonCutter cutter = new PolygonCutter(vertices, cut);
            cutter.cut(all(vertices));
            double sum = 0;
            for (int i = 0; i < cut.size(); i += 3) {
                Vector3 a = corner(vertices, cut.get(i));
                sum += corner(vertices, cut.get(i + 1))
                        .minus(a)
                        .cross(corner(vertices, cut.get(i + 2)).minus(a))
                        .length();
            }

            assertThat(cut.size()).isEqualTo(3 * (corners - 2));
            assertThat(cutter.uncertainCount()).isZero();
            assertThat(sum).isBetween(outline * (1 - 1e-12), outline * (1 + 1e-12));
        }
    }

    @Test
    void cut_givenTooManyConcaveCorners_refusesThem() {
        int corners = PolygonCutter.MOST_CONCAVE_CORNERS + 2;
        double[] vertices = new double[3 * corners];
        for (int i = 0; i < corners; i++) {
            vertices[3 * i] = StrictMath.cos(2 * Math.PI * i / corners) * (1 + i % 2);
            vertices[3 * i + 1] = StrictMath.sin(2 * Math.PI * i / corners) * (1 + i % 2);
        }

        assertThat(new PolygonCutter(vertices, triangles).cut(all(vertices))).isFalse();
    }
}
