package org.diacaustic.map;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.diacaustic.map.TestPhotons.floorPoint;
import static org.diacaustic.map.TestPhotons.point;
import static org.diacaustic.map.TestPhotons.red;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.SplittableRandom;
import org.diacaustic.map.TestPhotons.Mean;
import org.diacaustic.math.Rgb;
import org.diacaustic.parallel.Workers;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

class PhotonMapTest {
    private static final PhotonFilter NORMAL = PhotonFilter.TWO_SIDED_NORMAL;
    private static final double INFINITE = Double.POSITIVE_INFINITY;

    /** Statistical tests are off by more in 1 of 16,000 seeds; the seeds are fixed. */
    private static final double SIGMAS = 4;

    private final SplittableRandom random = new SplittableRandom(11);

    @Test
    void irradiance_givenNoPhotons_isZero() {
        PhotonTree tree = new TestPhotons().tree();
        assertThat(red(PhotonMap.over(tree, density(0.1), NORMAL), floorPoint(0, 0, true)))
                .isZero();
        assertThat(red(PhotonMap.over(tree, nearest(50, 0.1), NORMAL), floorPoint(0, 0, true)))
                .isZero();
        assertThat(red(PhotonMap.over(tree, nearest(50, INFINITE), NORMAL), floorPoint(0, 0, true)))
                .isZero();
        assertThat(tree.bytes()).isZero();
    }

    @Test
    void irradiance_givenWhatIsNotFinite_isNotANumber() {
        PhotonTree tree = new TestPhotons().floor(random, 1000, 1, true).tree();
        for (Estimator estimator : new Estimator[] {density(0.1), nearest(5, INFINITE)}) {
            PhotonMap map = PhotonMap.over(tree, estimator, NORMAL);
            assertThat(red(map, floorPoint(Double.NaN, 0, true))).isNaN();
            assertThat(red(map, floorPoint(0, INFINITE, true))).isNaN();
            assertThat(red(map, point(0, 0, 0, 0, 0, Double.NaN))).isNaN();
        }
    }

    @ParameterizedTest
    @EnumSource(Kernel.class)
    void irradiance_givenAPointBeyondAllSquares_isZero(Kernel kernel) {
        PhotonTree tree = new TestPhotons().floor(random, 1000, 1, true).tree();
        PhotonMap map = PhotonMap.over(tree, new Estimator.Nearest(50, INFINITE, kernel), NORMAL);
        for (double far : new double[] {1e18, 1e20, 1e38, 1e300}) {
            assertThat(red(map, floorPoint(far, 0, true))).isBetween(0.0, 1e-30);
        }
    }

    @Test
    void irradiance_givenOnePhoton_isItsPowerOverTheDisc() {
        // Kernels at half the radius: 1, 3(1 − 1/2), 2(1 − 1/4), 1.7283(1 − (1 − exp(−1.953/8))/(1 − exp(−1.953))).
        double area = Math.PI * 0.25;
        double[] weights = {1, 1.5, 1.5, 1.292058449493454};
        for (Kernel kernel : Kernel.values()) {
            PhotonTree tree =
                    new TestPhotons().add(floorPoint(0.25, 0, true), 8).tree();
            double expected = 8 * weights[kernel.ordinal()] / area;
            PhotonMap fixed = PhotonMap.over(tree, new Estimator.Density(0.5, kernel), NORMAL);
            PhotonMap fewerThanK = PhotonMap.over(tree, new Estimator.Nearest(2, 0.5, kernel), NORMAL);
            assertThat(red(fixed, floorPoint(0, 0, true))).isCloseTo(expected, within(1e-12));
            assertThat(red(fewerThanK, floorPoint(0, 0, true))).isCloseTo(expected, within(1e-12));
        }
    }

    @Test
    void irradiance_givenAPhotonAtExactlyTheRadius_countsIt() {
        PhotonTree tree = new TestPhotons().add(floorPoint(0.5, 0, true), 1).tree();
        PhotonMap map = PhotonMap.over(tree, new Estimator.ExpectedCount(0.5, 4), NORMAL);
        assertThat(red(map, floorPoint(0, 0, true))).isEqualTo(0.25);
        assertThat(red(map, floorPoint(-0x1p-20, 0, true))).isZero();
    }

    @Test
    void irradiance_givenNearest_leavesTheFarthestOut() {
        TestPhotons photons = new TestPhotons();
        for (int i = 1; i <= 100; i++) {
            photons.add(floorPoint(i / 128.0, 0, true), i);
        }
        // The three nearest have 1 + 2 + 3 W, the fourth is at 4/128.
        PhotonMap map = PhotonMap.over(photons.tree(), nearest(4, INFINITE), NORMAL);
        assertThat(red(map, floorPoint(0, 0, true))).isCloseTo(6 / (Math.PI * 0x1p-10), within(1e-9));
    }

