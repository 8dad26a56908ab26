package org.diacaustic.preprocess;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import org.diacaustic.map.AmbientMaps;
import org.diacaustic.material.Material;
import org.diacaustic.math.Color;
import org.diacaustic.math.Vector3;
import org.diacaustic.scene.Camera;
import org.diacaustic.scene.SceneIndex;
import org.diacaustic.scene.SceneObject;
import org.diacaustic.shape.ConvexPolygon;
import org.diacaustic.shape.Plane;
import org.diacaustic.shape.Shape;
import org.diacaustic.shape.Sphere;
import org.junit.jupiter.api.Test;

class CameraSizingTest {
    private static final long PLENTY = 1L << 40;
    private static final Material MATT =
            Material.builder().diffuse(Color.grey(0.5)).build();
    private static final Material CLEAR =
            Material.builder().transparency(Color.grey(0.9)).build();

    private static Vector3 v(double x, double y, double z) {
        return new Vector3(x, y, z);
    }

    /** 10 × 6, at the height y. */
    private static Shape floor(double y) {
        return ConvexPolygon.twoSided(v(-5, y, 3), v(5, y, 3), v(5, y, -3), v(-5, y, -3));
    }

    private static SceneIndex scene(Shape shape, Material material, Object... more) {
        List<SceneObject> objects = new ArrayList<>();
        objects.add(new SceneObject("first", shape, material));
        for (int i = 0; i < more.length; i += 2) {
            objects.add(new SceneObject("more", (Shape) more[i], (Material) more[i + 1]));
        }
        return SceneIndex.of(objects, false);
    }

    /** Straight down from a height of 5 with 90° over the picture's height: a pixel covers 10/pixels of the ground. */
    private static Camera above(int pixels) {
        return Camera.builder()
                .from(v(0, 5, 0))
                .to(Vector3.ZERO)
                .up(v(0, 0, -1))
                .fieldOfView(90)
                .size(pixels, pixels)
                .build();
    }

    @Test
    void of_givenAFloorFromAbove_makesTexelsOfPixels() {
        // 10 × 6 units at 20 pixels a unit: 200 × 120.
        ChartSize size = CameraSizing.of(scene(floor(0), MATT), above(200), PLENTY, PLENTY)
                .of(0);
        assertThat(size.columns()).isBetween(198, 202);
        assertThat(size.rows()).isBetween(118, 122);
    }

    @Test
    void of_givenAFloorUnderGlass_looksThrough() {
        SceneIndex scene = scene(floor(0), MATT, floor(2), CLEAR);
        ChartSize size = CameraSizing.of(scene, above(200), PLENTY, PLENTY).of(0);
        assertThat(size.columns()).isBetween(198, 202);
    }

    @Test
    void of_givenASphereFromAbove_makesTexelsOfPixelsWhereItIsNearest() {
        // Radius 2 at the origin, seen at a distance of 3: a pixel covers 2·3/400 of the top; a row π·2/rows.
        ChartSize size = CameraSizing.of(scene(new Sphere(Vector3.ZERO, 2), MATT), above(400), PLENTY, PLENTY)
                .of(0);
        assertThat((double) size.rows()).isBetween(0.5 * Math.PI * 2 / (6.0 / 400), 1.1 * Math.PI * 2 / (6.0 / 400));
    }

    @Test
    void of_givenFewPhotons_makesAllMapsCoarserAlike() {
        SceneIndex scene = scene(floor(0), MATT);
        ChartSize size = CameraSizing.of(scene, above(200), 4 * 6000, PLENTY).of(0);
        // 200 × 120 = 24,000 texels wanted, 6,000 allowed: half of each side.
        assertThat(size.columns() * size.rows()).isBetween(5_000, 6_000);
        assertThat(size.columns()).isBetween(94, 102);
    }

    @Test
    void of_givenLittleMemory_staysWithinIt() {
        SceneIndex scene = scene(floor(0), MATT, new Sphere(v(0, 1, 0), 1), MATT);
        long bytes = 100_000;
        CameraSizing sizing = CameraSizing.of(scene, above(200), PLENTY, bytes);
        long texels = 0;
        for (int i = 0; i < 2; i++) {
            texels += (long) sizing.of(i).columns() * sizing.of(i).rows();
        }
        assertThat(texels * AmbientMaps.BYTES_PER_TEXEL).isBetween(bytes * 8 / 10, bytes);
    }

    @Test
    void of_givenNothingToSpend_givesTheLeastSize() {
        CameraSizing sizing = CameraSizing.of(scene(floor(0), MATT), above(200), 0, 0);
        assertThat(sizing.of(0)).isEqualTo(new ChartSize(CameraSizing.LEAST, CameraSizing.LEAST));
    }

    @Test
    void of_givenWhatTheCameraDoesNotSee_givesTheLeastSize() {
        SceneIndex scene = scene(floor(0), MATT, floor(-1), MATT);
        assertThat(CameraSizing.of(scene, above(200), PLENTY, PLENTY).of(1))
                .isEqualTo(new ChartSize(CameraSizing.LEAST, CameraSizing.LEAST));
    }

    @Test
    void of_givenAPlane_refuses() {
        SceneIndex scene = scene(new Plane(Vector3.ZERO, Vector3.UNIT_Y), MATT);
        assertThatThrownBy(() -> CameraSizing.of(scene, above(200), PLENTY, PLENTY))
                .isInstanceOf(ForwardPlanException.class);
    }
}
