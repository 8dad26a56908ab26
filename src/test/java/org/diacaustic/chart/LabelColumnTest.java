package org.diacaustic.chart;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;

class LabelColumnTest {
    private static final Offset<Double> ROUNDING = Offset.offset(1e-9);

    @Test
    void spread_givenRoom_movesNothing() {
        assertThat(LabelColumn.spread(new double[] {30, 10, 20}, 5, 0, 100)).containsExactly(30, 10, 20);
    }

    @Test
    void spread_givenTwoAtOnePlace_movesBothByHalf() {
        assertThat(LabelColumn.spread(new double[] {10, 10}, 4, 0, 100)).containsExactly(8, 12);
    }

    @Test
    void spread_givenThirdInTheWay_movesAllThree() {
        // 10, 10 come to stand at 8 and 12; 13 is too near. Three with a gap of 4 around wishes 10, 10 − 4 and 13 − 8:
        // from 7.
        assertThat(LabelColumn.spread(new double[] {10, 10, 13}, 4, 0, 100)).containsExactly(7, 11, 15);
    }

    @Test
    void spread_givenEnds_staysWithin() {
        assertThat(LabelColumn.spread(new double[] {1, 1, 99, 99}, 10, 0, 100)).containsExactly(0, 10, 90, 100);
    }

    @Test
    void spread_givenTooManyForTheColumn_keepsGapsAndGoesBelow() {
        assertThat(LabelColumn.spread(new double[] {5, 5, 5}, 10, 0, 15)).containsExactly(0, 10, 20);
    }

    @Test
    void spread_givenAnyWishes_keepsGapsAndOrder() {
        SplittableRandom random = new SplittableRandom(1);
        for (int trial = 0; trial < 200; trial++) {
            double[] wished = random.doubles(12, 0, 100).sorted().toArray();
            double[] places = LabelColumn.spread(wished, 7, 0, 100);
            for (int i = 1; i < places.length; i++) {
                assertThat(places[i] - places[i - 1]).isGreaterThan(7 - ROUNDING.value);
            }
            assertThat(places[0]).isGreaterThan(-ROUNDING.value);
            assertThat(places[11]).isLessThan(100 + ROUNDING.value);
        }
    }
}
