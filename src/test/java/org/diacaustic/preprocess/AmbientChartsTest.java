package org.diacaustic.preprocess;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.function.Supplier;
import org.diacaustic.map.AmbientChart;
import org.diacaustic.map.AmbientMaps;
import org.diacaustic.map.AmbientOptions;
import org.diacaustic.map.Chart;
import org.diacaustic.map.IlluminationMap;
import org.diacaustic.map.InitialHits;
import org.diacaustic.map.PhotonSlice;
import org.diacaustic.map.PhotonStore;
import org.diacaustic.map.SurfacePoint;
import org.diacaustic.map.TexelGrid;
import org.diacaustic.material.Material;
import org.diacaustic.math.Color;
import org.diacaustic.math.Rgb;
import org.diacaustic.math.Transform;
import org.diacaustic.math.Vector3;
import org.diacaustic.parallel.Workers;
import org.diacaustic.scene.SceneIndex;
import org.diacaustic.scene.SceneObject;
import org.diacaustic.shape.Box;
import org.diacaustic.shape.ConvexPolygon;
import org.diacaustic.shape.Disc;
import org.diacaustic.shape.Ellipsoid;
import org.diacaustic.shape.Frustum;
import org.diacaustic.shape.MeshData;
import org.diacaustic.shape.Plane;
import org.diacaustic.shape.Shape;
import org.diacaustic.shape.Sphere;
import org.diacaustic.shape.Torus;
import org.diacaustic.shape.Transformed;
import org.diacaustic.shape.TriangleMesh;
import org.junit.jupiter.api.Test;

class AmbientChartsTest {
    private static final Workers WORKERS = new Workers(2);
    private static final double ECCENTRICITY = Math.sqrt(8.0 / 9);

    /** The area of an ellipsoid of radii 3, 1 and 1. */
    private static final double PROLATE = 2 * Math.PI * (1 + 3 / ECCENTRICITY * Math.asin(ECCENTRICITY));

    private static Vector3 v(double x, double y, double z) {
        return new Vector3(x, y, z);
    }

    private static SceneIndex matt(Shape... shapes) {
        return index(Material.builder().diffuse(Color.grey(0.5)).build(), shapes);
    }

    private static SceneIndex index(Material material, Shape... shapes) {
        List<SceneObject> objects = Arrays.stream(shapes)
                .map(shape -> new SceneObject("thing", shape, material))
                .toList();
        return SceneIndex.of(objects, false);
    }

    private static AmbientChart chart(Shape shape, int columns, int rows) {
        return AmbientCharts.of(matt(shape), ChartSizing.equal(columns, rows), WORKERS)
                .get(0);
    }

    /** The whole area as the texels of the shape's chart measure it. */
    private static double total(Shape shape, int columns, int rows) {
        TexelGrid grid = chart(shape, columns, rows).grid();
        return Arrays.stream(TexelAreas.of(shape, grid, WORKERS)).sum();
    }

    private static boolean isPlanar(AmbientChart chart) {
        return !chart.grid().chart().goesAround();
    }

    private static TriangleMesh mesh(double[] vertices, int... triangles) {
        return new TriangleMesh(new MeshData(vertices, triangles, null, null), false);
    }

    @Test
    void of_givenAPlane_namesItAndSaysWhatToUse() {
        assertThatThrownBy(() -> chart(new Plane(Vector3.ZERO, Vector3.UNIT_Y), 8, 8))
                .isInstanceOf(ForwardPlanException.class)
                .hasMessageContaining("'thing'")
                .hasMessageContaining("photon-map");
    }

    @Test
    void equal_givenNoTexels_refuses() {
        assertThatIllegalArgumentException().isThrownBy(() -> ChartSizing.equal(0, 8));
        assertThatIllegalArgumentException().isThrownBy(() -> ChartSizing.equal(8, -1));
    }

