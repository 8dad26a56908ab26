package org.diacaustic.render;

import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.diacaustic.math.Rgb;
import org.diacaustic.parallel.StopSignal;
import org.diacaustic.scene.Camera;
import org.diacaustic.scene.Scene;
import org.diacaustic.scene.SceneObject;
import org.diacaustic.scenefile.MeshFile;
import org.diacaustic.scenefile.Problems;
import org.diacaustic.scenefile.SceneFile;
import org.diacaustic.scenefile.SceneReader;
import org.diacaustic.shape.MeshData;
import org.diacaustic.shape.Shape;
import org.diacaustic.shape.Sphere;
import org.diacaustic.shape.TextbookMesh;
import org.diacaustic.shape.TextbookSphere;
import org.diacaustic.shape.TriangleMesh;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;

/**
 * What care costs a whole picture: all eye rays of a glass of water, whose mesh and sphere are met by the tests that renders use
 * or by those of textbooks. Those lose a fifth of the refracted rays, which leak or are taken to be where they start, so the two do
 * not do the same work. Run it from the project's folder, where the scenes are.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.Throughput)
@OutputTimeUnit(TimeUnit.SECONDS)
public class RobustnessRenderBenchmark {
    private static final int PIXELS = 480 * 480;

    @Param({"robust", "textbook"})
    public String form;

    private final StopSignal never = new StopSignal();
    private EyeTracer tracer;
    private Camera camera;

    @Setup
    public void plan() {
        Problems problems = new Problems();
        SceneFile file = SceneReader.read(Path.of("scenes", "glass-of-water.yaml"), problems)
                .orElseThrow(() -> new IllegalStateException(problems.toString()));
        MeshData tumbler = MeshFile.read(Path.of("scenes", "tumbler.obj"), problems)
                .orElseThrow(() -> new IllegalStateException(problems.toString()));
        Scene scene = file.scene();
        List<SceneObject> objects = scene.objects().stream()
                .map(object -> new SceneObject(
                        object.name(),
                        form.equals("textbook") ? textbook(object.shape(), tumbler) : object.shape(),
                        object.material()))
                .toList();
        camera = scene.camera();
        tracer = new EyeTracer(
                RenderPlan.of(new Scene(camera, scene.lights(), objects, scene.background()), file.settings()),
                Illumination.NONE);
    }

    private static Shape textbook(Shape shape, MeshData tumbler) {
        if (shape instanceof Sphere sphere) {
            return new TextbookSphere(sphere);
        }
        return shape instanceof TriangleMesh mesh ? new TextbookMesh(tumbler, mesh) : shape;
    }

    @Benchmark
    @OperationsPerInvocation(PIXELS)
    public double picture() {
        double sum = 0;
        for (int pixel = 0; pixel < PIXELS; pixel++) {
            tracer.random().start(1, 0, pixel);
            camera.aim(pixel % 480 + 0.5, pixel / 480 + 0.5, 0.5, 0.5, tracer.ray());
            Rgb radiance = tracer.trace(never);
            sum += radiance.green;
        }
        return sum;
    }
}