    @Test
    void irradiance_givenPhotonsOnOneSpot_isFinite() {
        TestPhotons photons = new TestPhotons();
        for (int i = 0; i < 1000; i++) {
            photons.add(floorPoint(0.5, 0.25, true), 1);
        }
        double irradiance =
                red(PhotonMap.over(photons.tree(), nearest(50, INFINITE), NORMAL), floorPoint(0.5, 0.25, true));
        assertThat(irradiance).isPositive().isFinite();
    }

    @ParameterizedTest
    @CsvSource({"2, 1", "50, 0.14433756729740643"})
    void irradiance_givenNearestOnAnEvenFloor_isUnbiased(int count, double relativeDeviation) {
        // r_k² is Gamma(k), so E[(k − 1)/(π r_k²)] = 1 with a relative standard deviation of 1/√(k − 2), infinite for k
        // = 2. With
        // k = 2 the mean of the inverse is compared: E[π r_2² λ] = 2.
        int maps = 400;
        double[] estimates = new double[maps];
        for (int i = 0; i < maps; i++) {
            PhotonTree tree = new TestPhotons().floor(random, 4000, 1, true).tree();
            double found = red(PhotonMap.over(tree, nearest(count, INFINITE), NORMAL), floorPoint(0, 0, true));
            estimates[i] = count == 2 ? 1 / found : found;
        }
        Mean mean = Mean.of(estimates);
        double expected = count == 2 ? 2 : 1;
        assertThat(mean.value()).isCloseTo(expected, within(SIGMAS * mean.error()));
        if (count > 2) {
            assertThat(mean.error() * Math.sqrt(maps)).isCloseTo(relativeDeviation, within(0.15 * relativeDeviation));
        }
    }

    @ParameterizedTest
    @EnumSource(Kernel.class)
    void irradiance_givenAnyKernelOnAnEvenFloor_isOne(Kernel kernel) {
        PhotonTree tree = new TestPhotons().floor(random, 400_000, 1, true).tree();
        PhotonMap map = PhotonMap.over(tree, new Estimator.Density(0.05, kernel), NORMAL);
        double[] estimates = new double[200];
        for (int i = 0; i < estimates.length; i++) {
            estimates[i] = red(map, floorPoint(-0.9 + 0.12 * (i % 16), -0.9 + 0.12 * (i / 16), true));
        }
        Mean mean = Mean.of(estimates);
        assertThat(mean.value()).isCloseTo(1, within(SIGMAS * mean.error()));
    }

    @ParameterizedTest
    @EnumSource(Kernel.class)
    void weight_givenAnyKernel_hasMeanOneOverTheDisc(Kernel kernel) {
        // The mean over the disc is the integral of weight(s) over s = d²/r² from 0 to 1; midpoints, s = t².
        int steps = 100_000;
        double sum = 0;
        for (int i = 0; i < steps; i++) {
            double t = (i + 0.5) / steps;
            sum += kernel.weight(t * t) * 2 * t / steps;
        }
        assertThat(sum).isCloseTo(1, within(1e-9));
    }

    @ParameterizedTest
    @CsvSource({"0, 0.5", "0.5, 0.8044988905221147"})
    void irradiance_givenAnEdgeWithinTheRadius_isTooSmallByWhatIsBeyondIt(double inside, double ratio) {
        // The part of the disc of radius r that is on the floor, d·r inside its edge.
        double radius = 0.2;
        double[] estimates = new double[200];
        for (int i = 0; i < estimates.length; i++) {
            PhotonTree tree = new TestPhotons().floor(random, 5000, 1, true).tree();
            estimates[i] = red(PhotonMap.over(tree, density(radius), NORMAL), floorPoint(1 - inside * radius, 0, true));
        }
        Mean mean = Mean.of(estimates);
        assertThat(mean.value()).isCloseTo(ratio, within(SIGMAS * mean.error()));
    }

    @ParameterizedTest
    @CsvSource({"TWO_SIDED_NORMAL, 0.6880811676094636", "NONE, 1.1430811676094636"})
    void irradiance_givenACorner_isThatOfOneWallOnlyIfFiltered(PhotonFilter filter, double ratio) {
        // Two walls of irradiance 1 meet in the line x = −1, z = 0; asked 0.3 r from it. The ball cuts a half disc of
        // radius √(1 − 0.3²) r from the other wall, half its area more: 0.688081 + 0.455.
        double radius = 0.2;
        double[] estimates = new double[300];
        for (int i = 0; i < estimates.length; i++) {
            TestPhotons photons = new TestPhotons().floor(random, 5000, 1, true);
            for (int j = 0; j < 2500; j++) {
                photons.add(point(-1, random.nextDouble(-1, 1), random.nextDouble(), 1, 0, 0), 2.0 / 2500);
            }
            PhotonMap map = PhotonMap.over(photons.tree(), density(radius), filter);
            estimates[i] = red(map, floorPoint(-1 + 0.3 * radius, 0, true));
        }
        Mean mean = Mean.of(estimates);
        assertThat(mean.value()).isCloseTo(ratio, within(SIGMAS * mean.error()));
        assertThat(mean.error()).isLessThan(0.01);
    }

