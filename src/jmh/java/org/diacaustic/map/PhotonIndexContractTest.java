package org.diacaustic.map;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.diacaustic.math.Rgb;
import org.diacaustic.math.Vector3;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;

/** Every index finds what looking at all photons finds: one body for all of them. */
class PhotonIndexContractTest {
    private static final int[] COUNTS = {1, 2, 27, 50, 700, 5000};
    private static final double[] RADII = {0, 0x1p-10, 0x1p-4, 0.25, 0.5, 4, Double.POSITIVE_INFINITY};

    private final SplittableRandom random = new SplittableRandom(21);
    private final Rgb sum = new Rgb();

    static Stream<Arguments> contract() {
        return Stream.of(IndexKind.values())
                .flatMap(kind -> Stream.of(Cloud.values()).map(cloud -> Arguments.of(kind, cloud)));
    }

    @ParameterizedTest
    @MethodSource("contract")
    void query_givenAnyPhotons_findsWhatLookingAtAllFinds(IndexKind kind, Cloud cloud) {
        List<SurfacePoint> points = cloud.points();
        PhotonColumns all = PhotonColumns.of(store(points));
        PhotonIndex index = kind.build(store(points), 0.1);
        for (PhotonFilter filter : PhotonFilter.values()) {
            GatherQuery query = index.query(filter);
            for (int i = 0; i < 25; i++) {
                SurfacePoint at =
                        i % 2 == 0 && !points.isEmpty() ? points.get(random.nextInt(points.size())) : somewhere();
                double radius = RADII[i % RADII.length];
                int count = COUNTS[i % COUNTS.length];
                compareWithin(query, all, filter, at, radius);
                compareNearest(query, all, filter, at, count, radius);
                compareNearest(query, all, filter, at, count, Double.POSITIVE_INFINITY);
            }
        }
    }

    @ParameterizedTest
    @EnumSource(IndexKind.class)
    void query_givenAThinSheet_seesItsOwnSideOnly(IndexKind kind) {
        PhotonIndex index = kind.build(store(Cloud.TWO_SIDES.points()), 0.1);
        SurfacePoint below = TestPhotons.floorPoint(0.5, 0.5, false);
        GatherQuery filtered = index.query(PhotonFilter.TWO_SIDED_NORMAL);
        // 40 of the 2000 photons are below: none of the 1960 others takes one of the 30 places.
        filtered.nearest(below, 30, Double.POSITIVE_INFINITY);
        assertThat(filtered.found).isEqualTo(30);
        filtered.within(below, Double.POSITIVE_INFINITY);
        assertThat(filtered.found).isEqualTo(40);
        GatherQuery unfiltered = index.query(PhotonFilter.NONE);
        unfiltered.within(below, Double.POSITIVE_INFINITY);
        assertThat(unfiltered.found).isEqualTo(2000);
    }

    private void compareWithin(
            GatherQuery query, PhotonColumns all, PhotonFilter filter, SurfacePoint at, double radius) {
        int[] expected = candidates(all, filter, at, radius);
        query.within(at, radius);
        assertThat(query.found).isEqualTo(expected.length);
        assertThat(query.sum.red).isCloseTo(redSum(all, expected, expected.length), within(1e-9));
    }

    private void compareNearest(
            GatherQuery query, PhotonColumns all, PhotonFilter filter, SurfacePoint at, int count, double radius) {
        int[] expected = IntStream.of(candidates(all, filter, at, radius))
                .boxed()
                .sorted((a, b) -> Float.compare(distance(all, a, at), distance(all, b, at)))
                .mapToInt(Integer::intValue)
                .toArray();
        int found = Math.min(count, expected.length);
        query.nearest(at, count, radius);
        assertThat(query.found).isEqualTo(found);
        if (found > 0) {
            float farthest = distance(all, expected[found - 1], at);
            assertThat(query.farthestSquared).isEqualTo(farthest);
            // Where the k-th and the next are as far, any of them will do.
            if (found == expected.length || distance(all, expected[found], at) > farthest) {
                assertThat(query.sum.red).isCloseTo(redSum(all, expected, found), within(1e-9));
            }
        }
    }

