package org.diacaustic.map;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import org.diacaustic.math.Vector3;
import org.junit.jupiter.api.Test;

class TexelGridTest {
    private static final Chart ROUND = Chart.spherical(Vector3.ZERO, Vector3.UNIT_Y, Vector3.UNIT_X);
    private static final Chart FLAT = Chart.planar(Vector3.ZERO, Vector3.UNIT_X, Vector3.UNIT_Z);

    @Test
    void new_givenNoTexelsOrTooMany_refuses() {
        assertThatIllegalArgumentException().isThrownBy(() -> new TexelGrid(FLAT, 0, 3));
        assertThatIllegalArgumentException().isThrownBy(() -> new TexelGrid(FLAT, 3, 0));
        assertThatIllegalArgumentException().isThrownBy(() -> new TexelGrid(FLAT, 1 << 20, 1 << 20));
    }

    @Test
    void new_givenOddColumnsAround_refuses() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new TexelGrid(ROUND, 7, 4))
                .withMessageContaining("even");
        assertThat(new TexelGrid(FLAT, 7, 4).size()).isEqualTo(28);
    }

    @Test
    void texel_givenPointsBeyondThePlane_takesThoseAtTheBorder() {
        TexelGrid grid = new TexelGrid(FLAT, 4, 3);
        assertThat(grid.texel(0.3, 0, 0.4)).isEqualTo(5);
        assertThat(grid.texel(-1e-9, 0, 1)).isEqualTo(8);
        assertThat(grid.texel(1, 0, -7)).isEqualTo(3);
    }

    @Test
    void beyondBorder_givenSeamAndPoles_goesOnAtTheOtherSide() {
        TexelGrid grid = new TexelGrid(ROUND, 8, 4);
        assertThat(grid.beyondBorder(-1, 1)).isEqualTo(15);
        assertThat(grid.beyondBorder(8, 1)).isEqualTo(8);
        assertThat(grid.beyondBorder(1, -1)).isEqualTo(5);
        assertThat(grid.beyondBorder(6, 4)).isEqualTo(24 + 2);
    }

    @Test
    void beyondBorder_givenAPlane_findsNothing() {
        TexelGrid grid = new TexelGrid(FLAT, 8, 4);
        assertThat(grid.beyondBorder(-1, 1)).isEqualTo(TexelGrid.NONE);
        assertThat(grid.beyondBorder(1, 4)).isEqualTo(TexelGrid.NONE);
        assertThat(grid.atBorder(-1, 4)).isEqualTo(24);
    }

    @Test
    void beyondBorder_givenPointsOnBothSidesOfAPole_findsTheTexelOfThePoint() {
        // From just beside the north pole at u = 1/16 straight over it: half way round, same row.
        TexelGrid grid = new TexelGrid(ROUND, 8, 4);
        double turn = 2 * Math.PI / 16;
        int here = grid.texel(0.1 * Math.cos(turn), 1, -0.1 * Math.sin(turn));
        int there = grid.texel(-0.1 * Math.cos(turn), 1, 0.1 * Math.sin(turn));
        assertThat(here).isEqualTo(24);
        assertThat(grid.beyondBorder(0, 4)).isEqualTo(there);
    }
}
