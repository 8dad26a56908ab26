package org.diacaustic.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.diacaustic.render.Eye.clear;
import static org.diacaustic.render.Eye.matt;
import static org.diacaustic.render.Eye.mirror;
import static org.diacaustic.render.Eye.v;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import org.diacaustic.light.Falloff;
import org.diacaustic.light.PointLight;
import org.diacaustic.math.Color;
import org.diacaustic.math.Vector3;
import org.diacaustic.parallel.StopSignal;
import org.diacaustic.scene.Camera;
import org.diacaustic.scene.Scene;
import org.diacaustic.scene.Settings;
import org.diacaustic.shape.ConvexPolygon;
import org.diacaustic.shape.MeshData;
import org.diacaustic.shape.Shape;
import org.diacaustic.shape.Sphere;
import org.diacaustic.shape.TriangleMesh;
import org.junit.jupiter.api.Test;

/** After the first rays, which grow what must grow, an eye ray allocates nothing. */
class AllocationTest {
    private static final int SIZE = 100;

    private final StopSignal stop = new StopSignal();
    private final ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();

    @Test
    void trace_givenSpheres_allocatesNothing() {
        Scene.Builder scene = Scene.builder();
        for (int i = 0; i < 9; i++) {
            add(scene, i, new Sphere(v(i % 3 - 1, 0.6, i / 3 - 1), 0.45));
        }
        assertAllocatesNothing(scene);
    }

    @Test
    void trace_givenPolygons_allocatesNothing() {
        Scene.Builder scene = Scene.builder();
        for (int i = 0; i < 9; i++) {
            double x = i % 3 - 1;
            double z = i / 3 - 1;
            add(
                    scene,
                    i,
                    ConvexPolygon.twoSided(
                            v(x, 0.2, z), v(x + 0.7, 0.4, z), v(x + 0.7, 0.9, z + 0.7), v(x, 0.7, z + 0.7)));
        }
        assertAllocatesNothing(scene);
    }

    @Test
    void trace_givenMeshes_allocatesNothing() {
        Scene.Builder scene = Scene.builder();
        for (int i = 0; i < 9; i++) {
            double x = i % 3 - 1;
            double z = i / 3 - 1;
            double[] vertices = {x, 0.1, z, x + 0.7, 0.1, z, x, 0.1, z + 0.7, x + 0.2, 0.9, z + 0.2};
            MeshData data = new MeshData(vertices, new int[] {0, 1, 2, 0, 3, 1, 1, 3, 2, 2, 3, 0}, null, null);
            add(scene, i, new TriangleMesh(data, i % 2 == 0));
        }
        assertAllocatesNothing(scene);
    }

    private static void add(Scene.Builder scene, int i, Shape shape) {
        scene.object("object " + i, shape, (i % 3 == 0 ? clear(1.5) : i % 3 == 1 ? mirror(0.5) : matt(0.5)).build());
    }

    private void assertAllocatesNothing(Scene.Builder builder) {
        ConvexPolygon floor = ConvexPolygon.twoSided(v(-9, 0, -9), v(-9, 0, 9), v(9, 0, 9), v(9, 0, -9));
        Scene scene = builder.camera(Camera.builder()
                        .from(v(1, 4, 6))
                        .to(Vector3.ZERO)
                        .size(SIZE, SIZE)
                        .build())
                .object("floor", floor, matt(0.5).build())
                .light(new PointLight(v(2, 6, 3), Color.WHITE, new Falloff.InverseSquare(), 20))
                .background(Color.WHITE)
                .build();
        EyeTracer tracer = new EyeTracer(RenderPlan.of(scene, Settings.physical()), Illumination.NONE, false);
        double warm = traceAll(tracer, scene.camera());
        long least = Long.MAX_VALUE;
        // The machine itself now and then allocates an object on our thread, when it compiles anew; it does not always.
        for (int i = 0; i < 3; i++) {
            long before = threads.getCurrentThreadAllocatedBytes();
            double again = traceAll(tracer, scene.camera());
            least = Math.min(least, threads.getCurrentThreadAllocatedBytes() - before);
            assertThat(again).isEqualTo(warm).isPositive();
        }

        assertThat(tracer.counters().refractionRays()).isPositive();
        assertThat(least).isZero();
    }

    private double traceAll(EyeTracer tracer, Camera camera) {
        double sum = 0;
        for (int y = 0; y < SIZE; y++) {
            for (int x = 0; x < SIZE; x++) {
                tracer.random().start(1, 0, (long) y * SIZE + x);
                camera.aim(x + 0.5, y + 0.5, 0, 0, tracer.ray());
                sum += tracer.trace(stop).green;
            }
        }
        return sum;
    }
}
