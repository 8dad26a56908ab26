package org.diacaustic.map;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.assertj.core.api.Assertions.withinPercentage;
import static org.diacaustic.map.TestPhotons.floorPoint;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class GatherStatisticsTest {
    private static final PhotonFilter NORMAL = PhotonFilter.TWO_SIDED_NORMAL;

    private final SplittableRandom random = new SplittableRandom(4);

    @Test
    void statistics_givenCountsBelowOne_throw() {
        PhotonTree tree = new TestPhotons().floor(random, 10, 1, true).tree();
        assertThatThrownBy(() -> GatherStatistics.medianNeighbourDistance(tree, 0, NORMAL, 10))
                .isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> GatherStatistics.medianNeighbourDistance(tree, 1, NORMAL, 0))
                .isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> GatherStatistics.expectedCount(tree, 1, NORMAL, 0))
                .isInstanceOf(IllegalArgumentException.class);
    }

    @Test
    void statistics_givenTooFewPhotons_saySo() {
        PhotonTree none = new TestPhotons().tree();
        assertThat(GatherStatistics.medianNeighbourDistance(none, 5, NORMAL, 10))
                .isInfinite();
        assertThat(GatherStatistics.expectedCount(none, 1, NORMAL, 10)).isZero();
        PhotonTree five = new TestPhotons().floor(random, 5, 1, true).tree();
        assertThat(GatherStatistics.medianNeighbourDistance(five, 5, NORMAL, 10))
                .isInfinite();
        assertThat(GatherStatistics.medianNeighbourDistance(five, 4, NORMAL, 10))
                .isFinite();
    }

    @Test
    void medianNeighbourDistance_givenALattice_isItsStep() {
        TestPhotons photons = new TestPhotons();
        for (int i = 0; i < 64 * 64; i++) {
            photons.add(floorPoint(i % 64 / 64.0, i / 64 / 64.0, true), 1);
            photons.add(floorPoint(i % 64 / 64.0, i / 64 / 64.0, false), 1);
        }
        PhotonTree tree = photons.tree();
        // Four neighbours at a step, four more at √2 steps; those of the other side are not seen through the filter.
        assertThat(GatherStatistics.medianNeighbourDistance(tree, 4, NORMAL, 500))
                .isEqualTo(1 / 64.0);
        assertThat(GatherStatistics.medianNeighbourDistance(tree, 5, NORMAL, 500))
                .isCloseTo(Math.sqrt(2) / 64, within(1e-8));
        assertThat(GatherStatistics.medianNeighbourDistance(tree, 1, PhotonFilter.NONE, 500))
                .isZero();
    }

    @Test
    void expectedCount_givenLightOnTwoAreas_isWhatTheyShare() {
        // 40,000 photons on 4, 40,000 on 0.04: stored × πr² ÷ area covered, edges aside. Half the photons look at
        // 10,000 π r² neighbours, half at 1,000,000 π r²; the edge of the small square is 1/10 of it wide for r = 0.01.
        PhotonTree tree = new TestPhotons()
                .floor(random, 40_000, 1, true)
                .floor(random, 40_000, 0.1, true)
                .tree();
        double radius = 0.01;
        double expected = 80_000 * Math.PI * radius * radius / 4;
        assertThat(GatherStatistics.expectedCount(tree, radius, NORMAL, 4000))
                .isCloseTo(expected, withinPercentage(10));
    }

    @Test
    void expectedCount_givenALattice_isItsDensityTimesTheDisc() {
        // On a lattice of step 1/64 photons themselves have 9 others within 1.957 steps, 13 with 2; on average it is π
        // r².
        TestPhotons photons = new TestPhotons();
        for (int i = 0; i < 64 * 64; i++) {
            photons.add(floorPoint(i % 64 / 64.0, i / 64 / 64.0, true), 1);
        }
        PhotonTree tree = photons.tree();
        for (double steps : new double[] {1.957, 2.0, 2.3}) {
            double edge = 1 + 2 * steps / 64;
            assertThat(GatherStatistics.expectedCount(tree, steps / 64, NORMAL, 4000))
                    .isCloseTo(Math.PI * steps * steps / (edge * edge), withinPercentage(3));
        }
    }
}
