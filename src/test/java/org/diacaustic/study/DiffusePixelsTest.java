package org.diacaustic.study;

import static org.assertj.core.api.Assertions.assertThat;

import org.diacaustic.light.Falloff;
import org.diacaustic.light.SphereLight;
import org.diacaustic.material.Material;
import org.diacaustic.math.Color;
import org.diacaustic.math.Vector3;
import org.diacaustic.scene.Camera;
import org.diacaustic.scene.Scene;
import org.diacaustic.shape.ConvexPolygon;
import org.junit.jupiter.api.Test;

class DiffusePixelsTest {
    private static final Material MATT =
            Material.builder().diffuse(Color.grey(0.5)).build();

    /** Looks along −z at the plane z = 0 from a distance of 10, so that a pixel is 1 × 1 there, the picture 8 × 8. */
    private static Scene.Builder scene() {
        return Scene.builder()
                .camera(Camera.builder()
                        .from(new Vector3(0, 0, 10))
                        .to(Vector3.ZERO)
                        .fieldOfView(Math.toDegrees(2 * Math.atan(0.4)))
                        .size(8, 8)
                        .build());
    }

    private static ConvexPolygon rectangle(double left, double bottom, double right, double top, double z) {
        return ConvexPolygon.twoSided(
                new Vector3(left, bottom, z),
                new Vector3(right, bottom, z),
                new Vector3(right, top, z),
                new Vector3(left, top, z));
    }

    @Test
    void of_givenARectangle_leavesOutThePixelsOnItsEdges() {
        // Columns 1.5 to 6.5 and rows 2.5 to 5.5 of the picture.
        DiffusePixels pixels = DiffusePixels.of(
                scene().object("wall", rectangle(-2.5, -1.5, 2.5, 1.5, 0), MATT).build());
        for (int y = 0; y < 8; y++) {
            for (int x = 0; x < 8; x++) {
                assertThat(pixels.includes(x, y)).as("%d, %d", x, y).isEqualTo(x >= 2 && x < 6 && y >= 3 && y < 5);
            }
        }
        assertThat(pixels.count()).isEqualTo(8);
        assertThat(pixels.picture().get(2, 3)).isEqualTo(Color.WHITE);
        assertThat(pixels.picture().get(3, 2)).isEqualTo(Color.BLACK);
    }

    @Test
    void of_givenTwoObjectsSideBySide_leavesOutThePixelsThatShowBoth() {
        DiffusePixels pixels = DiffusePixels.of(scene().object("left", rectangle(-9, -9, 0.5, 9, 0), MATT)
                .object("right", rectangle(0.5, -9, 9, 9, 0), MATT)
                .build());
        assertThat(pixels.count()).isEqualTo(7 * 8);
        assertThat(pixels.includes(4, 4)).isFalse();
    }

    @Test
    void of_givenWhatMirrorsOrLetsLightThrough_leavesItOut() {
        Material polished = Material.builder()
                .diffuse(Color.grey(0.5))
                .reflectivity(Color.grey(0.1))
                .build();
        Material milky = Material.builder()
                .diffuse(Color.grey(0.5))
                .transparency(Color.grey(0.1))
                .build();
        Material black = Material.builder().build();
        DiffusePixels pixels = DiffusePixels.of(scene().object("wall", rectangle(-9, -9, 9, 9, 0), MATT)
                .object("polished", rectangle(-4, 2, -2, 4, 1), polished)
                .object("milky", rectangle(2, 2, 4, 4, 1), milky)
                .object("black", rectangle(2, -4, 4, -2, 1), black)
                .build());
        assertThat(pixels.includes(0, 0)).isFalse();
        assertThat(pixels.includes(7, 0)).isFalse();
        assertThat(pixels.includes(7, 7)).isFalse();
        assertThat(pixels.includes(0, 7)).isTrue();
    }

    @Test
    void of_givenALampBeforeTheWall_leavesOutWhereItIsSeen() {
        DiffusePixels pixels = DiffusePixels.of(scene().object("wall", rectangle(-9, -9, 9, 9, 0), MATT)
                .light(new SphereLight(new Vector3(-2, 2, 2), 1.2, Color.WHITE, new Falloff.InverseSquare(), 1))
                .build());
        assertThat(pixels.includes(1, 1)).isFalse();
        assertThat(pixels.includes(6, 6)).isTrue();
    }
}
