package org.diacaustic.example;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.diacaustic.image.LinearImage;
import org.diacaustic.light.PointLight;
import org.diacaustic.material.Material;
import org.diacaustic.material.Medium;
import org.diacaustic.math.Color;
import org.diacaustic.math.Vector3;
import org.diacaustic.preprocess.Beam;
import org.diacaustic.preprocess.EmissionChart;
import org.diacaustic.preprocess.ForwardPass;
import org.diacaustic.preprocess.PreProcessor;
import org.diacaustic.render.RenderJob;
import org.diacaustic.render.RenderPlan;
import org.diacaustic.scene.Camera;
import org.diacaustic.scene.EstimatorName;
import org.diacaustic.scene.ForwardSettings;
import org.diacaustic.scene.MapSettings;
import org.diacaustic.scene.Scene;
import org.diacaustic.scene.Settings;
import org.diacaustic.shape.Plane;
import org.diacaustic.shape.Sphere;
import org.junit.jupiter.api.Test;

/** Light rays chosen by a pre-processor that Diacaustic does not know. */
class OwnPreProcessorTest {
    /** The points of a golden spiral in the unit square: evenly spread for any number of rays. */
    private static final class Spiral implements PreProcessor {
        private static final double GOLDEN = 0.618033988749894848;

        @Override
        public String name() {
            return "spiral";
        }

        @Override
        public void run(Beam beam, ForwardPass pass) {
            pass.shootRays(beam.rays(), (ray, emitter) -> {
                EmissionChart chart = beam.uniformChart(emitter.point(0.5, 0.5));
                chart.aim((ray + 0.5) / beam.rays(), ray * GOLDEN % 1, emitter.ray());
                emitter.shoot(1.0 / beam.rays());
            });
        }
    }

    @Test
    void render_givenAPreProcessorOfOnesOwn_showsTheSameCausticAsOurs() {
        LinearImage own = rendered("spiral", List.of(new Spiral()));
        LinearImage ours = rendered("cube", List.of());
        LinearImage without = rendered("none", List.of());
        assertThat(mean(ours)).isGreaterThan(1.02 * mean(without));
        double caustic = mean(ours) - mean(without);
        assertThat(mean(own) - mean(without)).isCloseTo(caustic, within(0.02 * caustic));
    }

    private static double mean(LinearImage image) {
        double sum = 0;
        for (float sample : image.samples()) {
            sum += sample;
        }
        return sum / image.samples().length;
    }

    private static LinearImage rendered(String preProcessor, List<PreProcessor> additional) {
        Scene scene = Scene.builder()
                .camera(Camera.builder()
                        .from(new Vector3(5, 4, 0))
                        .to(Vector3.ZERO)
                        .size(31, 31)
                        .build())
                .light(new PointLight(new Vector3(0, 8, 0), Color.grey(100)))
                .object("floor", new Plane(Vector3.ZERO, Vector3.UNIT_Y), matt())
                .object("ball", new Sphere(new Vector3(0, 2.2, 0), 1), glass())
                .build();
        Settings settings = Settings.physical().toBuilder()
                .shader("non-transparent")
                // On the axis light is gathered to a point: how bright that is, is a matter of the reach.
                .maps(MapSettings.builder()
                        .estimator(EstimatorName.DENSITY)
                        .gatherRadius(0.2)
                        .build())
                .forward(ForwardSettings.builder()
                        .preProcessor(preProcessor)
                        .rays(60_000)
                        .build())
                .build();
        return new RenderJob(RenderPlan.of(scene, settings, List.of(), additional))
                .run()
                .image();
    }

    private static Material matt() {
        return Material.builder().diffuse(Color.grey(0.8)).build();
    }

    private static Material glass() {
        return Material.builder()
                .transparency(Color.WHITE)
                .inside(Medium.of(1.5))
                .build();
    }
}
