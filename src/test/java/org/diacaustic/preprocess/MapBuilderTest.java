package org.diacaustic.preprocess;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.function.UnaryOperator;
import org.diacaustic.light.Falloff;
import org.diacaustic.math.Vector3;
import org.diacaustic.parallel.Workers;
import org.diacaustic.scene.MapName;
import org.diacaustic.scene.MapSettings;
import org.diacaustic.scene.Scene;
import org.diacaustic.scene.Settings;
import org.junit.jupiter.api.Test;

class MapBuilderTest {

    /** Few photons ask for the smallest map, 16 × 16; half as many columns are half as many texels. */
    @Test
    void build_givenColumnsOnly_takesThemAndLeavesTheRowsToTheCamera() {
        assertThat(2 * bytes(maps -> maps.mapColumns(8))).isEqualTo(bytes(maps -> maps));
        assertThat(2 * bytes(maps -> maps.mapRows(8))).isEqualTo(bytes(maps -> maps));
    }

    /** A radius within which photons have no other says nothing of the light; one that holds some is taken as it is. */
    @Test
    void build_givenARadiusThatHoldsNoTwoPhotons_takesThatOfThePhotons() {
        double own = gatherRadius(0);
        assertThat(own).isPositive();
        assertThat(gatherRadius(1e-9)).isEqualTo(own);
        assertThat(gatherRadius(0.5 * own)).isEqualTo(0.5 * own);
        assertThat(gatherRadius(3 * own)).isEqualTo(3 * own);
    }

    private static double gatherRadius(double asked) {
        Scene scene = Forward.sheetOver(Forward.square(0, 2), new Vector3(0, 7, 0), new Falloff.InverseSquare());
        Settings settings = Settings.physical().toBuilder()
                .maps(MapSettings.builder().gatherRadius(asked).build())
                .build();
        ForwardPlan plan = Forward.plan(scene, settings, "random", 2000);
        Workers workers = new Workers(1);
        MapBuilder builder = new MapBuilder(plan, workers);
        builder.build(scene.camera(), new ForwardPass(plan, 0, workers).run().photons(), 0);
        return builder.gatherRadius();
    }

    private static long bytes(UnaryOperator<MapSettings.Builder> change) {
        Scene scene = Forward.sheetOver(Forward.square(0, 2), new Vector3(0, 7, 0), new Falloff.InverseSquare());
        Settings settings = Settings.physical().toBuilder()
                .maps(change.apply(MapSettings.builder().map(MapName.AMBIENT_MAPS))
                        .build())
                .build();
        ForwardPlan plan = Forward.plan(scene, settings, "cube", 500);
        Workers workers = new Workers(1);
        ForwardPass pass = new ForwardPass(plan, 0, workers).run();
        return new MapBuilder(plan, workers)
                .build(scene.camera(), pass.photons(), 0)
                .bytes();
    }
}
