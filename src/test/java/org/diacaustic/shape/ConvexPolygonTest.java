package org.diacaustic.shape;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;
import static org.diacaustic.shape.Line.v;

import java.util.SplittableRandom;
import org.diacaustic.math.Ray;
import org.diacaustic.math.Vector3;
import org.junit.jupiter.api.Test;

class ConvexPolygonTest {
    private final ConvexPolygon square = ConvexPolygon.oneSided(v(0, 0, 0), v(1, 0, 0), v(1, 1, 0), v(0, 1, 0));

    @Test
    void polygon_givenBadVertices_isRefusedNamingOne() {
        refused("at least 3", v(0, 0, 0), v(1, 0, 0));
        refused("vertex 1", v(0, 0, 0), v(Double.NaN, 0, 0), v(0, 1, 0));
        refused(
                "vertex 2 (counted from 0) at [1.0, 0.0, 0.0] of the polygon repeats vertex 1",
                v(0, 0, 0),
                v(1, 0, 0),
                v(1, 0, 0),
                v(0, 1, 0));
        refused("no area", v(0, 0, 0), v(1, 1, 1), v(2, 2, 2));
        refused("flat, but vertex 3", v(0, 0, 0), v(2, 0, 0), v(3, 1, 0), v(2, 2, 0.01), v(0, 2, 0), v(-1, 1, 0));
        refused("inward at vertex 3", v(0, 0, 0), v(4, 0, 0), v(4, 4, 0), v(2, 1, 0), v(0, 4, 0));
        // A bow tie, and a star that turns the same way at all its points.
        refused("no area", v(0, 0, 0), v(2, 2, 0), v(2, 0, 0), v(0, 2, 0));
        refused("cross itself", star());
        // A spike: the outline runs back along itself.
        refused("inward at vertex 2", v(0, 0, 0), v(1, 0, 0), v(2, 0, 0), v(1.5, 0, 0), v(0, 1, 0));
    }