    @Test
    void of_givenObjectsThatShowNoDiffuseLight_givesThemNoChart() {
        SceneIndex glass =
                index(Material.builder().transparency(Color.grey(1)).build(), new Plane(Vector3.ZERO, Vector3.UNIT_Y));
        assertThat(AmbientCharts.of(glass, ChartSizing.equal(8, 8), WORKERS)).isEmpty();
        List<AmbientChart> two = AmbientCharts.of(
                matt(new Sphere(Vector3.ZERO, 1), new Sphere(Vector3.ZERO, 2)), ChartSizing.equal(8, 8), WORKERS);
        assertThat(two).extracting(AmbientChart::object).containsExactly(0, 1);
    }

    @Test
    void of_givenASphere_measuresZonesExactly() {
        // The zone between two heights has the area 2πr·(difference of heights).
        for (int rows : new int[] {9, 128}) {
            AmbientChart chart = chart(new Sphere(v(1, 2, 3), 3), 2 * rows, rows);
            for (int row = 0; row < rows; row++) {
                double height = 3 * (Math.cos(Math.PI * row / rows) - Math.cos(Math.PI * (row + 1) / rows));
                double zone = 2 * Math.PI * 3 * height;
                assertThat(chart.area(row * 2 * rows + row) * 2 * rows).isCloseTo(zone, within(1e-9 * zone));
            }
        }
    }

    @Test
    void of_givenAParallelogram_laysTexelsAlongItsEdges() {
        // (1, 0, −2) × (2, 0, 1) has the length 5: texels of 5/(6·4).
        AmbientChart chart = chart(ConvexPolygon.twoSided(v(0, 1, 0), v(1, 1, -2), v(3, 1, -1), v(2, 1, 1)), 6, 4);
        for (int texel = 0; texel < 24; texel++) {
            assertThat(chart.area(texel)).isCloseTo(5.0 / 24, within(1e-14));
        }
        assertThat(chart.grid().texel(0.01, 1, 0)).isZero();
        assertThat(chart.grid().texel(0.99, 1, -1.95)).isEqualTo(5);
        assertThat(chart.grid().texel(2.99, 1, -1)).isEqualTo(23);
    }

    @Test
    void of_givenATriangle_measuresWhatTheEdgesLeaveExactly() {
        // Legs 8 along x and 4 along z on a map of 8 × 4 whole texels: row r is cut by the long side from column 8 − 2r
        // on.
        double[] areas = PolygonAreas.of(
                new Vector3[] {v(0, 0, 0), v(8, 0, 0), v(0, 0, -4)},
                new TexelGrid(Chart.planar(Vector3.ZERO, v(8, 0, 0), v(0, 0, -4)), 8, 4));
        assertThat(new double[] {areas[0], areas[5], areas[6], areas[7], areas[8 + 4], areas[8 + 5], areas[8 + 6]})
                .containsExactly(new double[] {1, 1, 0.75, 0.25, 0.75, 0.25, 0}, within(1e-15));
        AmbientChart chart = chart(ConvexPolygon.twoSided(v(0, 0, 0), v(8, 0, 0), v(0, 0, -4)), 7, 5);
        assertThat(Arrays.stream(PolygonAreas.of(new Vector3[] {v(0, 0, 0), v(8, 0, 0), v(0, 0, -4)}, chart.grid()))
                        .sum())
                .isCloseTo(16, within(1e-13));
    }

    @Test
    void of_givenAPolygonWithAVertexOnAnEdge_laysARectangleAroundIt() {
        // A pentagon that is a square of 2 with a vertex in the middle of its first edge.
        AmbientChart chart =
                chart(ConvexPolygon.twoSided(v(0, 0, 0), v(1, 0, 0), v(2, 0, 0), v(2, 2, 0), v(0, 2, 0)), 4, 4);
        for (int texel = 0; texel < 16; texel++) {
            assertThat(chart.area(texel)).isCloseTo(0.25, within(1e-15));
        }
    }

