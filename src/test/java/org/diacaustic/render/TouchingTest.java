package org.diacaustic.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.diacaustic.image.ImageMetrics;
import org.diacaustic.image.LinearImage;
import org.diacaustic.light.DirectionalLight;
import org.diacaustic.material.Material;
import org.diacaustic.material.Medium;
import org.diacaustic.math.Color;
import org.diacaustic.math.Transform;
import org.diacaustic.math.Vector3;
import org.diacaustic.scene.Camera;
import org.diacaustic.scene.Scene;
import org.diacaustic.scene.SceneObject;
import org.diacaustic.scene.Settings;
import org.diacaustic.shape.Box;
import org.diacaustic.shape.MeshData;
import org.diacaustic.shape.Plane;
import org.diacaustic.shape.Sphere;
import org.diacaustic.shape.Transformed;
import org.diacaustic.shape.TriangleMesh;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Surfaces that touch: there is a gap without width between them, whatever rounding and the order of the file say. */
class TouchingTest {
    private static final Material MATT =
            Material.builder().diffuse(Color.grey(0.8)).build();

    @Test
    void render_givenGlassOnAFloor_isTheSameInAnyOrder() {
        SceneObject floor = new SceneObject("floor", new Plane(Vector3.ZERO, Vector3.UNIT_Y), MATT);
        SceneObject glass = glass(new Box(new Vector3(-0.7, 0, -0.7), new Vector3(0.7, 1, 0.7)), 1.5);
        SceneObject water = glass(new Box(new Vector3(-0.7, 1, -0.7), new Vector3(0.7, 1.4, 0.7)), 1.33);
        List<SceneObject> objects = new ArrayList<>(List.of(floor, glass, water));

        LinearImage reference = render(objects);
        for (int i = 0; i < 3; i++) {
            Collections.rotate(objects, 1);
            ImageMetrics metrics = ImageMetrics.of(render(objects), reference);
            // In a few pixels light is trapped so long that rounding grows; without the gap a tenth of the light
            // differs.
            assertThat(metrics.relativeMeanAbsoluteError()).isLessThan(1e-4);
        }
    }

    @Test
    void render_givenTurnedGlassOnAFloor_showsTheFloorThroughItsTop() {
        Transform turned = Transform.identity().rotate(Vector3.UNIT_Y, 33);
        SceneObject block =
                glass(new Transformed(new Box(new Vector3(-0.7, 0, -0.7), new Vector3(0.7, 1, 0.7)), turned), 1.5);
        SceneObject floor = new SceneObject("floor", new Plane(Vector3.ZERO, Vector3.UNIT_Y), MATT);
        for (List<SceneObject> objects : List.of(List.of(floor, block), List.of(block, floor))) {
            // Straight down: 0.8 of the light comes back, through two interfaces of transmittance 0.96 each way, and
            // the black sky is mirrored.
            Camera down = Camera.builder()
                    .from(new Vector3(0.1, 9, 0.05))
                    .to(new Vector3(0.1, 0, 0.05))
                    .up(Vector3.UNIT_X)
                    .size(1, 1)
                    .build();
            Scene scene = new Scene(
                    down,
                    List.of(new DirectionalLight(new Vector3(0, -1, 0), Color.grey(Math.PI), 0)),
                    objects,
                    Color.BLACK);
            Settings settings = Eye.withoutMap(Settings.physical().toBuilder())
                    .minimumThroughput(1e-9)
                    .build();
            double direct = 0.8 * Math.pow(0.96, 4);
            double seen = Renderer.render(scene, settings).image().get(0, 0).green();
            // Between the floor and the two faces light goes to and fro only along mirrored ways, which add 0.04²
            // twice.
            assertThat(seen).isCloseTo(direct, within(0.003 * direct)).isGreaterThanOrEqualTo(direct * (1 - 1e-6));
        }
    }

    @Test
    void trace_givenTouchingSpheres_passesFourInterfaces() {
        // NEST-07: 0.96⁴ with the gap kept, in either order of the list.
        for (double first : new double[] {-1, 1}) {
            Scene scene = new Scene(
                    Camera.builder()
                            .from(new Vector3(-7, 0, 0))
                            .to(Vector3.ZERO)
                            .size(1, 1)
                            .build(),
                    List.of(),
                    List.of(
                            glass(new Sphere(new Vector3(first, 0, 0), 1), 1.5),
                            glass(new Sphere(new Vector3(-first, 0, 0), 1), 1.5)),
                    Color.WHITE);
            // What is mirrored is cut off: 0.04 is less than the least throughput, 0.96⁴ is not.
            Settings settings = Eye.withoutMap(Settings.physical().toBuilder())
                    .minimumThroughput(0.05)
                    .scaleRadiance(true)
                    .build();
            assertThat(Renderer.render(scene, settings).image().get(0, 0).green())
                    .isEqualTo((float) 0.84934656);
        }
    }

    /** Used to go to and fro between the two faces for ever. */
    @Test
    @Timeout(20)
    void render_givenObjectsThatShareAFaceInsideAnother_ends() {
        Transform turned = Transform.identity().rotate(Vector3.UNIT_Y, 37);
        Material dominating = Material.builder()
                .transparency(Color.WHITE)
                .inside(new Medium(1.5, Color.BLACK, 5))
                .build();
        render(List.of(
                new SceneObject("ball", new Sphere(Vector3.ZERO, 1), dominating),
                glass(
                        new Transformed(new Box(new Vector3(-0.4, -0.4, -0.4), new Vector3(0.1, 0.4, 0.4)), turned),
                        1.33),
                glass(
                        new Transformed(new Box(new Vector3(0.1, -0.4, -0.4), new Vector3(0.5, 0.4, 0.4)), turned),
                        1.33)));
    }

    /** Used to gather crossings until the memory was full. */
    @Test
    @Timeout(20)
    void render_givenEveryTriangleTwiceWithOppositeWinding_ends() {
        double[] corners = {-1, 1, -1, 1, 1, -1, 1, 1, 1, -1, 1, 1};
        TriangleMesh twice = new TriangleMesh(
                new MeshData(corners, new int[] {0, 2, 1, 0, 3, 2, 0, 1, 2, 0, 2, 3}, null, null), true);
        render(List.of(new SceneObject("floor", new Plane(Vector3.ZERO, Vector3.UNIT_Y), MATT), glass(twice, 1.33)));
    }

    private static SceneObject glass(org.diacaustic.shape.Shape shape, double index) {
        Material material = Material.builder()
                .transparency(Color.WHITE)
                .inside(Medium.of(index))
                .build();
        return new SceneObject("glass " + shape, shape, material);
    }

    private static LinearImage render(List<SceneObject> objects) {
        Camera camera = Camera.builder()
                .from(new Vector3(2.5, 2.2, 4))
                .to(new Vector3(0, 0.5, 0))
                .fieldOfView(34)
                .size(48, 36)
                .build();
        Scene scene = new Scene(
                camera,
                List.of(new DirectionalLight(new Vector3(0.4, -1, -0.3), Color.grey(3), 0)),
                objects,
                new Color(0.6, 0.7, 0.8));
        Settings settings = Eye.withoutMap(Settings.physical().toBuilder())
                .minimumThroughput(1e-9)
                .maxDepth(60)
                .build();
        return Renderer.render(scene, settings).image();
    }
}
