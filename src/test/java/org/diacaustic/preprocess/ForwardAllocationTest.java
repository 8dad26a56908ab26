package org.diacaustic.preprocess;

import static org.assertj.core.api.Assertions.assertThat;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import org.diacaustic.light.LightPoint;
import org.diacaustic.light.PointLight;
import org.diacaustic.math.Color;
import org.diacaustic.math.SampleStream;
import org.diacaustic.math.Vector3;
import org.diacaustic.parallel.Workers;
import org.diacaustic.scene.Settings;
import org.junit.jupiter.api.Test;

class ForwardAllocationTest {
    private static final int RAYS = 4000;
    private static final int STRETCH = 500;

    /** Following a light ray over a glass ball, with its branches, allocates nothing once the arrays have grown. */
    @Test
    void shoot_givenWarmTask_allocatesNothing() {
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        ForwardPlan plan = Forward.plan(
                Forward.ballsOverFloor(new PointLight(new Vector3(0, 7, 0), Color.WHITE)),
                Settings.physical(),
                "random",
                1);
        long[] before = {0};
        long[] least = {Long.MAX_VALUE};
        int[] found = {0};
        PreProcessor measuring = new PreProcessor() {
            @Override
            public String name() {
                return "measuring";
            }

            // One task follows them all. The machine itself now and then allocates on our thread, when it compiles
            // anew.
            @Override
            public void run(Beam beam, ForwardPass pass) {
                LightPoint lamp = new LightPoint();
                beam.light().emitFrom(0.5, 0.5, lamp);
                EmissionChart chart = beam.planeChart(lamp);
                pass.shootRays(RAYS, (number, emitter) -> {
                    if (number % STRETCH == 0) {
                        before[0] = threads.getCurrentThreadAllocatedBytes();
                    }
                    SampleStream random = emitter.random(number);
                    chart.aim(random.nextDouble(), random.nextDouble(), emitter.ray());
                    found[0] += emitter.probe();
                    if (number % STRETCH == STRETCH - 1) {
                        least[0] = Math.min(least[0], threads.getCurrentThreadAllocatedBytes() - before[0]);
                    }
                });
            }
        };
        ForwardPlan measured = new ForwardPlan(
                plan.index(),
                plan.rules(),
                plan.rouletteThroughput(),
                measuring,
                plan.beams(),
                plan.isWeighted(),
                plan.seed(),
                plan.origin(),
                plan.extent(),
                plan.powerUnit(),
                plan.capacity(),
                plan.map(),
                plan.estimator(),
                plan.passes(),
                plan.maps());
        new ForwardPass(measured, 0, new Workers(1)).run();
        assertThat(found[0]).isGreaterThan(RAYS / 4);
        assertThat(least[0]).isZero();
    }
}