    @Test
    void of_givenShapesOfKnownArea_findsIt() {
        expectArea(new Ellipsoid(v(1, 2, 3), v(3, 1, 1)), PROLATE, 1e-4);
        expectArea(new Box(v(0, 0, 0), v(1, 2, 3)), 22, 1e-3);
        expectArea(new Box(v(0, 0, 0), v(4, 0.1, 3)), 25.4, 1e-3);
        expectArea(Frustum.cylinder(v(0, 0, 0), v(0, 3, 0), 1, true), 8 * Math.PI, 1e-3);
        expectArea(Frustum.cylinder(v(0, 0, 0), v(1, 3, 0), 1, false), 2 * Math.PI * Math.sqrt(10), 1e-3);
        expectArea(Frustum.cone(v(0, 0, 0), 1, v(0, 2, 0), true), Math.PI * (1 + Math.sqrt(5)), 1e-3);
        expectArea(new Disc(v(1, 2, 3), v(1, 2, 3), 1, 2), 3 * Math.PI, 1e-3);
    }

    @Test
    void of_givenShapesThatFoldOverTheirMap_countsEveryFold() {
        // A torus, 4π²Rr, seen from the middle of its hole; lines from there only touch its flanks.
        expectArea(new Torus(v(1, 0, 0), v(1, 1, 0), 2, 0.5), 4 * Math.PI * Math.PI, 5e-3);
        // Two sheets over each other.
        expectArea(
                mesh(
                        new double[] {0, 0, 0, 2, 0, 0, 2, 0, 1, 0, 0, 1, 0, 0.5, 0, 2, 0.5, 0, 2, 0.5, 1, 0, 0.5, 1},
                        0,
                        2,
                        1,
                        0,
                        3,
                        2,
                        4,
                        6,
                        5,
                        4,
                        7,
                        6),
                4,
                1e-6);
    }

    @Test
    void of_givenMeshes_findsTheirArea() {
        // An octahedron with vertices at 1: 8 triangles of √3/2.
        expectArea(
                mesh(
                        new double[] {1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1},
                        0,
                        2,
                        4,
                        2,
                        1,
                        4,
                        1,
                        3,
                        4,
                        3,
                        0,
                        4,
                        2,
                        0,
                        5,
                        1,
                        2,
                        5,
                        3,
                        1,
                        5,
                        0,
                        3,
                        5),
                4 * Math.sqrt(3),
                1e-3);
    }

    private static void expectArea(Shape shape, double area, double tolerance) {
        for (int[] size : new int[][] {{64, 48}, {128, 96}}) {
            double found = total(shape, size[0], size[1]);
            assertThat(found / area).as("area of %s over its own", shape).isCloseTo(1, within(tolerance));
        }
    }

    @Test
    void of_givenFlatAndWavyOpenMeshes_mapsThemFromAbove() {
        TriangleMesh tilted = mesh(new double[] {0, 0, 0, 1, 1, 0, 1, 1, 1, 0, 0, 1}, 0, 2, 1, 0, 3, 2);
        AmbientChart chart = chart(tilted, 16, 16);
        assertThat(isPlanar(chart)).isTrue();
        assertThat(total(tilted, 16, 16)).isCloseTo(Math.sqrt(2), within(1e-9));
        // A roof: two halves at 45°; its box' middle would see it from below at flat angles.
        TriangleMesh roof = mesh(
                new double[] {0, 0, 0, 1, 0.5, 0, 2, 0, 0, 0, 0, 1, 1, 0.5, 1, 2, 0, 1},
                0,
                4,
                1,
                0,
                3,
                4,
                1,
                5,
                2,
                1,
                4,
                5);
        assertThat(isPlanar(chart(roof, 16, 16))).isTrue();
        assertThat(total(roof, 16, 16)).isCloseTo(Math.sqrt(5), within(1e-9));
        assertThat(isPlanar(chart(new Box(v(0, 0, 0), v(9, 0.01, 9)), 16, 16))).isFalse();
    }

