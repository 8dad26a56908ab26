package org.diacaustic.trial;

import org.diacaustic.light.Light;
import org.diacaustic.map.Kernel;
import org.diacaustic.material.Material;
import org.diacaustic.math.Color;
import org.diacaustic.math.Vector3;
import org.diacaustic.scene.Camera;
import org.diacaustic.scene.EstimatorName;
import org.diacaustic.scene.MapSettings;
import org.diacaustic.scene.Scene;
import org.diacaustic.scene.Settings;
import org.diacaustic.shape.ConvexPolygon;
import org.diacaustic.shape.Shape;

/**
 * A matt thing under a clear sheet that bends nothing. Forward passes leave direct light to shadow rays, and light through the
 * sheet is indirect: so photons tell what a lamp sends to a bare floor.
 */
final class LitFloor {
    /** The number of the object that is lit. */
    static final int LIT = 0;

    private LitFloor() {}

    /** A floor at height 0 that reaches beyond the light of the sheet. */
    static Scene under(double sheetHeight, double sheetHalf, double floorHalf, Light... lights) {
        return under(square(0, floorHalf), sheetHeight, sheetHalf, lights);
    }

    static Scene under(Shape lit, double sheetHeight, double sheetHalf, Light... lights) {
        Scene.Builder scene = Scene.builder().camera(camera(sheetHeight, sheetHalf));
        for (Light light : lights) {
            scene.light(light);
        }
        return scene.object("lit", lit, Material.builder().diffuse(Color.WHITE).build())
                .object(
                        "sheet",
                        square(sheetHeight, sheetHalf),
                        Material.builder().transparency(Color.WHITE).build())
                .build();
    }

    private static Camera camera(double height, double half) {
        return Camera.builder()
                .from(new Vector3(0, height + half, -half))
                .to(Vector3.ZERO)
                .size(8, 8)
                .build();
    }

    /** A horizontal square about the vertical axis. */
    static ConvexPolygon square(double height, double half) {
        return ConvexPolygon.twoSided(
                new Vector3(-half, height, -half),
                new Vector3(-half, height, half),
                new Vector3(half, height, half),
                new Vector3(half, height, -half));
    }

    /** Lookups within a radius, where all photons count alike. */
    static Settings within(double radius, long seed) {
        return settings(MapSettings.builder().gatherRadius(radius).estimator(EstimatorName.DENSITY), seed);
    }

    /** Lookups of the k nearest photons, which count alike. */
    static Settings nearest(int count, long seed) {
        return settings(MapSettings.builder().gatherCount(count).estimator(EstimatorName.NEAREST), seed);
    }

    /** As {@link #within}, but rays are sent into all directions, not only to the sheet. */
    static Settings everywhere(double radius, long seed) {
        Settings settings = within(radius, seed);
        return settings.toBuilder()
                .forward(settings.forward().toBuilder().aimAtSpecular(false).build())
                .build();
    }

    private static Settings settings(MapSettings.Builder maps, long seed) {
        return Settings.physical().toBuilder()
                .seed(seed)
                .maps(maps.kernel(Kernel.CONSTANT).build())
                .build();
    }
}
