package org.diacaustic.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.diacaustic.render.Eye.v;

import org.diacaustic.light.Falloff;
import org.diacaustic.light.Light;
import org.diacaustic.light.LightSample;
import org.diacaustic.light.PointLight;
import org.diacaustic.material.BumpMap;
import org.diacaustic.material.ConstantTexture;
import org.diacaustic.material.Material;
import org.diacaustic.material.Texture;
import org.diacaustic.math.Color;
import org.diacaustic.math.Rgb;
import org.diacaustic.math.Vector3;
import org.diacaustic.scene.Camera;
import org.diacaustic.scene.Scene;
import org.diacaustic.scene.Settings;
import org.diacaustic.shape.Box;
import org.diacaustic.shape.Hit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** What is not a number is never in a pixel, always counted, and its first place is told. */
@Timeout(20)
class NonFiniteTest {
    private static final Texture WHITE = new ConstantTexture(Color.WHITE);

    /** Not a number where x is positive: in the right half of the picture. */
    private static final Texture BROKEN = new Texture() {
        @Override
        public void evaluate(Hit hit, Rgb color) {
            double value = hit.x > 0 ? Double.NaN : 0.5;
            color.set(value, value, value);
        }
    };

    @Test
    void render_givenTextureThatIsNotANumber_leavesItOutAndTellsWhere() {
        assertRightHalfReported(Material.builder().diffuse(BROKEN));
        assertRightHalfReported(Material.builder().diffuse(WHITE).ambient(BROKEN));
        assertRightHalfReported(Material.builder().reflectivity(BROKEN));
        assertRightHalfReported(Material.builder().transparency(BROKEN));
    }

    @Test
    void render_givenBumpThatIsNotANumber_leavesItOutAndTellsWhere() {
        BumpMap broken = (hit, gradient) -> gradient.add(hit.x > 0 ? Double.NaN : 0, 0, 0);
        assertRightHalfReported(Material.builder().diffuse(WHITE).bump(broken));
        assertRightHalfReported(Material.builder().reflectivity(WHITE).bump(broken));
        assertRightHalfReported(Eye.clear(1.5).bump(broken));
    }

    @Test
    void render_givenLightThatIsNotANumber_leavesItOutAndTellsWhere() {
        Light broken = new Light() {
            @Override
            public boolean sample(double x, double y, double z, double s, double t, LightSample sample) {
                sample.directionX = 0;
                sample.directionY = 0;
                sample.directionZ = 1;
                sample.distance = 5;
                sample.irradiance.set(x > 0 ? Double.NaN : 1, 1, 1);
                return true;
            }
        };
        assertRightHalfReported(Material.builder().diffuse(WHITE), broken);
        Light astray = new Light() {
            @Override
            public boolean sample(double x, double y, double z, double s, double t, LightSample sample) {
                broken.sample(0, y, z, s, t, sample);
                sample.directionZ = x > 0 ? Double.NaN : 1;
                return true;
            }
        };
        assertRightHalfReported(Material.builder().diffuse(WHITE), astray);
    }

    private static void assertRightHalfReported(Material.Builder material) {
        assertRightHalfReported(material, new PointLight(v(0, 1, 9), Color.WHITE, new Falloff.None(), 5));
    }

    /** Renders the front of a box that fills the picture, 8 × 4 pixels: pixel (4, 0) is the first to the right. */
    private static void assertRightHalfReported(Material.Builder material, Light light) {
        Scene scene = Scene.builder()
                .camera(Camera.builder()
                        .from(v(0, 0, 9))
                        .to(Vector3.ZERO)
                        .fieldOfView(2)
                        .size(8, 4)
                        .build())
                .light(light)
                .object("box", new Box(v(-9, -9, -9), v(9, 9, 0)), material.build())
                .build();
        Rendering rendering = Renderer.render(scene, Settings.physical());

        for (float sample : rendering.image().samples()) {
            assertThat(Float.isFinite(sample)).isTrue();
        }
        assertThat(rendering.counters().nonFiniteSamples()).isEqualTo(16);
        assertThat(rendering.nonFiniteReport())
                .hasValueSatisfying(
                        report -> assertThat(report).startsWith("16 samples").endsWith("pixel 4, 0"));
    }
}
