package org.diacaustic.map;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.diacaustic.math.Rgb;
import org.diacaustic.math.Vector3;
import org.diacaustic.parallel.Workers;
import org.junit.jupiter.api.Test;

class AmbientMapsTest {
    private static final Workers WORKERS = new Workers(2);
    private static final AmbientOptions PLAIN =
            AmbientOptions.physical().withBlur(0).interpolating(false);

    /** Four texels of 1 × 2 in a row along x. */
    private static final AmbientChart STRIP = flat(0, 4, 1, 4, 2);

    private final PhotonStore store = new PhotonStore(Vector3.ZERO, 1, 1 << 20);
    private final PhotonSlice slice = store.slice();
    private final Rgb out = new Rgb();

    /** A rectangle over x and z, its texels all alike. */
    private static AmbientChart flat(int object, int columns, int rows, double width, double depth) {
        Chart chart = Chart.planar(Vector3.ZERO, new Vector3(width, 0, 0), new Vector3(0, 0, depth));
        double[] areas = new double[columns * rows];
        Arrays.fill(areas, width * depth / areas.length);
        return new AmbientChart(object, new TexelGrid(chart, columns, rows), areas);
    }

    private static AmbientChart sphere(int object, double radius, int columns, int rows) {
        Chart chart = Chart.spherical(Vector3.ZERO, Vector3.UNIT_Y, Vector3.UNIT_X);
        double[] areas = new double[columns * rows];
        for (int i = 0; i < areas.length; i++) {
            int row = i / columns;
            areas[i] = radius * radius * chart.spread(1.0 / columns, (double) row / rows, (row + 1.0) / rows);
        }
        return new AmbientChart(object, new TexelGrid(chart, columns, rows), areas);
    }

    private static SurfacePoint at(int object, boolean front, double x, double y, double z) {
        SurfacePoint point = new SurfacePoint();
        point.x = x;
        point.y = y;
        point.z = z;
        point.normalY = 1;
        point.object = object;
        point.front = front;
        return point;
    }

    private void store(int object, boolean front, double x, double z, double power) {
        slice.add(at(object, front, x, 0, z), new Rgb().set(power, 2 * power, 3 * power));
    }

    private AmbientMaps maps(AmbientOptions options, AmbientChart... charts) {
        store.append(slice);
        return AmbientMaps.of(store, List.of(charts), options, WORKERS);
    }

    private double green(AmbientMaps maps, int object, boolean front, double x, double z) {
        maps.lookup().irradiance(at(object, front, x, 0, z), out);
        return out.green;
    }