    private int[] candidates(PhotonColumns all, PhotonFilter filter, SurfacePoint at, double radius) {
        float radiusSquared = (float) (radius * radius);
        return IntStream.range(0, all.size())
                .filter(i -> distance(all, i, at) <= radiusSquared)
                .filter(i -> filter == PhotonFilter.NONE
                        || PackedNormal.isWithin(all.normal[i], filter.cosine(), at.normalX, at.normalY, at.normalZ))
                .toArray();
    }

    private static float distance(PhotonColumns all, int i, SurfacePoint at) {
        return all.distanceSquared(i, (float) at.x, (float) at.y, (float) at.z);
    }

    /** Powers differ, so that their sum tells which photons were found. */
    private static double redSum(PhotonColumns all, int[] photons, int count) {
        return IntStream.of(photons).limit(count).mapToDouble(i -> all.red[i]).sum();
    }

    private PhotonStore store(List<SurfacePoint> points) {
        PhotonStore store = new PhotonStore(Vector3.ZERO, 1, 10_000);
        PhotonSlice slice = store.slice();
        SplittableRandom powers = new SplittableRandom(2);
        for (SurfacePoint point : points) {
            slice.add(point, sum.set((float) powers.nextDouble(), 1, 0));
        }
        store.append(slice);
        return store;
    }

    private SurfacePoint somewhere() {
        return TestPhotons.point(
                (float) random.nextDouble(-0.5, 1.5),
                (float) random.nextDouble(-0.5, 1.5),
                (float) random.nextDouble(-0.5, 1.5),
                0,
                0.6,
                0.8);
    }

    /** Where photons may lie. Coordinates are exact in single precision. */
    enum Cloud {
        EMPTY(0),
        ONE(1),
        TWO(2),
        THREE(3),
        BELOW_LEAF(31),
        LEAF(32),
        ABOVE_LEAF(33),
        BELOW_POWER(1023),
        POWER(1024),
        ABOVE_POWER(1025),
        EQUAL(1000),
        TWO_PLACES(1000),
        LINE(512),
        LATTICE(4096),
        TWO_SIDES(2000),
        CLUSTERS(3000);

        private final int size;

        Cloud(int size) {
            this.size = size;
        }

        List<SurfacePoint> points() {
            SplittableRandom random = new SplittableRandom(5);
            List<SurfacePoint> points = new ArrayList<>();
            for (int i = 0; i < size; i++) {
                points.add(point(i, random));
            }
            return points;
        }

        private SurfacePoint point(int i, SplittableRandom random) {
            double u = random.nextInt(1 << 20) * 0x1p-20;
            double v = random.nextInt(1 << 20) * 0x1p-20;
            double w = random.nextInt(1 << 20) * 0x1p-20;
            return switch (this) {
                case EQUAL -> TestPhotons.point(0.5, 0.25, 0.125, 0, 1, 0);
                case TWO_PLACES -> TestPhotons.point(i % 2 * 0.5, 0, 0, 0, 1, 0);
                case LINE -> TestPhotons.point(u, u, u, 0, 0, 1);
                case LATTICE -> TestPhotons.point((i >> 8) / 16.0, (i >> 4 & 15) / 16.0, (i & 15) / 16.0, 0, 0, 1);
                case TWO_SIDES -> TestPhotons.floorPoint(u, v, i % 50 != 0);
                case CLUSTERS ->
                    TestPhotons.point(
                            u, (float) (0.002 * v), (float) (0.3 * Math.sin(7 * u) + 0.002 * w), u - 0.5, v, w + 0.1);
                default -> TestPhotons.point(u, v, w, u - 0.5, v - 0.5, w + 0.1);
            };
        }
    }
}
