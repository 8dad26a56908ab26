package org.diacaustic.map;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import org.diacaustic.math.Vector3;
import org.junit.jupiter.api.Test;

class AmbientChartTest {
    private static final TexelGrid ROW =
            new TexelGrid(Chart.planar(Vector3.ZERO, Vector3.UNIT_X, Vector3.UNIT_Z), 6, 1);

    @Test
    void new_givenWrongNumberOfAreas_refuses() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new AmbientChart(0, ROW, new double[5]))
                .withMessageContaining("6");
    }

    @Test
    void new_givenImpossibleAreas_refuses() {
        for (double area : new double[] {-1, Double.NaN, Double.POSITIVE_INFINITY}) {
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> new AmbientChart(0, ROW, new double[] {1, 1, area, 1, 1, 1}));
        }
        assertThatIllegalArgumentException().isThrownBy(() -> new AmbientChart(0, ROW, new double[6]));
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new AmbientChart(-1, ROW, new double[] {1, 1, 1, 1, 1, 1}));
    }

    @Test
    void area_givenASliver_isThatOfTheNeighbourThatTakesIt() {
        AmbientChart chart = new AmbientChart(0, ROW, new double[] {4, 2, 0.2, 1, 0.125, 0.01});
        // 0.2 < 2/8 joins the 2; 0.125 = 1/8 stays; 0.01 < 0.125/8 joins that.
        assertThat(chart.texels().keeper(2)).isEqualTo(1);
        assertThat(chart.area(2)).isEqualTo(2.2);
        assertThat(chart.area(1)).isEqualTo(2.2);
        assertThat(chart.area(3)).isEqualTo(1);
        assertThat(chart.area(5)).isEqualTo(0.135);
    }

    @Test
    void area_givenSliversInARow_isThatOfTheLastThatStays() {
        // Each joins the next larger: all end in the 64.
        AmbientChart chart = new AmbientChart(0, ROW, new double[] {0.01, 0.5, 64, 1, 1, 1});
        assertThat(chart.texels().keeper(0)).isEqualTo(2);
        assertThat(chart.texels().keeper(3)).isEqualTo(2);
        assertThat(chart.texels().keeper(4)).isEqualTo(4);
        assertThat(chart.area(0)).isEqualTo(65.51);
    }

    @Test
    void keeper_givenTexelsFarFromAnyArea_isTheNearestWithOne() {
        AmbientChart chart = new AmbientChart(0, ROW, new double[] {1, 0, 0, 0, 0, 2});
        assertThat(chart.texels().keeper(1)).isZero();
        assertThat(chart.texels().keeper(2)).isZero();
        assertThat(chart.texels().keeper(3)).isEqualTo(5);
        assertThat(chart.texels().keeper(4)).isEqualTo(5);
    }

    @Test
    void area_givenASphere_leavesThePolesAlone() {
        // Texels at a pole have about a third of the area of those in the next row: no slivers.
        Chart round = Chart.spherical(Vector3.ZERO, Vector3.UNIT_Y, Vector3.UNIT_X);
        TexelGrid grid = new TexelGrid(round, 64, 128);
        double[] areas = new double[grid.size()];
        for (int i = 0; i < areas.length; i++) {
            int row = i / 64;
            areas[i] = round.spread(1.0 / 64, row / 128.0, (row + 1) / 128.0);
        }
        AmbientChart chart = new AmbientChart(0, grid, areas);
        for (int i = 0; i < areas.length; i++) {
            assertThat(chart.area(i)).isEqualTo(areas[i]);
        }
    }
}
