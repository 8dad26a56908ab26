package org.diacaustic.preprocess;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.diacaustic.light.DirectionalLight;
import org.diacaustic.light.Falloff;
import org.diacaustic.light.Light;
import org.diacaustic.light.LightPoint;
import org.diacaustic.math.Color;
import org.diacaustic.math.Vector3;
import org.diacaustic.scene.Scene;
import org.diacaustic.shape.Box;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class EmissionChartTest {
    private static final int STEPS = 400;

    private static Beam beam(Light light, Vector3 low, Vector3 high, boolean aims) {
        Scene scene = Scene.builder()
                .camera(Forward.camera())
                .light(light)
                .object("box", new Box(low, high), Forward.clear(1.5, 1))
                .build();
        return Forward.plan(scene, Forward.settings(s -> s.aimAtSpecular(aims)), "random", 1000)
                .beams()
                .get(0);
    }

    private static LightPoint middle(Beam beam) {
        LightPoint from = new LightPoint();
        beam.light().emitFrom(0.5, 0.5, from);
        return from;
    }

    private static double total(List<EmissionChart> charts) {
        LightRay ray = new LightRay();
        double sum = 0;
        for (EmissionChart chart : charts) {
            for (int i = 0; i < STEPS * STEPS; i++) {
                chart.aim((i % STEPS + 0.5) / STEPS, (i / STEPS + 0.5) / STEPS, ray);
                sum += ray.measure / (STEPS * STEPS);
                assertThat(ray.directionX * ray.directionX
                                + ray.directionY * ray.directionY
                                + ray.directionZ * ray.directionZ)
                        .isCloseTo(1, within(1e-12));
            }
        }
        return sum;
    }

    /** All directions are 4π sr. */
    @Test
    void charts_givenWholeSphere_coverFourPi() {
        Beam inside = beam(Forward.lamp(Vector3.ZERO, new Falloff.None()), v(-1, -1, -1), v(1, 1, 1), true);
        assertThat(total(List.of(inside.uniformChart(middle(inside))))).isCloseTo(4 * Math.PI, within(1e-9));
        assertThat(total(inside.cubeCharts(middle(inside)))).isCloseTo(4 * Math.PI, within(1e-4));
    }

    /** A square of half side 1 at distance 1 is a face of the cube around the lamp: 4π/6 sr. */
    @Test
    void planeChart_givenFaceOfACube_coversASixth() {
        Beam beam = beam(Forward.lamp(v(0, 3, 0), new Falloff.None()), v(-1, 1, -1), v(1, 2, 1), true);
        assertThat(total(List.of(beam.planeChart(middle(beam))))).isCloseTo(4 * Math.PI / 6, within(1e-4));
        Beam whole = beam(Forward.lamp(v(0, 3, 0), new Falloff.None()), v(-1, 1, -1), v(1, 2, 1), false);
        assertThat(total(List.of(whole.planeChart(middle(whole))))).isCloseTo(4 * Math.PI / 6, within(1e-4));
    }

    /** Whatever the box, the cube's parts hold every direction to it: a ray to any of its points is in one chart. */
    @ParameterizedTest
    @CsvSource({"0,3,0", "5,1,0.5", "1.5,2.1,1.2", "-1.01,0.3,0.2", "30,-20,4"})
    void cubeCharts_givenBox_coverWhatTheLightSees(double x, double y, double z) {
        Beam beam = beam(Forward.lamp(v(x, y, z), new Falloff.None()), v(-1, -1, -1), v(1, 2, 1), true);
        List<EmissionChart> charts = beam.cubeCharts(middle(beam));
        LightRay ray = new LightRay();
        int hits = 0;
        double seen = 0;
        Box box = new Box(v(-1, -1, -1), v(1, 2, 1));
        for (EmissionChart chart : charts) {
            for (int i = 0; i < STEPS * STEPS; i++) {
                chart.aim((i % STEPS + 0.5) / STEPS, (i / STEPS + 0.5) / STEPS, ray);
                seen += hits(box, ray) ? ray.measure / (STEPS * STEPS) : 0;
            }
        }
        EmissionChart all = beam(Forward.lamp(v(x, y, z), new Falloff.None()), v(-1, -1, -1), v(1, 2, 1), false)
                .uniformChart(middle(beam));
        int steps = 1500;
        for (int i = 0; i < steps * steps; i++) {
            all.aim((i % steps + 0.5) / steps, (i / steps + 0.5) / steps, ray);
            hits += hits(box, ray) ? 1 : 0;
        }
        assertThat(seen).isCloseTo(4 * Math.PI * hits / steps / steps, within(0.01 * seen));
    }

    private static boolean hits(Box box, LightRay from) {
        org.diacaustic.math.Ray ray = new org.diacaustic.math.Ray();
        ray.set(from.originX, from.originY, from.originZ, from.directionX, from.directionY, from.directionZ);
        return box.intersect(ray);
    }

    /** Along an axis the box shows 2 × 3; parallel rays start before it. */
    @Test
    void parallelChart_givenAxis_coversTheFace() {
        Light sun = new DirectionalLight(v(0, 0, 1), Color.WHITE, 0);
        Beam beam = beam(sun, v(-1, -1, -1), v(1, 2, 1), true);
        assertThat(total(List.of(beam.uniformChart(middle(beam))))).isCloseTo(6, within(1e-9));
        LightRay ray = new LightRay();
        beam.uniformChart(middle(beam)).aim(0.5, 0.5, ray);
        assertThat(ray.originZ).isLessThan(-1);
        assertThat(ray.originY).isCloseTo(0.5, within(1e-12));
    }

    @Test
    void planeRefusal_givenLightInside_saysSo() {
        Beam beam = beam(Forward.lamp(Vector3.ZERO, new Falloff.None()), v(-1, -1, -1), v(1, 2, 1), true);
        assertThat(beam.planeRefusal(middle(beam)))
                .hasValueSatisfying(reason -> assertThat(reason).contains("'box'"));
    }

    private static Vector3 v(double x, double y, double z) {
        return new Vector3(x, y, z);
    }
}