    private static void refused(String message, Vector3... vertices) {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> ConvexPolygon.twoSided(vertices))
                .withMessageContaining(message);
    }

    private static Vector3[] star() {
        Vector3[] star = new Vector3[5];
        for (int i = 0; i < 5; i++) {
            double angle = StrictMath.toRadians(144 * i);
            star[i] = v(StrictMath.cos(angle), StrictMath.sin(angle), 0);
        }
        return star;
    }

    @Test
    void polygon_givenSliverOrFarVertices_isAccepted() {
        ConvexPolygon sliver = ConvexPolygon.twoSided(v(0, 0, 0), v(1, 0, 0), v(0.5, 1e-9, 0));
        assertThat(Line.meet(sliver, v(0.5, 5e-10, 3), v(0, 0, -1)).t).isEqualTo(3);
        double far = 1e8;
        ConvexPolygon triangle = ConvexPolygon.twoSided(v(far, far, far), v(far + 1, far, far), v(far, far + 1, far));
        assertThat(Line.meet(triangle, v(far + 0.25, far + 0.25, far + 10), v(0, 0, -1)).t)
                .isEqualTo(10);
        // A vertex in the middle of an edge.
        assertThat(ConvexPolygon.twoSided(v(0, 0, 0), v(1, 0, 0), v(2, 0, 0), v(0, 1, 0))
                        .vertexCount())
                .isEqualTo(4);
    }

    @Test
    void intersect_givenOneSided_isInvisibleFromBehind() {
        assertThat(square.normal()).isEqualTo(Vector3.UNIT_Z);
        assertThat(Line.meet(square, v(0.5, 0.5, 2), v(0, 0, -1)).t).isEqualTo(2);
        assertThat(Line.meet(square, v(0.5, 0.5, -2), v(0, 0, 1))).isNull();
        ConvexPolygon both = ConvexPolygon.twoSided(v(0, 0, 0), v(1, 0, 0), v(1, 1, 0), v(0, 1, 0));
        assertThat(Line.meet(both, v(0.5, 0.5, -2), v(0, 0, 1)).normalZ).isEqualTo(1);
    }

    @Test
    void intersect_givenHugeTriangleOneMicrometreBelow_hits() {
        ConvexPolygon huge = ConvexPolygon.twoSided(v(-1e6, 0, -1e6), v(2e6, 0, -1e6), v(-1e6, 0, 2e6));
        assertThat(Line.meet(huge, v(0.1, 1e-6, 0.1), v(0, -1, 0)).t).isEqualTo(1e-6);
    }

    @Test
    void intersect_givenFanAroundAPoint_leavesNoGapAtSharedEdgesAndVertices() {
        // Ten quadrilaterals around a hub, in one plane, bounded outside by a decagon.
        SplittableRandom random = new SplittableRandom(7);
        int misses = 0;
        for (int round = 0; round < 200; round++) {
            Vector3 a = v(random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1))
                    .normalized();
            Vector3 b = a.perpendicular();
            Vector3 hub = v(random.nextDouble(-9, 9), random.nextDouble(-9, 9), random.nextDouble(-9, 9));
            Vector3[] rim = new Vector3[20];
            for (int i = 0; i < 20; i++) {
                double angle = Math.PI * i / 10;
                rim[i] = hub.plus(a.times(StrictMath.cos(angle))).plus(b.times(StrictMath.sin(angle)));
            }
            ConvexPolygon[] fan = new ConvexPolygon[10];
            for (int i = 0; i < 10; i++) {
                fan[i] = ConvexPolygon.twoSided(hub, rim[2 * i], rim[2 * i + 1], rim[(2 * i + 2) % 20]);
            }
            Vector3 eye = hub.plus(a.cross(b).times(3)).plus(v(random.nextDouble(), random.nextDouble(), 0));
            for (int i = 0; i < 100; i++) {
                // A third through the hub, the rest at points of the shared edges.
                double along = i % 3 == 0 ? 0 : random.nextDouble(0.95);
                Vector3 spoke = rim[2 * (i % 10)].minus(hub).times(along);
                Ray ray = new Ray();
                ray.set(eye, hub.plus(spoke).minus(eye));
                boolean found = false;
                for (ConvexPolygon polygon : fan) {
                    found |= polygon.intersect(ray);
                }
                misses += found ? 0 : 1;
            }
        }
        assertThat(misses).isZero();
    }

    @Test
    void intersect_givenRayThroughSharedEdge_hitsBoth() {
        ConvexPolygon left = ConvexPolygon.twoSided(v(-1, 0, 0), v(0, 0, 0), v(0, 1, 0), v(-1, 1, 0));
        assertThat(Line.meet(left, v(0, 0.5, 1), v(0, 0, -1))).isNotNull();
        assertThat(Line.meet(square, v(0, 0.5, 1), v(0, 0, -1))).isNotNull();
    }

    @Test
    void inverseMap_givenParallelogram_isExact() {
        mapped(new double[][] {{0, 0}, {2, 0}, {2, 1}, {0, 1}}, 0.5, 0.75, 0.25, 0.75);
    }

    @Test
    void inverseMap_givenTrapezoid_solvesTheQuadratic() {
        mapped(
                new double[][] {{0, 0}, {2, 0}, {1.5, 1}, {0.5, 1}},
                1.2,
                0.4,
                0.6249999999999999739791479,
                0.4000000000000000222044605);
    }

    @Test
    void inverseMap_givenNearlyASquare_keepsAllDigits() {
        mapped(
                new double[][] {{0, 0}, {1, 0}, {1.000000000001, 1}, {0, 1}},
                0.3,
                0.6,
                0.299999999999819972895665,
                0.5999999999999999777955395);
    }

    /** Lies the polygon in each of the three coordinate planes, from both sides. */
    private static void mapped(double[][] corners, double x, double y, double u, double v) {
        for (int turn = 0; turn < 3; turn++) {
            for (double sign : new double[] {1, -1}) {
                Vector3[] vertices = new Vector3[4];
                for (int i = 0; i < 4; i++) {
                    vertices[i] = turned(turn, corners[i][0], sign * corners[i][1], 0);
                }
                ConvexPolygon polygon = ConvexPolygon.twoSided(vertices);
                Hit hit = Line.meet(polygon, turned(turn, x, sign * y, 1), turned(turn, 0, 0, -1));
                polygon.inverseMap(hit);
                assertThat(hit.u).isCloseTo(u, within(8.9e-16));
                assertThat(hit.v).isCloseTo(v, within(1.4e-15));
            }
        }
    }

    private static Vector3 turned(int turn, double x, double y, double z) {
        return turn == 0 ? v(x, y, z) : turn == 1 ? v(z, x, y) : v(y, z, x);
    }

    @Test
    void inverseMap_givenRandomQuadrilaterals_undoesTheBilinearMap() {
        SplittableRandom random = new SplittableRandom(9);
        for (int i = 0; i < 2000; i++) {
            // Corners near those of the unit square stay convex; the fourth is put in the plane of the others.
            double[] c = random.doubles(8, -0.2, 0.2).toArray();
            Vector3 ex = v(1, 0.5, 0.25);
            Vector3 ey = v(-0.5, 1, 0.75);
            Vector3 p0 = ex.times(c[0]).plus(ey.times(c[1]));
            Vector3 p1 = ex.times(1 + c[2]).plus(ey.times(c[3]));
            Vector3 p2 = ex.times(1 + c[4]).plus(ey.times(1 + c[5]));
            Vector3 p3 = ex.times(c[6]).plus(ey.times(1 + c[7]));
            ConvexPolygon polygon = ConvexPolygon.twoSided(p0, p1, p2, p3);
            double u = random.nextDouble();
            double w = random.nextDouble();
            Vector3 p = p0.times((1 - u) * (1 - w))
                    .plus(p1.times(u * (1 - w)))
                    .plus(p2.times(u * w))
                    .plus(p3.times((1 - u) * w));
            Hit hit = new Hit();
            hit.setPoint(p.x(), p.y(), p.z(), 0);
            polygon.inverseMap(hit);
            assertThat(hit.u).isCloseTo(u, within(1e-14));
            assertThat(hit.v).isCloseTo(w, within(1e-14));
        }
    }

    @Test
    void contains_givenNotchedPolygon_leavesOutTheNotch() {
        double[] x = {0, 4, 4, 2, 0};
        double[] y = {0, 0, 4, 1, 4};
        assertThat(PolygonContainment.contains(x, y, 2, 0.5)).isTrue();
        assertThat(PolygonContainment.contains(x, y, 2, 2)).isFalse();
        assertThat(PolygonContainment.contains(x, y, 1, 2)).isTrue();
        assertThat(PolygonContainment.contains(x, y, 3, 2)).isTrue();
    }

    @Test
    void contains_givenBowTie_followsTheEvenOddRule() {
        double[] x = {0, 2, 2, 0};
        double[] y = {0, 2, 0, 2};
        assertThat(PolygonContainment.contains(x, y, 0.25, 1)).isTrue();
        assertThat(PolygonContainment.contains(x, y, 1.75, 1)).isTrue();
        assertThat(PolygonContainment.contains(x, y, 1, 0.25)).isFalse();
    }

    @Test
    void contains_givenPointsOfSharedEdge_belongToExactlyOne() {
        double[] leftX = {0, 1, 3, 0};
        double[] leftY = {0, 0, 3, 3};
        double[] rightX = {1, 4, 4, 3};
        double[] rightY = {0, 0, 3, 3};
        for (int i = 1; i < 8; i++) {
            double x = 1 + 2 * i / 8.0;
            double y = 3 * i / 8.0;
            assertThat(PolygonContainment.contains(leftX, leftY, x, y))
                    .isNotEqualTo(PolygonContainment.contains(rightX, rightY, x, y));
        }
    }
}