    @Test
    void irradiance_givenAThinSheetLitOnOneSide_isDarkOnTheOther() {
        TestPhotons photons = new TestPhotons().floor(random, 20_000, 1, true);
        PhotonTree tree = photons.tree();
        for (Estimator estimator : new Estimator[] {density(0.2), nearest(50, INFINITE), nearest(50, 0.3)}) {
            PhotonMap filtered = PhotonMap.over(tree, estimator, NORMAL);
            PhotonMap unfiltered = PhotonMap.over(tree, estimator, PhotonFilter.NONE);
            double lit = red(filtered, floorPoint(0, 0, true));
            assertThat(red(filtered, floorPoint(0, 0, false))).isZero();
            assertThat(red(unfiltered, floorPoint(0, 0, false))).isEqualTo(lit).isCloseTo(1, within(0.7));
        }
    }

    @Test
    void irradiance_givenNearestOnASheetLitOnBothSides_isNotShrunkByRejectedPhotons() {
        // Below there are 100 times as many photons; they take none of the places.
        SplittableRandom above = new SplittableRandom(5);
        double alone = red(
                PhotonMap.over(new TestPhotons().floor(above, 2000, 1, true).tree(), nearest(50, INFINITE), NORMAL),
                floorPoint(0.1, 0.2, true));
        TestPhotons both = new TestPhotons().floor(new SplittableRandom(5), 2000, 1, true);
        PhotonMap map = PhotonMap.over(both.floor(random, 200_000, 1, false).tree(), nearest(50, INFINITE), NORMAL);
        assertThat(red(map, floorPoint(0.1, 0.2, true))).isCloseTo(alone, within(1e-12 * alone));
    }

    @Test
    void irradiance_givenASphere_isExactHoweverCurved() {
        // The cap within a chord r has area πr², so the estimate is unbiased, and no normal within r = R/2 is refused.
        int count = 200_000;
        TestPhotons photons = new TestPhotons();
        double[][] asked = new double[400][];
        for (int i = 0; i < count; i++) {
            double[] n = direction();
            photons.add(point(n[0], n[1], n[2], n[0], n[1], n[2]), 4 * Math.PI / count);
            if (i < asked.length) {
                asked[i] = direction();
            }
        }
        PhotonTree tree = photons.tree();
        PhotonMap filtered = PhotonMap.over(tree, density(0.5), NORMAL);
        PhotonMap unfiltered = PhotonMap.over(tree, density(0.5), PhotonFilter.NONE);
        double[] estimates = new double[asked.length];
        for (int i = 0; i < asked.length; i++) {
            double[] n = asked[i];
            SurfacePoint at = point(n[0], n[1], n[2], n[0], n[1], n[2]);
            estimates[i] = red(filtered, at);
            assertThat(estimates[i]).isEqualTo(red(unfiltered, at));
        }
        // One map's estimates overlap: a single one has a relative deviation of 1/√12500.
        assertThat(Mean.of(estimates).value()).isCloseTo(1, within(SIGMAS / Math.sqrt(12_500)));
    }

    @Test
    void irradiance_givenALightAboveTheFloor_isTheMeanOverTheDisc() {
        // Unit flux from a height of 1: within r land Φ/2 (1 − 1/√(1 + r²)), the point below has Φ/4π: 0.84458 for r =
        // 1/2.
        int count = 200_000;
        TestPhotons photons = new TestPhotons();
        for (int i = 0; i < count; i++) {
            double[] n = direction();
            if (n[2] < -0.2) {
                photons.add(floorPoint(n[0] / -n[2], n[1] / -n[2], true), 4 * Math.PI / count);
            }
        }
        PhotonTree tree = photons.tree();
        // The share of photons that land in the disc is p, its relative deviation √((1 − p)/(p n)).
        double share = (1 - 1 / Math.sqrt(1.25)) / 2;
        double deviation = Math.sqrt((1 - share) / (share * count));
        assertThat(red(PhotonMap.over(tree, density(0.5), NORMAL), floorPoint(0, 0, true)))
                .isCloseTo(0.8445824720006730, within(SIGMAS * deviation));
    }

