package org.diacaustic.math;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class BoundsTest {
    private final Bounds cube = new Bounds(0, 0, 0, 1, 1, 1);

    @ParameterizedTest
    @ValueSource(doubles = {0.0, -0.0})
    void isHitBy_givenRayInFacePlane_hitsWhateverTheSignOfZero(double zero) {
        // 0·∞ in the slab test must not reject the box. The ray enters at 1 and leaves at 2.
        Ray ray = new Ray();
        ray.set(1, 0.5, -1, zero, 0, 1);
        assertThat(cube.isHitBy(ray)).isTrue();
        ray.tMax = 0.999;
        assertThat(cube.isHitBy(ray)).isFalse();
    }

    @Test
    void isHitBy_givenFlatBox_hitsFromAbove() {
        Ray ray = new Ray();
        ray.set(0.5, 1, 0.5, 0, -1, 0);
        assertThat(new Bounds(0, 0, 0, 1, 0, 1).isHitBy(ray)).isTrue();
        ray.set(1.5, 1, 0.5, 0, -1, 0);
        assertThat(new Bounds(0, 0, 0, 1, 0, 1).isHitBy(ray)).isFalse();
    }

    @Test
    void isHitBy_givenBoxBehindOrBeside_misses() {
        Ray ray = new Ray();
        ray.set(0.5, 0.5, 2, 0, 0, 1);
        assertThat(cube.isHitBy(ray)).isFalse();
        ray.set(-1, 3.5, 0.5, 1, -1, 0);
        assertThat(cube.isHitBy(ray)).isFalse();
    }
}
