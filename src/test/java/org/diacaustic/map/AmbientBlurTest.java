package org.diacaustic.map;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.diacaustic.math.Vector3;
import org.junit.jupiter.api.Test;

class AmbientBlurTest {
    private static final Chart ROUND = Chart.spherical(Vector3.ZERO, Vector3.UNIT_Y, Vector3.UNIT_X);
    private static final Chart FLAT = Chart.planar(Vector3.ZERO, Vector3.UNIT_X, Vector3.UNIT_Z);

    private final SplittableRandom random = new SplittableRandom(7);

    /** Areas over three orders of magnitude, some zero: slivers and holes. */
    private JoinedTexels unevenAreas(TexelGrid grid) {
        double[] areas = new double[grid.size()];
        Arrays.setAll(areas, i -> random.nextInt(10) == 0 ? 0 : Math.pow(10, -3 * random.nextDouble()));
        return JoinedTexels.joinSlivers(grid, areas);
    }

    private static double[] inKeepers(JoinedTexels texels, java.util.function.DoubleSupplier value) {
        double[] irradiance = new double[3 * texels.size()];
        for (int texel = 0; texel < texels.size(); texel++) {
            for (int channel = 0; channel < 3 && texels.keepsOwn(texel); channel++) {
                irradiance[3 * texel + channel] = value.getAsDouble();
            }
        }
        return irradiance;
    }

    private static double power(JoinedTexels texels, double[] irradiance) {
        double sum = 0;
        for (int texel = 0; texel < texels.size(); texel++) {
            sum += texels.area(texel) * irradiance[3 * texel + 1];
        }
        return sum;
    }

    @Test
    void blurred_givenUnevenAreas_keepsThePowerAndStaysPositive() {
        for (Chart chart : new Chart[] {ROUND, FLAT}) {
            for (int size : new int[] {3, 5, 9}) {
                TexelGrid grid = new TexelGrid(chart, 16, 12);
                JoinedTexels texels = unevenAreas(grid);
                double[] before = inKeepers(texels, () -> random.nextInt(4) == 0 ? random.nextDouble(100) : 0);
                double[] after = AmbientBlur.blurred(grid, texels, before, size);
                double power = power(texels, before);
                assertThat(power(texels, after)).isCloseTo(power, within(1e-13 * power));
                assertThat(Arrays.stream(after).min().orElseThrow()).isNotNegative();
                assertThat(after).isNotEqualTo(before);
            }
        }
    }

    @Test
    void blurred_givenUniformIrradiance_changesNothing() {
        for (Chart chart : new Chart[] {ROUND, FLAT}) {
            TexelGrid grid = new TexelGrid(chart, 16, 12);
            JoinedTexels texels = unevenAreas(grid);
            double[] uniform = inKeepers(texels, () -> 0.7);
            assertThat(AmbientBlur.blurred(grid, texels, uniform, 5)).isEqualTo(uniform);
        }
    }

    @Test
    void blurred_givenEqualAreas_isTheMeanOfTheSquare() {
        TexelGrid grid = new TexelGrid(FLAT, 9, 9);
        JoinedTexels texels = JoinedTexels.alike(grid);
        double[] before = inKeepers(texels, random::nextDouble);
        double[] after = AmbientBlur.blurred(grid, texels, before, 5);
        double sum = 0;
        for (int row = 2; row < 7; row++) {
            for (int column = 1; column < 6; column++) {
                sum += before[3 * (row * 9 + column)];
            }
        }
        assertThat(after[3 * (4 * 9 + 3)]).isCloseTo(sum / 25, within(1e-15));
    }

    @Test
    void blurred_givenACornerOfAPlane_holdsWhatWouldGoBeyondTheEdge() {
        // Of nine parts three go to neighbours; five would go beyond the edge and stay.
        TexelGrid grid = new TexelGrid(FLAT, 4, 4);
        double[] before = new double[48];
        before[0] = 9;
        double[] after = AmbientBlur.blurred(grid, JoinedTexels.alike(grid), before, 3);
        assertThat(new double[] {after[0], after[3], after[12], after[15], after[6]})
                .containsExactly(new double[] {6, 1, 1, 1, 0}, within(1e-15));
    }

    @Test
    void blurred_givenLightAtSeamAndPole_spreadsItOverThem() {
        // Texel (0, 0) of 8 × 4: neighbours around the seam are columns 7 and 1; over the pole columns 3, 4 and 5 of
        // row 0.
        TexelGrid grid = new TexelGrid(ROUND, 8, 4);
        double[] before = new double[3 * 32];
        before[0] = 9;
        double[] after = AmbientBlur.blurred(grid, JoinedTexels.alike(grid), before, 3);
        int[] lit = {0, 1, 3, 4, 5, 7, 8, 9, 15};
        for (int texel = 0; texel < 32; texel++) {
            assertThat(after[3 * texel])
                    .as("texel %d", texel)
                    .isCloseTo(Arrays.binarySearch(lit, texel) >= 0 ? 1 : 0, within(1e-15));
        }
    }
}
