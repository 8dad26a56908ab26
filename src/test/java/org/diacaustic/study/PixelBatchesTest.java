package org.diacaustic.study;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.diacaustic.image.LinearImage;
import org.junit.jupiter.api.Test;

class PixelBatchesTest {

    @Test
    void mean_givenBatches_isTheirMeanAndSaysHowFarItMayBeOff() {
        // 1, 2 and 6: mean 3, variance (4 + 1 + 9)/2 = 7, of the mean 7/3.
        PixelBatches batches = new PixelBatches(2, 1);
        batches.add(1, 1, 10, 0);
        batches.next();
        batches.add(1, 0.5, 5, 0);
        batches.add(1, 1.5, 15, 0);
        batches.next();
        batches.add(1, 6, 60, 0);
        batches.next();

        assertThat(batches.count()).isEqualTo(3);
        assertThat(batches.mean().samples()).containsExactly(0, 0, 0, 3, 30, 0);
        float[] error = {0, 0, 0, (float) Math.sqrt(7.0 / 3), (float) Math.sqrt(700.0 / 3), 0};
        assertThat(batches.standardError().samples()).containsExactly(error, within(1e-6f));
    }

    @Test
    void standardError_givenOneBatch_isUnknown() {
        PixelBatches batches = new PixelBatches(1, 1);
        batches.add(0, 1, 1, 1);
        batches.next();
        assertThat(batches.standardError().samples()[0]).isNaN();
    }

    @Test
    void halves_givenFourBatches_differByTheirMeans() {
        // (1 + 6)/2 − (2 + 3)/2.
        PixelBatches batches = new PixelBatches(1, 1);
        LinearImage one = new LinearImage(1, 1);
        one.set(0, 0, 1, 1, 1);
        for (int value : new int[] {1, 2, 6, 3}) {
            for (int i = 0; i < value + 1; i++) {
                batches.add(one, 1);
            }
            batches.add(one, -1);
            batches.next();
        }
        assertThat(batches.halves().samples()).containsExactly(1, 1, 1);
    }

    @Test
    void halves_givenThreeBatches_areRefused() {
        PixelBatches batches = new PixelBatches(1, 1);
        for (int i = 0; i < 3; i++) {
            batches.next();
        }
        assertThatThrownBy(batches::halves).isInstanceOf(IllegalStateException.class);
    }
}
