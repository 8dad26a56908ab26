package org.diacaustic.image;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class PixelRankTest {
    @ParameterizedTest
    @ValueSource(doubles = {1e-9, 0.01, 0.5, 0.99, 1})
    void positive_givenRandomValuesWithTies_agreesWithSorting(double share) {
        SplittableRandom random = new SplittableRandom(11);
        float[] values = new float[997];
        for (int i = 0; i < values.length; i++) {
            values[i] = i % 5 == 0 ? 2.5f : (float) StrictMath.exp(60 * random.nextDouble() - 30);
        }
        float[] sorted = values.clone();
        Arrays.sort(sorted);
        float expected = sorted[(int) Math.ceil(share * values.length) - 1];
        assertThat(PixelRank.positive(3 * values.length, offset -> values[offset / 3], share))
                .isEqualTo(expected);
    }
}
