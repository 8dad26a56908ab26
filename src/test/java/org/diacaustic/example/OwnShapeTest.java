package org.diacaustic.example;

import static org.assertj.core.api.Assertions.assertThat;

import org.diacaustic.image.LinearImage;
import org.diacaustic.light.PointLight;
import org.diacaustic.material.Material;
import org.diacaustic.material.Medium;
import org.diacaustic.math.Color;
import org.diacaustic.math.Vector3;
import org.diacaustic.render.Renderer;
import org.diacaustic.render.Rendering;
import org.diacaustic.scene.Camera;
import org.diacaustic.scene.Scene;
import org.diacaustic.scene.Settings;
import org.diacaustic.shape.Plane;
import org.junit.jupiter.api.Test;

/** The main path of the library, with a shape that Diacaustic does not know. The README shows the same lines. */
class OwnShapeTest {

    @Test
    void render_givenAShapeOfOnesOwn_showsItWithItsShadow() {
        Scene scene = Scene.builder()
                .camera(Camera.builder()
                        .from(new Vector3(0, -6, 1.5))
                        .to(Vector3.ZERO)
                        .up(Vector3.UNIT_Z)
                        .size(60, 60)
                        .build())
                .light(new PointLight(new Vector3(0, -3, 6), Color.grey(200)))
                .object("heart", new Heart(), matt(0.8, 0.1, 0.1))
                .object("floor", new Plane(new Vector3(0, 0, -1.3), Vector3.UNIT_Z), matt(0.6, 0.6, 0.6))
                .build();
        Rendering rendering = Renderer.render(scene, Settings.physical());
        LinearImage image = rendering.image();

        Color heart = image.get(30, 28);
        assertThat(heart.red()).isGreaterThan(4 * heart.green());
        Color besideIt = image.get(5, 40);
        Color shadow = image.get(30, 45);
        assertThat(besideIt.red()).isEqualTo(besideIt.green()).isGreaterThan(10 * shadow.green());
        assertThat(rendering.counters().nonFiniteSamples()).isZero();
    }

    @Test
    void render_givenAGlassShapeOfOnesOwn_showsWhatLiesBehindIt() {
        Material glass = Material.builder()
                .transparency(Color.WHITE)
                .inside(Medium.of(1.5))
                .build();
        Scene scene = Scene.builder()
                .camera(Camera.builder()
                        .from(new Vector3(0, -6, 0))
                        .to(Vector3.ZERO)
                        .up(Vector3.UNIT_Z)
                        .size(21, 21)
                        .build())
                .object("heart", new Heart(), glass)
                .background(Color.WHITE)
                .build();
        LinearImage image = Renderer.render(
                        scene,
                        Settings.physical().toBuilder()
                                .minimumThroughput(1e-9)
                                .maxDepth(60)
                                .build())
                .image();

        // Whatever way light goes through clear glass, radiance 1 from everywhere is radiance 1.
        assertThat(image.get(10, 10).green()).isCloseTo(1, org.assertj.core.data.Offset.offset(1e-5));
    }

    private static Material matt(double red, double green, double blue) {
        return Material.builder().diffuse(new Color(red, green, blue)).build();
    }
}