    @Test
    void options_givenImpossibleNumbers_refuse() {
        for (int side : new int[] {-1, 2, 4}) {
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> PLAIN.withBlur(side))
                    .withMessageContaining("odd");
        }
        for (double count : new double[] {0, -1, Double.POSITIVE_INFINITY}) {
            assertThatIllegalArgumentException().isThrownBy(() -> PLAIN.withExpectedCount(count));
        }
    }

    @Test
    void of_givenTwoChartsOfAnObject_refuses() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> maps(PLAIN, STRIP, STRIP))
                .withMessageContaining("object 0");
    }

    @Test
    void of_givenNoPhotons_isDarkAndTakesNoRoomForTexels() {
        AmbientMaps maps = maps(PLAIN, STRIP);
        assertThat(green(maps, 0, true, 1, 1)).isZero();
        assertThat(maps.lit()).isEmpty();
        assertThat(maps.bytes()).isLessThan(64);
    }

    @Test
    void bytes_givenOneLitSide_countsItsTexelsOnly() {
        // 4 texels: 3 doubles and a count of the lit side, an area and a keeper.
        store(0, true, 1.5, 1, 4);
        assertThat(maps(PLAIN, STRIP).bytes()).isEqualTo(4 * (28 + 12));
        assertThat(AmbientMaps.BYTES_PER_TEXEL).isEqualTo(2 * 28 + 12);
    }

    @Test
    void irradiance_givenPhotons_isPowerOverArea() {
        // Texel 1 holds 3 + 5 W of red over an area of 2.
        store(0, true, 1.2, 0.5, 3);
        store(0, true, 1.9, 1.5, 5);
        AmbientMaps maps = maps(PLAIN, STRIP);
        maps.lookup().irradiance(at(0, true, 1.5, 0, 1), out);
        assertThat(List.of(out.red, out.green, out.blue)).containsExactly(4.0, 8.0, 12.0);
        assertThat(green(maps, 0, true, 2.1, 1)).isZero();
    }

    @Test
    void irradiance_givenPhotonsOnASliver_isThatOfTheJoinedTexel() {
        // Areas 1 and 0.1 join: 1.1 W over 1.1, and no flash of 11.
        TexelGrid grid = new TexelGrid(Chart.planar(Vector3.ZERO, Vector3.UNIT_X, Vector3.UNIT_Z), 2, 1);
        store(0, true, 0.9, 0.5, 1.1);
        AmbientMaps maps = maps(PLAIN, new AmbientChart(0, grid, new double[] {1, 0.1}));
        assertThat(green(maps, 0, true, 0.9, 0.5)).isCloseTo(2, within(1e-6));
        assertThat(green(maps, 0, true, 0.1, 0.5)).isCloseTo(2, within(1e-6));
    }

    @Test
    void irradiance_givenSeparateSides_doesNotShineThrough() {
        store(0, true, 1.5, 1, 4);
        AmbientMaps maps = maps(PLAIN, STRIP);
        assertThat(green(maps, 0, true, 1.5, 1)).isEqualTo(4);
        assertThat(green(maps, 0, false, 1.5, 1)).isZero();
        assertThat(maps.lit()).hasSize(1);
    }

    @Test
    void irradiance_givenSharedSides_isTheSumOfBoth() {
        store(0, true, 1.5, 1, 4);
        store(0, false, 1.5, 1, 1);
        AmbientMaps maps = maps(PLAIN.separatingSides(false), STRIP);
        assertThat(green(maps, 0, true, 1.5, 1)).isEqualTo(5);
        assertThat(green(maps, 0, false, 1.5, 1)).isEqualTo(5);
        assertThat(maps.lit()).hasSize(1);
    }

    @Test
    void irradiance_givenObjectsWithoutCharts_isZero() {
        store(0, true, 1.5, 1, 4);
        store(2, true, 1.5, 1, 8);
        store(7, true, 1.5, 1, 8);
        AmbientMaps maps = maps(PLAIN, STRIP, flat(2, 4, 1, 4, 2));
        assertThat(green(maps, 1, true, 1.5, 1)).isZero();
        assertThat(green(maps, 7, true, 1.5, 1)).isZero();
        assertThat(green(maps, 2, true, 1.5, 1)).isEqualTo(8);
    }

    @Test
    void irradiance_givenExpectedCount_isPowerOverThatNumber() {
        store(0, true, 1.5, 1, 4);
        store(0, true, 1.5, 1, 5);
        AmbientOptions thesis = AmbientOptions.thesis().withBlur(0);
        assertThat(green(maps(thesis.withExpectedCount(6), STRIP), 0, true, 1.5, 1))
                .isEqualTo(2 * 9 / 6.0);
    }

    @Test
    void irradiance_givenNoExpectedCount_takesTheMeanOfLitTexelsOfTheObject() {
        // 3 photons in the only lit texel of one object, 1 in that of another.
        store(0, true, 1.5, 1, 4);
        store(0, false, 1.5, 1, 4);
        store(0, true, 1.5, 1, 4);
        store(1, true, 0.5, 1, 4);
        AmbientMaps maps = maps(AmbientOptions.thesis().withBlur(0), STRIP, flat(1, 2, 2, 4, 4));
        assertThat(green(maps, 0, true, 1.5, 1)).isEqualTo(2 * 12 / 3.0);
        assertThat(green(maps, 1, true, 0.5, 1)).isEqualTo(2 * 4 / 1.0);
    }

    @Test
    void irradiance_givenInterpolation_runsStraightBetweenTheMiddles() {
        store(0, true, 1.5, 1, 4);
        AmbientMaps maps = maps(PLAIN.interpolating(true), STRIP);
        assertThat(green(maps, 0, true, 1.5, 1)).isEqualTo(4);
        assertThat(green(maps, 0, true, 2, 1)).isEqualTo(2);
        assertThat(green(maps, 0, true, 2.25, 0)).isEqualTo(1);
        assertThat(green(maps, 0, true, 2.5, 2)).isZero();
    }

    @Test
    void irradiance_givenInterpolationBeyondTheBorder_isThatOfTheBorder() {
        store(0, true, 0.5, 1, 4);
        AmbientMaps maps = maps(PLAIN.interpolating(true), STRIP);
        assertThat(green(maps, 0, true, 0.1, 0.1)).isEqualTo(4);
        assertThat(green(maps, 0, true, -3, 9)).isEqualTo(4);
    }

    @Test
    void irradiance_givenInterpolationAcrossSeamAndPole_isTheSameFromBothSides() {
        SplittableRandom random = new SplittableRandom(3);
        for (int i = 0; i < 500; i++) {
            Vector3 p = direction(random);
            slice.add(at(0, true, p.x(), p.y(), p.z()), new Rgb().set(1, random.nextDouble(), 1));
        }
        AmbientMaps maps = maps(PLAIN.interpolating(true), sphere(0, 1, 8, 6));
        IlluminationMap.Lookup lookup = maps.lookup();
        double near = 1e-9;
        for (int i = 0; i < 50; i++) {
            Vector3 p = direction(random);
            double across = Math.hypot(p.x(), p.y());
            lookup.irradiance(at(0, true, across, p.z(), near), out);
            double before = out.green;
            lookup.irradiance(at(0, true, across, p.z(), -near), out);
            assertThat(out.green).isCloseTo(before, within(1e-6 * (1 + before)));
            lookup.irradiance(at(0, true, near * p.x(), 1, near * p.z()), out);
            before = out.green;
            lookup.irradiance(at(0, true, -near * p.x(), 1, -near * p.z()), out);
            assertThat(out.green).isCloseTo(before, within(1e-6 * (1 + before)));
        }
    }

    private static Vector3 direction(SplittableRandom random) {
        double height = 2 * random.nextDouble() - 1;
        double turn = 2 * Math.PI * random.nextDouble();
        double aside = Math.sqrt(1 - height * height);
        return new Vector3(aside * Math.cos(turn), height, aside * Math.sin(turn));
    }

    @Test
    void irradiance_givenPhotonsEvenlyOverASphere_isTheSameEverywhere() {
        // N photons of 1/N W on 4πr² = 16π: 1/(16π) everywhere. χ² of n texels has the mean n − 1 and the deviation
        // √(2n);
        // 5 of them at a fixed seed.
        int count = 200_000;
        int columns = 32;
        int rows = 16;
        SplittableRandom random = new SplittableRandom(11);
        Vector3[] points = new Vector3[count];
        for (int i = 0; i < count; i++) {
            points[i] = direction(random).times(2);
            slice.add(at(0, true, points[i].x(), points[i].y(), points[i].z()), new Rgb().set(0x1p-17, 0x1p-17, 0));
        }
        AmbientChart chart = sphere(0, 2, columns, rows);
        AmbientMaps plain = maps(PLAIN, chart);
        double expected = count * 0x1p-17 / (16 * Math.PI);
        double chiSquared = 0;
        for (Vector3 p : middles(columns, rows)) {
            plain.lookup().irradiance(at(0, true, p.x(), p.y(), p.z()), out);
            double inTexel = count * chart.area(chart.grid().texel(p.x(), p.y(), p.z())) / (16 * Math.PI);
            double relative = out.green / expected - 1;
            chiSquared += relative * relative * inTexel;
        }
        assertThat(chiSquared).isCloseTo(columns * rows - 1, within(5 * Math.sqrt(2.0 * columns * rows)));
        AmbientMaps smooth = AmbientMaps.of(store, List.of(chart), AmbientOptions.physical(), WORKERS);
        for (int i = 0; i < 1000; i++) {
            smooth.lookup().irradiance(at(0, true, points[i].x(), points[i].y(), points[i].z()), out);
            assertThat(out.green / expected).isCloseTo(1, within(0.25));
        }
    }

    private static List<Vector3> middles(int columns, int rows) {
        List<Vector3> middles = new ArrayList<>();
        for (int row = 0; row < rows; row++) {
            for (int column = 0; column < columns; column++) {
                double south = Math.PI * (row + 0.5) / rows;
                double turn = 2 * Math.PI * (column + 0.5) / columns;
                middles.add(new Vector3(
                        Math.sin(south) * Math.cos(turn), -Math.cos(south), -Math.sin(south) * Math.sin(turn)));
            }
        }
        return middles;
    }

    private double[] storedAndMapped(AmbientOptions options) {
        SplittableRandom random = new SplittableRandom(5);
        for (int i = 0; i < 3000; i++) {
            Vector3 p = direction(random);
            slice.add(
                    at(0, random.nextBoolean(), p.x(), p.y(), p.z()),
                    new Rgb().set(0, Math.pow(random.nextDouble(), 8), 0));
            store(1, random.nextBoolean(), 4 * random.nextDouble(), 2 * random.nextDouble(), random.nextDouble());
        }
        AmbientMaps maps = maps(options, sphere(0, 1, 32, 64), flat(1, 17, 5, 4, 2));
        Rgb power = new Rgb();
        double stored = 0;
        for (int i = 0; i < store.size(); i++) {
            store.power(i, power);
            stored += power.green;
        }
        power.set(0, 0, 0);
        maps.lit().forEach(map -> map.addPower(power));
        return new double[] {stored, power.green};
    }

    @Test
    void of_givenAnyBlur_holdsThePowerThatWasStored() {
        for (int blur : new int[] {0, 3, 5}) {
            double[] power = storedAndMapped(AmbientOptions.physical().withBlur(blur));
            assertThat(power[1]).isCloseTo(power[0], within(1e-12 * power[0]));
        }
    }

    @Test
    void of_givenOtherThreads_hasTheSameBits() {
        SplittableRandom random = new SplittableRandom(9);
        for (int i = 0; i < 50_000; i++) {
            Vector3 p = direction(random);
            slice.add(at(0, true, p.x(), p.y(), p.z()), new Rgb().set(1, random.nextDouble(), 1));
        }
        AmbientChart chart = sphere(0, 1, 16, 8);
        AmbientMaps two = maps(AmbientOptions.physical(), chart);
        AmbientMaps one = AmbientMaps.of(store, List.of(chart), AmbientOptions.physical(), new Workers(1));
        for (Vector3 p : middles(16, 8)) {
            two.lookup().irradiance(at(0, true, p.x(), p.y(), p.z()), out);
            double green = out.green;
            one.lookup().irradiance(at(0, true, p.x(), p.y(), p.z()), out);
            assertThat(out.green).isEqualTo(green);
        }
    }

    @Test
    void lookup_givenQuestions_countsTexelsAndPhotons() {
        store(0, true, 1.5, 1, 4);
        store(0, true, 1.5, 1, 4);
        store(0, true, 2.5, 1, 4);
        AmbientMaps maps = maps(PLAIN, STRIP);
        IlluminationMap.Lookup nearest = maps.lookup();
        nearest.irradiance(at(0, true, 1.5, 0, 1), out);
        nearest.irradiance(at(0, true, 2.5, 0, 1), out);
        nearest.irradiance(at(0, false, 2.5, 0, 1), out);
        assertThat(nearest.nodesExamined()).isEqualTo(2);
        assertThat(nearest.photonsUsed()).isEqualTo(3);
        IlluminationMap.Lookup smooth = AmbientMaps.of(store, List.of(STRIP), PLAIN.interpolating(true), WORKERS)
                .lookup();
        smooth.irradiance(at(0, true, 1.9, 0, 0.9), out);
        assertThat(smooth.nodesExamined()).isEqualTo(4);
    }

    @Test
    void lookup_givenManyQuestions_allocatesNothing() {
        SplittableRandom random = new SplittableRandom(5);
        for (int i = 0; i < 1000; i++) {
            store(1, true, 4 * random.nextDouble(), 2 * random.nextDouble(), 1);
            slice.add(at(0, true, random.nextDouble(), 1, 0), new Rgb().set(1, 1, 1));
        }
        AmbientMaps maps = maps(AmbientOptions.physical(), sphere(0, 1, 16, 8), flat(1, 8, 8, 4, 2));
        IlluminationMap.Lookup lookup = maps.lookup();
        SurfacePoint point = at(0, true, 0, 0, 0);
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        ask(lookup, point);
        long before = threads.getCurrentThreadAllocatedBytes();
        ask(lookup, point);
        long allocated = threads.getCurrentThreadAllocatedBytes() - before;
        // What the measurement itself allocates is far less than one byte a question.
        assertThat(allocated).isLessThan(10_000);
    }

    private void ask(IlluminationMap.Lookup lookup, SurfacePoint point) {
        for (int i = 0; i < 20_000; i++) {
            point.object = i & 1;
            point.x = (i % 1013) / 1013.0 - 0.5;
            point.y = (i % 307) / 307.0 - 0.5;
            point.z = (i % 71) / 71.0;
            lookup.irradiance(point, out);
        }
    }
}
