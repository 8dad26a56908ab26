package org.diacaustic.map;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.util.Arrays;
import java.util.List;
import org.diacaustic.math.Vector3;
import org.junit.jupiter.api.Test;

class InitialHitsTest {
    /** The thesis' sheet of water: a square turned by 45°, its half diagonal 3.5355, at y = 4; the chart along its edges. */
    private static final double HALF_DIAGONAL = 3.5355;

    private static final Chart SHEET = Chart.planar(
            new Vector3(HALF_DIAGONAL, 4, 0),
            new Vector3(-HALF_DIAGONAL, 0, HALF_DIAGONAL),
            new Vector3(-HALF_DIAGONAL, 0, -HALF_DIAGONAL));

    private static InitialHits onSheet(int columns, int rows, int raysPerCell) {
        return new InitialHits(List.of(new TexelGrid(SHEET, columns, rows)), raysPerCell);
    }

    @Test
    void new_givenNoRaysPerCell_refuses() {
        assertThatIllegalArgumentException().isThrownBy(() -> onSheet(140, 141, 0));
    }

    @Test
    void admit_givenThePlanarLatticeOfTheThesis_admitsWhatTheThesisStored() {
        // [Thesis Table 4, planar: 17,290 stored] of the 22,260 rays that meet the sheet [Table 5].
        InitialHits hits = onSheet(140, 141, 1);
        int met = 0;
        int admitted = 0;
        for (int i = 0; i < 421; i++) {
            double x = -7.0711 + 14.1422 * i / 421;
            for (int k = 0; k < 421; k++) {
                double z = -7.0711 + 14.1422 * k / 421;
                if (Math.abs(x) + Math.abs(z) <= HALF_DIAGONAL) {
                    met++;
                    admitted += hits.admit(0, x, 4, z) ? 1 : 0;
                }
            }
        }
        assertThat(met).isEqualTo(22_260);
        assertThat(admitted).isEqualTo(17_290);
    }

    @Test
    void admit_givenManyRaysOnOneCell_admitsTheFirstOnes() {
        InitialHits hits = onSheet(2, 2, 3);
        boolean[] admitted = new boolean[5];
        for (int i = 0; i < 5; i++) {
            admitted[i] = hits.admit(0, 1 + 0.01 * i, 4, 0);
        }
        assertThat(admitted).containsExactly(true, true, true, false, false);
        assertThat(hits.admit(0, -1, 4, 0)).isTrue();
    }

    @Test
    void admit_givenAnObjectWithoutCells_admitsAll() {
        InitialHits hits = new InitialHits(Arrays.asList(null, new TexelGrid(SHEET, 1, 1)), 1);
        for (int i = 0; i < 3; i++) {
            assertThat(hits.admit(0, 0, 4, 0)).isTrue();
        }
        assertThat(hits.admit(1, 0, 4, 0)).isTrue();
        assertThat(hits.admit(1, 0, 4, 0)).isFalse();
    }
}
