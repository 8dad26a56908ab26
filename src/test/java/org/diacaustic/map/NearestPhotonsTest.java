package org.diacaustic.map;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.withinPercentage;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Cases whose answers were computed in whole numbers. */
class NearestPhotonsTest {
    @ParameterizedTest
    @CsvSource({
        "cube, 0, 5, 2, 0.5, 0.5, 0.5, 0, 0, 0",
        "cube, 1, 5, 2, 0.5, 0.5, 0.5, 1, 0.3240854526120529, 0.3240854526120529",
        "cube, 2, 5, 2, 0.5, 0.5, 0.5, 2, 0.3240854526120529, 0.4216978424856279",
        "cube, 3, 5, 2, 0.5, 0.5, 0.5, 2, 0.2188163554255880, 0.3164287452991630",
        "cube, 1023, 42, 50, 0.5, 0.5, 0.5, 50, 0.0501165568721262, 1.5111437012328679",
        "cube, 1024, 42, 50, 0.5, 0.5, 0.5, 50, 0.0501165568721262, 1.5111437012328679",
        "cube, 1025, 42, 50, 0.5, 0.5, 0.5, 50, 0.0501165568721262, 1.5111437012328679",
        "equal, 1000, 1, 50, 0.5, 0.25, 0.125, 50, 0, 0",
        "two, 1000, 1, 700, 0, 0, 0, 700, 0.25, 50",
        "line, 512, 9, 20, 0.5, 0.5, 0, 20, 0.1673580753122223, 3.3373703515526358",
        "lattice, 4096, 0, 27, 0.5, 0.5, 0.5, 27, 0.01171875, 0.2109375",
        "cube, 10, 3, 1000, 0.09999942779541016, 0.19999980926513672, 0.2999992370605469, 10, 1.2893676774156120,"
                + " 5.1018304518338482"
    })
    void find_givenACase_findsTheSquaredDistances(
            String kind,
            int size,
            long seed,
            int count,
            double x,
            double y,
            double z,
            int found,
            double last,
            double sum) {
        PhotonTree tree = tree(kind, size, seed);
        NearestPhotons nearest = new NearestPhotons(tree, PhotonFilter.NONE, count);

        boolean enough = nearest.find(TestPhotons.above(x, y, z), Double.POSITIVE_INFINITY);

        assertThat(enough).isEqualTo(found == count);
        assertThat(nearest.found()).isEqualTo(found);
        double total = 0;
        double farthest = 0;
        for (int i = 0; i < found; i++) {
            total += nearest.distanceSquared(i);
            farthest = Math.max(farthest, nearest.distanceSquared(i));
        }
        assertThat(farthest).isCloseTo(last, withinPercentage(2e-5));
        assertThat(total).isCloseTo(sum, withinPercentage(2e-5));
        if (enough) {
            assertThat(nearest.distanceSquared(count - 1)).isEqualTo(farthest);
        }
    }

    @ParameterizedTest
    @CsvSource({
        "cube, 1, 5, 0.5, 0.5, 0.5, 0.5, 0",
        "cube, 2, 5, 0.5, 0.5, 0.5, 0.5, 1",
        "cube, 3, 5, 0.5, 0.5, 0.5, 0.5, 2",
        "cube, 1024, 42, 0.5, 0.5, 0.5, 0.1, 2",
        "equal, 1000, 1, 0.5, 0.25, 0.125, 0, 1000",
        "two, 1000, 1, 0, 0, 0, 0.5, 1000",
        "line, 512, 9, 0.5, 0.5, 0, 0.4472135954999579, 104",
        "lattice, 4096, 0, 0.5, 0.5, 0.5, 0.0625, 7",
        "cube, 10, 3, 0.1, 0.2, 0.3, 1e150, 10"
    })
    void next_givenACase_countsTheClosedBall(
            String kind, int size, long seed, double x, double y, double z, double radius, int expected) {
        PhotonSearch search = new PhotonSearch(tree(kind, size, seed), PhotonFilter.NONE);
        int count = 0;
        search.start(TestPhotons.above(x, y, z), radius);
        for (int found = search.next(); found >= 0; found = search.next()) {
            count += found;
        }
        assertThat(count).isEqualTo(expected);
    }

    private static PhotonTree tree(String kind, int size, long seed) {
        TestPhotons photons = new TestPhotons();
        Sequence sequence = new Sequence(seed);
        for (int i = 0; i < size; i++) {
            photons.add(
                    switch (kind) {
                        case "equal" -> TestPhotons.above(0.5, 0.25, 0.125);
                        case "two" -> TestPhotons.above(i % 2 * 0.5, 0, 0);
                        case "line" -> sequence.onDiagonal();
                        case "lattice" -> TestPhotons.above((i >> 8) / 16.0, (i >> 4 & 15) / 16.0, (i & 15) / 16.0);
                        default -> sequence.inCube();
                    },
                    1);
        }
        return photons.tree();
    }

    /** The multiples of 2^-20 that the cases were computed with. */
    private static final class Sequence {
        private long state;

        Sequence(long seed) {
            state = seed;
        }

        private double next() {
            state = state * 6364136223846793005L + 1442695040888963407L;
            return (state >>> 44) * 0x1p-20;
        }

        SurfacePoint inCube() {
            double x = next();
            double y = next();
            return TestPhotons.above(x, y, next());
        }

        SurfacePoint onDiagonal() {
            double u = next();
            return TestPhotons.above(u, u, u);
        }
    }
}
