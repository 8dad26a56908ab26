package org.diacaustic.map;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.diacaustic.map.TestCells.density;
import static org.diacaustic.map.TestCells.floor;
import static org.diacaustic.map.TestCells.powerIn;
import static org.diacaustic.map.TestCells.seenFrom;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.SplittableRandom;
import org.diacaustic.math.Rgb;
import org.diacaustic.math.Vector3;
import org.diacaustic.parallel.Workers;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class CausticMeshTest {
    private static final Vector3 EYE = new Vector3(0.3, -0.2, 2);
    private static final int RINGS = 30;
    private static final int SECTORS = 48;
    private static final double INFINITE = Double.POSITIVE_INFINITY;

    private final SplittableRandom random = new SplittableRandom(3);
    private final Rgb irradiance = new Rgb();

    @Test
    void irradiance_givenAFootprintThatIsNotClosed_throws() {
        FootprintLookup lookup = new TestCells().grid(2, 1).mesh().lookup();
        Footprint open = square(0, 0, 0.1);
        assertThatThrownBy(() -> lookup.irradiance(open, floor(0, 0), irradiance))
                .isInstanceOf(IllegalStateException.class);
        assertThat(open.close()).isTrue();
        open.reach(1);
        assertThatThrownBy(() -> lookup.irradiance(open, floor(0, 0), irradiance))
                .isInstanceOf(IllegalStateException.class);
    }

    @Test
    void irradiance_givenNoCells_isZero() {
        CausticMesh mesh = new TestCells().mesh(new Workers(2));
        assertThat(powerIn(mesh.lookup(), square(0, 0, 0.1))).isZero();
        assertThat(density(mesh, floor(0, 0))).isZero();
        assertThat(mesh.size()).isZero();
        assertThat(mesh.bytes()).isZero();
        assertThat(mesh.readsFootprints()).isTrue();
    }

    @Test
    void irradiance_givenAnEvenGrid_isPowerOverAreaForAnyFootprint() {
        CausticMesh mesh = new TestCells().grid(40, 1).mesh(new Workers(2));
        FootprintLookup lookup = mesh.lookup();
        for (int i = 0; i < 1000; i++) {
            double x = random.nextDouble(-0.8, 0.8);
            double y = random.nextDouble(-0.8, 0.8);
            double size = StrictMath.pow(10, random.nextDouble(-3, -0.7));
            Footprint quad = seenFrom(
                    EYE,
                    floor(x - size, y - 0.7 * size),
                    floor(x + 0.6 * size, y - size),
                    floor(x + size, y + 0.8 * size),
                    floor(x - 0.5 * size, y + size));
            assertThat(quad.close()).isTrue();
            lookup.irradiance(quad, floor(x, y), irradiance);
            // 1 W·m⁻², as its cells are kept: off by 6e-8 of a cell, which counts at the footprint's edges.
            assertThat(irradiance.red).isCloseTo(1, within(3e-7 + 3e-9 / size));
            assertThat(irradiance.green).isCloseTo(0.5, within(3e-7 + 3e-9 / size));
            assertThat(irradiance.blue).isZero();
        }
    }

    @Test
    void irradiance_givenOneCell_isTheCommonArea() {
        // The half square x + y ≤ 1 carries 8 W, so 16 W·m⁻²; the square of side 0.2 is within, then half, then out.
        CausticMesh mesh = new TestCells()
                .triangle(8, floor(0, 0), floor(1, 0), floor(0, 1))
                .mesh();
        FootprintLookup lookup = mesh.lookup();
        assertThat(powerIn(lookup, square(0.3, 0.3, 0.1))).isCloseTo(16 * 0.04, within(1e-6));
        assertThat(powerIn(lookup, square(0.5, 0.5, 0.1))).isCloseTo(8 * 0.04, within(1e-6));
        assertThat(powerIn(lookup, square(0.7, 0.7, 0.1))).isCloseTo(0, within(1e-9));
        assertThat(powerIn(lookup, square(0.3, 0.3, 0.9))).isEqualTo(8);
        assertThat(lookup.photonsUsed()).isBetween(3L, 4L);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.5, 0.05, 0.003})
    void irradiance_givenATiling_addsUpToAllPower(double size) {
        CausticMesh mesh = new TestCells().scattered(random, 3000, size).mesh();
        double power = totalPower(mesh);
        assertThat(sum(mesh, corners(37, 0.4), EYE, 0)).isCloseTo(power, within(1e-14 * power));
        // An eye near the ground, and one that looks along the axes.
        assertThat(sum(mesh, corners(37, 0.4), new Vector3(1.5, 0, 0.1), 0)).isCloseTo(power, within(1e-14 * power));
        assertThat(sum(mesh, corners(37, 0), new Vector3(0, 0, 1e9), INFINITE)).isCloseTo(power, within(1e-14 * power));
    }

    @Test
    void irradiance_givenPointsOnEdgesAndCorners_countsThemOnce() {
        // Every multiple of 1/32 is a corner, a point on an edge, or inside; edges are multiples of 1/8.
        TestCells cells = new TestCells();
        for (int row = -31; row < 32; row++) {
            for (int column = -31; column < 32; column++) {
                cells.point(1, floor(column / 32.0, row / 32.0));
            }
        }
        CausticMesh mesh = cells.mesh();
        Vector3[][] corners = corners(16, 0);
        assertThat(sum(mesh, corners, new Vector3(0, 0, 4), 0)).isEqualTo(63 * 63);
        assertThat(sum(mesh, corners, new Vector3(0.7, 3, 0.3), 0)).isEqualTo(63 * 63);
        FootprintLookup lookup = mesh.lookup();
        // Of the four edges of a square from (0,0) to (1/8,1/8), two are its own: 16 of its 25 points.
        assertThat(powerIn(lookup, square(1 / 16.0, 1 / 16.0, 1 / 16.0))).isEqualTo(16);
        assertThat(lookup.photonsUsed()).isEqualTo(16);
    }

    @Test
    void irradiance_givenCellsWithoutArea_isExact() {
        TestCells cells = new TestCells();
        for (double width = 1; width > 1e-30; width /= 10) {
            double x = random.nextDouble(-0.5, 0.5);
            double y = random.nextDouble(-0.5, 0.5);
            cells.triangle(1, floor(x, y), floor(x + 0.3, y - 0.2), floor(x + 0.1, y + 0.3 * width));
            cells.triangle(1, floor(x, y), floor(x + width, y), floor(x, y + width * 0.1));
        }
        for (int i = 0; i < 30; i++) {
            SurfacePoint a = floor(random.nextDouble(-0.9, 0.9), random.nextDouble(-0.9, 0.9));
            SurfacePoint b = floor(random.nextDouble(-0.9, 0.9), random.nextDouble(-0.9, 0.9));
            cells.triangle(1, a, a, b);
            cells.triangle(1, a, b, floor((a.x + b.x) / 2, (a.y + b.y) / 2));
            cells.triangle(1, a, a, a);
        }
        CausticMesh mesh = cells.mesh();
        double power = totalPower(mesh);
        Vector3[][] wide = corners(16, 0.4);
        for (Vector3[] row : wide) {
            for (int i = 0; i < row.length; i++) {
                row[i] = row[i].times(2);
            }
        }
        assertThat(sum(mesh, wide, EYE, 0)).isCloseTo(power, within(1e-13 * power));
        // Half of a line from (−0.5,0) to (0.5,0) is on either side of x = 0; as a triangle with the third vertex in
        // the middle, likewise.
        CausticMesh line = new TestCells()
                .triangle(1, floor(-0.5, 0.1), floor(0.5, 0.1), floor(0, 0.1))
                .mesh();
        assertThat(powerIn(line.lookup(), square(0.5, 0, 0.5))).isCloseTo(0.5, within(1e-7));
    }

    @Test
    void irradiance_givenAllCellsEqual_countsEach() {
        TestCells cells = new TestCells();
        for (int i = 0; i < 5000; i++) {
            cells.triangle(1, floor(0, 0), floor(0.25, 0), floor(0, 0.25));
            cells.point(1, floor(0.01, 0.01));
        }
        CausticMesh mesh = cells.mesh(new Workers(2));
        assertThat(powerIn(mesh.lookup(), square(0, 0, 0.5))).isEqualTo(10_000);
        assertThat(density(mesh, floor(0.1, 0.1))).isCloseTo(5000 * 32, within(0.1));
    }

    @Test
    void irradiance_givenRandomTriangles_isTheSumOfTheCommonAreas() {
        TestCells cells = new TestCells();
        double[][] triangles = new double[400][];
        for (int i = 0; i < triangles.length; i++) {
            double x = random.nextDouble(-1, 1);
            double y = random.nextDouble(-1, 1);
            double size = StrictMath.pow(10, random.nextDouble(-3, 0));
            double[] t = new double[6];
            for (int k = 0; k < 6; k++) {
                t[k] = (k % 2 == 0 ? x : y) + random.nextDouble(-size, size);
            }
            triangles[i] = t;
            cells.triangle(CommonArea.area(t), floor(t[0], t[1]), floor(t[2], t[3]), floor(t[4], t[5]));
        }
        FootprintLookup lookup = cells.mesh().lookup();
        for (int query = 0; query < 300; query++) {
            double x = random.nextDouble(-1, 1);
            double y = random.nextDouble(-1, 1);
            double size = StrictMath.pow(10, random.nextDouble(-2, 0));
            double[] q = {
                x - size, y - 0.6 * size, x + 0.7 * size, y - size, x + size, y + 0.8 * size, x - 0.4 * size, y + size
            };
            double expected = 0;
            for (double[] triangle : triangles) {
                expected += CommonArea.of(triangle, q);
            }
            Footprint quad = seenFrom(EYE, floor(q[0], q[1]), floor(q[2], q[3]), floor(q[4], q[5]), floor(q[6], q[7]));
            assertThat(powerIn(lookup, quad)).isCloseTo(expected, within(1e-6 * size));
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.2, INFINITE})
    void irradiance_givenASphereTiledByPixels_addsUpToWhatFacesTheEye(double reach) {
        // Cells on a sphere of radius 1, those of the half z < −0.2 with a power of 1000, the others with 1 each; the
        // eye at (0, 0, 4) sees as far down as z = 1/4.
        TestCells cells = new TestCells();
        int front = 0;
        int n = 60;
        for (int band = 0; band < n; band++) {
            double low = Math.PI * band / n;
            double high = Math.PI * (band + 1) / n;
            boolean seen = Math.cos(high) > 0.45;
            if (!seen && Math.cos(low) > -0.2) {
                continue;
            }
            for (int step = 0; step < n; step++) {
                double left = 2 * Math.PI * step / n;
                double right = 2 * Math.PI * (step + 1) / n;
                double p = seen ? 1 : 1000;
                cells.triangle(p, onSphere(low, left), onSphere(high, left), onSphere(high, right));
                cells.triangle(p, onSphere(low, left), onSphere(high, right), onSphere(low, right));
                cells.point(p, onSphere(0.3 * low + 0.7 * high, 0.4 * left + 0.6 * right));
                front += seen ? 3 : 0;
            }
        }
        FootprintLookup lookup = cells.mesh().lookup();
        Vector3 eye = new Vector3(0, 0, 4);
        double sum = 0;
        for (int ring = 0; ring < RINGS; ring++) {
            for (int sector = 0; sector < SECTORS; sector++) {
                Footprint pixel = seenFrom(
                        eye,
                        seen(ring, sector),
                        seen(ring, sector + 1),
                        seen(ring + 1, sector + 1),
                        seen(ring + 1, sector));
                pixel.reach(reach);
                sum += powerIn(lookup, pixel);
            }
        }
        assertThat(sum).isCloseTo(front, within(1e-12 * front));
    }

    @Test
    void irradiance_givenAnotherReceiverSideOrFacing_isZero() {
        SurfacePoint a = floor(-1, -1);
        SurfacePoint b = floor(1, -1);
        SurfacePoint c = floor(0, 1);
        CausticMesh mesh = new TestCells().triangle(1, a, b, c).mesh();
        Footprint same = square(0, 0, 0.1);
        assertThat(powerIn(mesh.lookup(), same)).isPositive();
        assertThat(density(mesh, floor(0, 0))).isPositive();
        for (int what = 0; what < 4; what++) {
            SurfacePoint other = floor(0, 0);
            switch (what) {
                case 0 -> other.object = 1;
                case 1 -> other.front = true;
                case 2 -> other.normalZ = -1;
                default -> {
                    // 70° from the light's.
                    other.normalX = Math.sin(Math.toRadians(70));
                    other.normalZ = Math.cos(Math.toRadians(70));
                }
            }
            Footprint footprint = square(0, 0, 0.1, other);
            assertThat(powerIn(mesh.lookup(), footprint)).as("case %d", what).isZero();
            assertThat(density(mesh, other)).as("case %d", what).isZero();
        }
        // From below, the eye sees the other side whatever the normal is said to be.
        Footprint fromBelow =
                seenFrom(new Vector3(0, 0, -2), floor(-0.1, -0.1), floor(0.1, -0.1), floor(0.1, 0.1), floor(-0.1, 0.1));
        assertThat(powerIn(mesh.lookup(), fromBelow)).isZero();
    }

    @Test
    void irradiance_givenTwoStoreys_reachesAsFarAsItIsTold() {
        TestCells cells = new TestCells();
        for (int storey = 0; storey < 2; storey++) {
            SurfacePoint[] corners = {floor(-1, -1), floor(1, -1), floor(0, 1)};
            for (SurfacePoint corner : corners) {
                corner.z = -storey;
            }
            cells.triangle(storey == 0 ? 1 : 8, corners[0], corners[1], corners[2]);
        }
        FootprintLookup lookup = cells.mesh().lookup();
        Vector3 above = new Vector3(0, 0, 1e6);
        double upper = 0.04 / 2;
        double lower = 8 * upper;
        double[] reaches = {0, 0.9, 1.1, INFINITE};
        double[] expected = {upper, upper, upper + lower, upper + lower};
        for (int i = 0; i < reaches.length; i++) {
            Footprint square = seenFrom(above, floor(-0.1, -0.1), floor(0.1, -0.1), floor(0.1, 0.1), floor(-0.1, 0.1));
            square.reach(reaches[i]);
            assertThat(powerIn(lookup, square)).isCloseTo(expected[i], within(1e-6));
        }
        assertThat(lookup.photonsUsed()).isEqualTo(6);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 1e9, -3e8})
    void irradiance_givenASmallSceneFarAway_isAsExactAsItsPlaces(double far) {
        // Doubles near 1e9 are 1.2e-7 apart, 0.4 % of a cell of 0.03 mm; the square is 1 mm wide.
        TestCells cells = new TestCells(new Vector3(far, far, 0));
        double half = 0.5e-3;
        int n = 33;
        double step = 2 * half / n;
        for (int row = 0; row < n; row++) {
            for (int column = 0; column < n; column++) {
                SurfacePoint a = floor(far + column * step - half, far + row * step - half);
                SurfacePoint b = floor(far + (column + 1) * step - half, far + row * step - half);
                SurfacePoint c = floor(far + (column + 1) * step - half, far + (row + 1) * step - half);
                SurfacePoint d = floor(far + column * step - half, far + (row + 1) * step - half);
                cells.triangle(step * step / 2, a, b, c);
                cells.triangle(step * step / 2, a, c, d);
            }
        }
        FootprintLookup lookup = cells.mesh().lookup();
        Vector3 eye = new Vector3(far, far, 2e-3);
        double h = 0.3e-3;
        Footprint square = seenFrom(
                eye,
                floor(far - h, far - h),
                floor(far + h, far - h),
                floor(far + h, far + h),
                floor(far - h, far + h));
        double power = powerIn(lookup, square);
        assertThat(power / square.area()).isCloseTo(1, within(far == 0 ? 1e-7 : 1e-3));
    }

    @Test
    void irradiance_givenAnotherScaleOfTwo_isTheSameToTheBit() {
        double[] found = new double[3];
        double[] scales = {1, 0x1p-20, 0x1p30};
        for (int s = 0; s < 3; s++) {
            SplittableRandom same = new SplittableRandom(5);
            TestCells cells = new TestCells();
            for (int i = 0; i < 500; i++) {
                SurfacePoint[] t = new SurfacePoint[3];
                for (int k = 0; k < 3; k++) {
                    t[k] = floor(scales[s] * same.nextDouble(-1, 1), scales[s] * same.nextDouble(-1, 1));
                }
                cells.triangle(1, t[0], t[1], t[2]);
            }
            double h = 0.1 * scales[s];
            Footprint square = seenFrom(EYE.times(scales[s]), floor(-h, -h), floor(h, -h), floor(h, h), floor(-h, h));
            found[s] = powerIn(cells.mesh().lookup(), square);
        }
        assertThat(found[0]).isPositive();
        assertThat(found[1]).isEqualTo(found[0]);
        assertThat(found[2]).isEqualTo(found[0]);
    }

    @Test
    void movedFrom_givenAnyNumberOfThreads_givesTheSameMeshAndAnEmptyStore() {
        CellStore once =
                new TestCells().scattered(new SplittableRandom(8), 40_000, 0.02).store();
        CellStore again =
                new TestCells().scattered(new SplittableRandom(8), 40_000, 0.02).store();
        CausticMesh first = CausticMesh.movedFrom(once, new Workers(1));
        CausticMesh second = CausticMesh.movedFrom(again, new Workers(3));
        assertThat(once.size()).isZero();
        assertThat(once.bytes()).isZero();
        assertThat(second.numbers).isEqualTo(first.numbers);
        assertThat(second.tags).isEqualTo(first.tags);
        assertThat(first.size()).isEqualTo(40_000);
        assertThat(first.bytes()).isLessThan(72L * first.size());
    }

    @Test
    void irradiance_givenCellsFarLargerThanTheFootprint_isEven() {
        // A slanted plane through a point near the origin, lit by 1 W·m⁻² in a fan of 12 cells that reach 10^5 units
        // far.
        Vector3 normal = new Vector3(1, 2, 3).normalized();
        Vector3 u = normal.perpendicular();
        Vector3 v = normal.cross(u);
        Vector3 hub = new Vector3(0.3, 0.1, 0.2);
        TestCells cells = new TestCells();
        for (int i = 0; i < 12; i++) {
            SurfacePoint a = slanted(hub.plus(onCircle(u, v, i).times(1e5)), normal);
            SurfacePoint b = slanted(hub.plus(onCircle(u, v, i + 1).times(1e5)), normal);
            cells.triangle(1e10 * StrictMath.sin(Math.PI / 6) / 2, slanted(hub, normal), a, b);
        }
        CausticMesh mesh = cells.mesh();
        FootprintLookup lookup = mesh.lookup();
        Vector3 eye = hub.plus(normal.times(2)).plus(u);
        for (int i = 0; i < 200; i++) {
            // In the middle of a cell, away from its edges.
            double angle = (random.nextInt(12) + random.nextDouble(0.3, 0.7)) * Math.PI / 6;
            Vector3 way = u.times(StrictMath.cos(angle)).plus(v.times(StrictMath.sin(angle)));
            Vector3 at = hub.plus(way.times(random.nextDouble(0.5, 1)));
            double size = 0.01;
            Footprint square = seenFrom(
                    eye,
                    slanted(at, normal),
                    slanted(at.plus(u.times(size)), normal),
                    slanted(at.plus(u.times(size)).plus(v.times(size)), normal),
                    slanted(at.plus(v.times(size)), normal));
            // Vertices are off by up to 2^-25 of 2·10^5 units, or 0.006, where the eye is 2 units above; edges as much.
            assertThat(powerIn(lookup, square) / square.area()).isCloseTo(1, within(0.02));
            assertThat(density(mesh, slanted(at, normal))).isCloseTo(1, within(1e-6));
        }
    }

    private static Vector3 onCircle(Vector3 u, Vector3 v, int twelfth) {
        double angle = twelfth * Math.PI / 6;
        return u.times(StrictMath.cos(angle)).plus(v.times(StrictMath.sin(angle)));
    }

    private static SurfacePoint slanted(Vector3 at, Vector3 normal) {
        return TestPhotons.point(at.x(), at.y(), at.z(), normal.x(), normal.y(), normal.z());
    }

    @Test
    void irradiance_givenCellsFarSmallerThanTheScene_isExactToAMillionth() {
        // A pixel of 1/2000 of the scene, cells of 1/50 of a pixel; at the far end of a scene 2 units wide.
        double pixel = 1e-3;
        double half = 0.75 * pixel;
        int n = 75;
        double step = 2 * half / n;
        double x0 = 0.93;
        double y0 = -0.97;
        TestCells cells = new TestCells();
        cells.triangle(1, floor(-1, -1), floor(-0.9, -1), floor(-1, -0.9));
        for (int row = 0; row < n; row++) {
            for (int column = 0; column < n; column++) {
                SurfacePoint a = floor(x0 + column * step - half, y0 + row * step - half);
                SurfacePoint b = floor(x0 + (column + 1) * step - half, y0 + row * step - half);
                SurfacePoint c = floor(x0 + (column + 1) * step - half, y0 + (row + 1) * step - half);
                SurfacePoint d = floor(x0 + column * step - half, y0 + (row + 1) * step - half);
                cells.triangle(step * step / 2, a, b, c);
                cells.triangle(step * step / 2, a, c, d);
            }
        }
        CausticMesh mesh = cells.mesh();
        FootprintLookup lookup = mesh.lookup();
        for (int i = 0; i < 50; i++) {
            double x = x0 + random.nextDouble(-0.2, 0.2) * pixel;
            double y = y0 + random.nextDouble(-0.2, 0.2) * pixel;
            Footprint square = square(x, y, pixel / 2);
            double power = powerIn(lookup, square);
            assertThat(power / square.area()).isCloseTo(1, within(1e-7));
        }
    }

    @Test
    void lookup_givenASmallFootprint_looksAtFewNodes() {
        FootprintLookup lookup = new TestCells().grid(200, 1).mesh().lookup();
        int queries = 0;
        for (double x = -0.9; x < 0.9; x += 0.03) {
            powerIn(lookup, square(x, 0.7 * x, 0.005));
            queries++;
        }
        // A footprint as large as a square of the grid lies in 4 squares, or 8 triangles, and less if it is just over
        // one.
        assertThat(lookup.photonsUsed()).isBetween(4L * queries, 9L * queries);
        assertThat(lookup.nodesExamined()).isLessThan(60L * queries);
    }

    @Test
    void irradiance_givenManyLookups_allocatesNothing() {
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        FootprintLookup lookup =
                new TestCells().scattered(random, 20_000, 0.02).mesh().lookup();
        Footprint footprint = new Footprint();
        SurfacePoint at = floor(0, 0);
        long least = Long.MAX_VALUE;
        for (int pass = 0; pass < 10; pass++) {
            long before = threads.getCurrentThreadAllocatedBytes();
            for (int i = 0; i < 2000; i++) {
                double x = -0.9 + 0.0009 * i;
                footprint.begin(at);
                footprint.addCorner(x, 0, 0, 0.6, 0, -0.8);
                footprint.addCorner(x + 0.02, 0, 0, 0.6, 0, -0.8);
                footprint.addCorner(x + 0.02, 0.02, 0, 0.6, 0, -0.8);
                footprint.addCorner(x, 0.02, 0, 0.6, 0, -0.8);
                footprint.close();
                lookup.irradiance(footprint, at, irradiance);
                at.x = x;
                lookup.irradiance(at, irradiance);
            }
            least = Math.min(least, threads.getCurrentThreadAllocatedBytes() - before);
        }
        assertThat(least).isZero();
    }

    @Test
    void irradiance_ofAPhotonMapGivenAFootprint_isThatAtThePoint() {
        PhotonMap photons = PhotonMap.over(
                new TestPhotons().add(floor(0, 0), 8).tree(),
                new Estimator.Density(0.5, Kernel.CONSTANT),
                PhotonFilter.NONE);
        assertThat(photons.readsFootprints()).isFalse();
        photons.lookup().irradiance(square(0, 0, 1), floor(0.1, 0), irradiance);
        assertThat(irradiance.red).isCloseTo(8 / (Math.PI * 0.25), within(1e-12));
    }

    /** The sum over all quads between neighbouring corners. */
    private double sum(CausticMesh mesh, Vector3[][] corners, Vector3 eye, double reach) {
        FootprintLookup lookup = mesh.lookup();
        double sum = 0;
        for (int row = 1; row < corners.length; row++) {
            for (int column = 1; column < corners.length; column++) {
                Footprint quad = seenFrom(
                        eye,
                        floor(corners[row - 1][column - 1]),
                        floor(corners[row - 1][column]),
                        floor(corners[row][column]),
                        floor(corners[row][column - 1]));
                quad.reach(reach);
                sum += powerIn(lookup, quad);
            }
        }
        return sum;
    }

    /** Corners of quads that tile |x| and |y| ≤ 1 on z = 0, moved by a part of a step. */
    private Vector3[][] corners(int quads, double jitter) {
        Vector3[][] corners = new Vector3[quads + 1][quads + 1];
        double step = 2.0 / quads;
        for (int row = 0; row <= quads; row++) {
            for (int column = 0; column <= quads; column++) {
                boolean inside = row > 0 && column > 0 && row < quads && column < quads;
                double byX = inside && jitter > 0 ? random.nextDouble(-jitter / 2, jitter / 2) : 0;
                double byY = inside && jitter > 0 ? random.nextDouble(-jitter / 2, jitter / 2) : 0;
                corners[row][column] = new Vector3((column + byX) * step - 1, (row + byY) * step - 1, 0);
            }
        }
        return corners;
    }

    private static double totalPower(CausticMesh mesh) {
        double sum = 0;
        for (int i = 0; i < mesh.size(); i++) {
            sum += mesh.numbers[CausticMesh.NUMBERS * i + CausticMesh.POWER];
        }
        return sum;
    }

    private static Footprint square(double x, double y, double half) {
        return square(x, y, half, floor(x, y));
    }

    private static Footprint square(double x, double y, double half, SurfacePoint at) {
        Footprint square = new Footprint();
        square.begin(at);
        for (int i = 0; i < 4; i++) {
            double cx = x + (i == 0 || i == 3 ? -half : half);
            double cy = y + (i < 2 ? -half : half);
            Vector3 direction = new Vector3(cx, cy, 0).minus(EYE).normalized();
            square.addCorner(cx, cy, 0, direction.x(), direction.y(), direction.z());
        }
        return square;
    }

    private static SurfacePoint onSphere(double polar, double azimuth) {
        double x = Math.sin(polar) * Math.cos(azimuth);
        double y = Math.sin(polar) * Math.sin(azimuth);
        double z = Math.cos(polar);
        return TestPhotons.point(x, y, z, x, y, z);
    }

    /** A corner of the rings of pixels through which the eye at (0, 0, 4) sees the unit sphere, nearly to its rim. */
    private static SurfacePoint seen(int ring, int sector) {
        // The rim is at tan(asin(1/4)) = 0.2582.
        double radius = 0.2581 * ring / RINGS;
        double angle = 2 * Math.PI * (sector % SECTORS) / SECTORS;
        double x = radius * Math.cos(angle);
        double y = radius * Math.sin(angle);
        double length = Math.sqrt(x * x + y * y + 1);
        double middle = 4 / length;
        double distance = middle - Math.sqrt(middle * middle - 15);
        double px = distance * x / length;
        double py = distance * y / length;
        double pz = 4 - distance / length;
        return TestPhotons.point(px, py, pz, px, py, pz);
    }
}