    @Test
    void irradiance_givenAnyScale_isItsInverseSquare() {
        double[] found = new double[3];
        for (int i = 0; i < 3; i++) {
            double scale = new double[] {1, 0x1p-100, 0x1p90}[i];
            SplittableRandom same = new SplittableRandom(8);
            TestPhotons photons = new TestPhotons();
            for (int j = 0; j < 5000; j++) {
                photons.add(floorPoint(scale * same.nextDouble(-1, 1), scale * same.nextDouble(-1, 1), true), 1);
            }
            PhotonTree tree = photons.tree();
            SurfacePoint at = floorPoint(0.1 * scale, 0.2 * scale, true);
            found[i] = scale * scale * red(PhotonMap.over(tree, nearest(50, INFINITE), NORMAL), at);
            assertThat(found[i]).isEqualTo(found[0]);
            double fixed = scale * scale * red(PhotonMap.over(tree, density(0.1 * scale), NORMAL), at);
            assertThat(fixed).isCloseTo(found[0], within(0.5 * found[0]));
        }
    }

    @Test
    void over_givenAnyNumberOfThreads_findsTheSameBits() {
        double[] found = new double[3];
        for (int i = 0; i < 3; i++) {
            PhotonTree tree = new TestPhotons()
                    .floor(new SplittableRandom(6), 200_000, 1, true)
                    .tree(new Workers(1 + 3 * i));
            found[i] = red(PhotonMap.over(tree, nearest(500, INFINITE), NORMAL), floorPoint(0.1, 0.2, true));
        }
        assertThat(found[1]).isEqualTo(found[0]);
        assertThat(found[2]).isEqualTo(found[0]);
    }

    @Test
    void over_givenAStore_movesItsPhotons() {
        PhotonStore store = new TestPhotons().floor(random, 70_000, 1, true).store();
        PhotonMap map = PhotonMap.over(store, density(0.1), NORMAL, new Workers(2));
        assertThat(store.size()).isZero();
        assertThat(map.tree().size()).isEqualTo(70_000);
        assertThat(map.bytes()).isEqualTo(map.tree().bytes()).isBetween(28L * 70_000, 36L * 70_000);
        Rgb power = new Rgb();
        double sum = 0;
        for (int i = 0; i < 70_000; i++) {
            map.tree().power(i, power);
            sum += power.red;
        }
        assertThat(sum).isCloseTo(4, within(1e-6));
    }

    @Test
    void lookup_givenLookups_countsNodesAndPhotons() {
        PhotonTree tree = new TestPhotons().floor(random, 32 * 1024, 1, true).tree();
        IlluminationMap.Lookup nearest =
                PhotonMap.over(tree, nearest(50, INFINITE), NORMAL).lookup();
        IlluminationMap.Lookup all = PhotonMap.over(tree, density(10), NORMAL).lookup();
        Rgb irradiance = new Rgb();
        for (int i = 0; i < 10; i++) {
            nearest.irradiance(floorPoint(0.05 * i, 0, true), irradiance);
            all.irradiance(floorPoint(0.05 * i, 0, true), irradiance);
        }
        // 1024 leaves have 1023 inner nodes above them.
        assertThat(all.nodesExamined()).isEqualTo(10 * (32 * 1024 + 1023));
        assertThat(all.photonsUsed()).isEqualTo(10 * 32 * 1024);
        assertThat(nearest.photonsUsed()).isEqualTo(10 * 49);
        assertThat(nearest.nodesExamined()).isBetween(10 * 60L, 10 * 1000L);
    }

    @Test
    void irradiance_givenManyLookups_allocatesNothing() {
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        PhotonTree tree = new TestPhotons().floor(random, 50_000, 1, true).tree();
        for (Estimator estimator : new Estimator[] {density(0.05), nearest(50, 0.2)}) {
            IlluminationMap.Lookup lookup =
                    PhotonMap.over(tree, estimator, NORMAL).lookup();
            SurfacePoint at = floorPoint(0, 0, true);
            Rgb irradiance = new Rgb();
            long least = Long.MAX_VALUE;
            for (int pass = 0; pass < 10; pass++) {
                long before = threads.getCurrentThreadAllocatedBytes();
                for (int i = 0; i < 2000; i++) {
                    at.x = -0.9 + 0.0009 * i;
                    lookup.irradiance(at, irradiance);
                }
                least = Math.min(least, threads.getCurrentThreadAllocatedBytes() - before);
            }
            assertThat(least).isZero();
        }
    }

    private double[] direction() {
        double z = random.nextDouble(-1, 1);
        double angle = random.nextDouble(2 * Math.PI);
        double r = Math.sqrt(1 - z * z);
        return new double[] {r * Math.cos(angle), r * Math.sin(angle), z};
    }

    private static Estimator density(double radius) {
        return new Estimator.Density(radius, Kernel.CONSTANT);
    }

    private static Estimator nearest(int count, double maximumRadius) {
        return new Estimator.Nearest(count, maximumRadius, Kernel.CONSTANT);
    }
}