    @Test
    void of_givenTransformedFlatShapes_mapsThemFromAbove() {
        Transform transform =
                Transform.identity().scale(2, 1, 1).rotate(v(1, 1, 0), 30).translate(1, 2, 3);
        Transformed polygon =
                new Transformed(ConvexPolygon.twoSided(v(0, 0, 0), v(1, 0, 0), v(1, 0, -1), v(0, 0, -1)), transform);
        AmbientChart square = chart(polygon, 4, 4);
        for (int texel = 0; texel < 16; texel++) {
            assertThat(square.area(texel)).isCloseTo(2.0 / 16, within(1e-14));
        }
        Transformed disc = new Transformed(new Disc(v(0, 0, 0), v(0, 1, 0), 2), transform);
        assertThat(isPlanar(chart(disc, 64, 64))).isTrue();
        assertThat(total(disc, 64, 64)).isCloseTo(8 * Math.PI, within(1e-3 * 8 * Math.PI));
    }

    @Test
    void of_givenLengthsTimesAPowerOfTwo_multipliesAreasByItsSquareExactly() {
        double scale = 0x1p-30;
        AmbientChart large = chart(new Box(v(1, 2, 3), v(2, 4, 6)), 32, 16);
        AmbientChart small = chart(new Box(v(1, 2, 3).times(scale), v(2, 4, 6).times(scale)), 32, 16);
        for (int texel = 0; texel < large.grid().size(); texel++) {
            assertThat(small.area(texel)).isEqualTo(large.area(texel) * 0x1p-60);
        }
    }

    @Test
    void of_givenOddColumnsAround_takesOneMore() {
        assertThat(chart(new Sphere(Vector3.ZERO, 1), 141, 8).grid().columns()).isEqualTo(142);
    }

    @Test
    void of_givenEvenLightOnManyShapes_showsItAsTheSameEverywhere() {
        SplittableRandom random = new SplittableRandom(17);
        expectUniform(new Box(v(-1, -2, -1.5), v(1, 2, 1.5)), 52, () -> onBox(random, v(1, 2, 1.5)));
        expectUniform(
                new Torus(Vector3.ZERO, Vector3.UNIT_Z, 2, 0.5), 4 * Math.PI * Math.PI, () -> onTorus(random, 2, 0.5));
        expectUniform(ConvexPolygon.twoSided(v(0, 0, 0), v(4, 0, 0), v(0, 3, 0)), 6, () -> onTriangle(random, 4, 3));
        expectUniform(new Ellipsoid(Vector3.ZERO, v(3, 1, 1)), PROLATE, () -> onEllipsoid(random, 3));
    }

    /** Photons of one power: χ² of their numbers in n texels has the mean n − 1 and the deviation √(2n); 5 of these. */
    private static void expectUniform(Shape shape, double wholeArea, Supplier<Vector3> point) {
        int count = 60_000;
        PhotonStore store = new PhotonStore(Vector3.ZERO, 1, count);
        PhotonSlice slice = store.slice();
        AmbientChart chart = chart(shape, 24, 12);
        double[] photons = new double[chart.grid().size()];
        SurfacePoint at = new SurfacePoint();
        at.normalX = 1;
        SurfacePoint[] inTexel = new SurfacePoint[photons.length];
        for (int i = 0; i < count; i++) {
            Vector3 p = point.get();
            at = at(p);
            slice.add(at, new Rgb().set(1, 1, 1));
            inTexel[chart.grid().texel(p.x(), p.y(), p.z())] = at;
        }
        store.append(slice);
        AmbientOptions options = AmbientOptions.physical().withBlur(0).interpolating(false);
        AmbientMaps plain = AmbientMaps.of(store, List.of(chart), options, WORKERS);
        double expected = count / wholeArea;
        IlluminationMap.Lookup lookup = plain.lookup();
        Rgb out = new Rgb();
        Set<Double> seen = new HashSet<>();
        double chiSquared = 0;
        for (int texel = 0; texel < photons.length; texel++) {
            // Texels that are joined answer alike and have the same area: they count once.
            if (inTexel[texel] != null) {
                lookup.irradiance(inTexel[texel], out);
                double area = chart.area(texel);
                if (seen.add(out.green * 1e9 + area)) {
                    double relative = out.green / expected - 1;
                    chiSquared += relative * relative * expected * area;
                }
            }
        }
        assertThat(seen.size()).isGreaterThan(60);
        assertThat(chiSquared)
                .as("χ² of %s", shape)
                .isCloseTo(seen.size() - 1, within(5 * Math.sqrt(2.0 * seen.size())));
    }

