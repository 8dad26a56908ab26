package org.diacaustic.map;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.diacaustic.math.Arithmetic;
import org.diacaustic.math.Rgb;
import org.diacaustic.math.Vector3;
import org.diacaustic.parallel.Workers;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Photons of scenes of any size, anywhere, against what is found by looking at each. */
class PhotonScaleTest {
    private static final int PHOTONS = 2000;

    /** Squared distances are off by the rounding of positions to single precision, relative to the whole. */
    private static final double SINGLE = 0x1p-20;

    private final SplittableRandom random = new SplittableRandom(4);

    @ParameterizedTest
    @CsvSource({
        "1e-300, 0",
        "1e-160, 0",
        "1e-45, 0",
        "1e-20, 0",
        "1, 0",
        "1, 1e7",
        "1, -1e7",
        "1e-3, 1e7",
        "1e20, 0",
        "1e30, 0",
        "1e30, 1e36",
        "1e39, 0",
        "1e150, 0",
        "1e300, 0"
    })
    void find_givenAnyScaleAndPlace_findsTheNearest(double scale, double offset) {
        for (String kind : new String[] {"even", "clustered", "line", "equal", "tiny"}) {
            SurfacePoint[] photons = photons(kind, scale, offset);
            PhotonTree tree = tree(photons, new Vector3(offset, offset, offset), scale);
            assertThat(tree.size()).isEqualTo(PHOTONS);
            NearestPhotons nearest = new NearestPhotons(tree, PhotonFilter.NONE, 20);
            for (int i = 0; i < 20; i++) {
                SurfacePoint at = photons[random.nextInt(PHOTONS)];
                assertThat(nearest.find(at, Double.POSITIVE_INFINITY)).isTrue();
                double[] sorted = Arrays.stream(photons)
                        .mapToDouble(photon -> distance(photon, at) / scale)
                        .sorted()
                        .toArray();
                double found = Math.sqrt(nearest.distanceSquaredInUnits(19)) * (tree.lengthUnit() / scale);
                assertThat(found).as(kind).isCloseTo(sorted[19], within(SINGLE));
            }
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {-1000, -400, -130, -20, 0, 30, 130, 400})
    void irradiance_givenAScaleOfTwo_isTheSameToTheBit(int exponent) {
        double scale = Math.scalb(1.0, exponent);
        // A power like the scale keeps the irradiance, which goes like power ÷ scale², in range.
        double power = scale;
        for (Estimator estimator : new Estimator[] {
            new Estimator.Density(0.1 * scale, Kernel.EPANECHNIKOV),
            new Estimator.Nearest(30, Double.POSITIVE_INFINITY, Kernel.CONE),
            new Estimator.Nearest(30, 0.05 * scale, Kernel.GAUSSIAN)
        }) {
            double expected = irradiance(at(estimator, scale), 1, 1);
            double found = irradiance(estimator, scale, power);
            assertThat(Math.scalb(Math.scalb(found, exponent), exponent) / power)
                    .isEqualTo(expected)
                    .isPositive();
        }
    }

    @Test
    void add_givenAPhotonFarBeyondTheScene_leavesItOut() {
        PhotonStore store = new PhotonStore(Vector3.ZERO, 0x1p-400, 1, 10);
        PhotonSlice slice = store.slice();
        slice.add(TestPhotons.floorPoint(0x1p-400, 0, true), new Rgb().set(1, 1, 1));
        slice.add(TestPhotons.floorPoint(1, 0, true), new Rgb().set(1, 1, 1));
        store.append(slice);
        assertThat(store.size()).isEqualTo(1);
        assertThat(store.rejectedCount()).isEqualTo(1);
        SurfacePoint out = new SurfacePoint();
        store.position(0, out);
        assertThat(out.x).isEqualTo(0x1p-400);
    }

    @Test
    void irradiance_givenAllPhotonsVeryNearTheOrigin_isFinite() {
        PhotonTree tree = tree(photons("equal", 1e-310, 0), Vector3.ZERO, Double.MIN_NORMAL);
        PhotonMap map = PhotonMap.over(tree, new Estimator.Density(1, Kernel.CONSTANT), PhotonFilter.NONE);
        assertThat(TestPhotons.red(map, TestPhotons.floorPoint(0, 0, true))).isCloseTo(PHOTONS / Math.PI, within(1e-6));
    }

    /** The same estimator for a scene of scale 1. */
    private static Estimator at(Estimator estimator, double scale) {
        if (estimator instanceof Estimator.Density density) {
            return new Estimator.Density(density.radius() / scale, density.kernel());
        }
        Estimator.Nearest nearest = (Estimator.Nearest) estimator;
        return new Estimator.Nearest(nearest.count(), nearest.maximumRadius() / scale, nearest.kernel());
    }

    private static double irradiance(Estimator estimator, double scale, double power) {
        SplittableRandom same = new SplittableRandom(8);
        PhotonStore store = new PhotonStore(Vector3.ZERO, scale, Arithmetic.powerOfTwoNear(power), PHOTONS);
        PhotonSlice slice = store.slice();
        for (int i = 0; i < PHOTONS; i++) {
            slice.add(
                    TestPhotons.floorPoint(scale * same.nextDouble(-1, 1), scale * same.nextDouble(-1, 1), true),
                    new Rgb().set(power, power, power));
        }
        store.append(slice);
        PhotonMap map = PhotonMap.over(store, estimator, PhotonFilter.TWO_SIDED_NORMAL, new Workers(1));
        return TestPhotons.red(map, TestPhotons.floorPoint(0.25 * scale, -0.125 * scale, true));
    }

    private static PhotonTree tree(SurfacePoint[] photons, Vector3 origin, double scale) {
        PhotonStore store = new PhotonStore(origin, Arithmetic.powerOfTwoNear(scale), 1, PHOTONS);
        PhotonSlice slice = store.slice();
        for (SurfacePoint photon : photons) {
            slice.add(photon, new Rgb().set(1, 1, 1));
        }
        store.append(slice);
        return PhotonTree.movedFrom(store, new Workers(1));
    }

    private SurfacePoint[] photons(String kind, double scale, double offset) {
        SurfacePoint[] photons = new SurfacePoint[PHOTONS];
        for (int i = 0; i < PHOTONS; i++) {
            double spread = switch (kind) {
                case "equal" -> 0;
                case "tiny" -> 1e-5;
                case "clustered" -> random.nextInt(4) == 0 ? 1 : 1e-3;
                default -> 1;
            };
            double x = spread * random.nextDouble(-1, 1);
            boolean isLine = kind.equals("line");
            double y = isLine ? x : spread * random.nextDouble(-1, 1);
            double z = isLine ? x : spread * random.nextDouble(-1, 1);
            photons[i] = TestPhotons.above(offset + scale * x, offset + scale * y, offset + scale * z);
        }
        return photons;
    }

    private static double distance(SurfacePoint a, SurfacePoint b) {
        return Arithmetic.length(a.x - b.x, a.y - b.y, a.z - b.z);
    }
}