    private static SurfacePoint at(Vector3 p) {
        SurfacePoint at = new SurfacePoint();
        at.x = p.x();
        at.y = p.y();
        at.z = p.z();
        at.normalX = 1;
        at.front = true;
        return at;
    }

    private static Vector3 onBox(SplittableRandom random, Vector3 half) {
        double xy = half.x() * half.y();
        double xz = half.x() * half.z();
        double yz = half.y() * half.z();
        double choice = random.nextDouble() * (xy + xz + yz);
        double side = random.nextBoolean() ? 1 : -1;
        double a = 2 * random.nextDouble() - 1;
        double b = 2 * random.nextDouble() - 1;
        if (choice < xy) {
            return v(a * half.x(), b * half.y(), side * half.z());
        }
        return choice < xy + xz
                ? v(a * half.x(), side * half.y(), b * half.z())
                : v(side * half.x(), a * half.y(), b * half.z());
    }

    private static Vector3 onTorus(SplittableRandom random, double major, double minor) {
        double tube = 2 * Math.PI * random.nextDouble();
        double distance = major + minor * Math.cos(tube);
        if (random.nextDouble() * (major + minor) > distance) {
            return onTorus(random, major, minor);
        }
        double turn = 2 * Math.PI * random.nextDouble();
        return v(distance * Math.cos(turn), distance * Math.sin(turn), minor * Math.sin(tube));
    }

    private static Vector3 onTriangle(SplittableRandom random, double width, double height) {
        double a = random.nextDouble();
        double b = random.nextDouble();
        return a + b > 1 ? v((1 - a) * width, (1 - b) * height, 0) : v(a * width, b * height, 0);
    }

    /** Of radii (long, 1, 1): a point of the unit sphere, taken as often as its surroundings are stretched. */
    private static Vector3 onEllipsoid(SplittableRandom random, double length) {
        double height = 2 * random.nextDouble() - 1;
        double turn = 2 * Math.PI * random.nextDouble();
        double aside = Math.sqrt(1 - height * height);
        double stretch = Math.sqrt(height * height + length * length * aside * aside);
        return random.nextDouble() * length > stretch
                ? onEllipsoid(random, length)
                : v(length * height, aside * Math.cos(turn), aside * Math.sin(turn));
    }

    @Test
    void initialHits_givenTheSheetOfTheThesis_layCellsAlongItsEdges() {
        double r = 3.5355;
        Material water = Material.builder().transparency(Color.grey(0.9)).build();
        SceneIndex scene = index(water, ConvexPolygon.twoSided(v(r, 4, 0), v(0, 4, r), v(-r, 4, 0), v(0, 4, -r)));
        InitialHits hits = new InitialHits(AmbientCharts.initialHits(scene, ChartSizing.equal(140, 141)), 1);
        int admitted = 0;
        for (int i = 0; i < 421 * 421; i++) {
            double x = -7.0711 + 14.1422 * (i / 421) / 421;
            double z = -7.0711 + 14.1422 * (i % 421) / 421;
            admitted += Math.abs(x) + Math.abs(z) <= r && hits.admit(0, x, 4, z) ? 1 : 0;
        }
        assertThat(admitted).isEqualTo(17_290);
    }

    @Test
    void initialHits_givenOpaqueObjects_giveThemNoCells() {
        assertThat(AmbientCharts.initialHits(matt(new Plane(Vector3.ZERO, Vector3.UNIT_Y)), ChartSizing.equal(4, 4)))
                .containsExactly((TexelGrid) null);
    }
}
