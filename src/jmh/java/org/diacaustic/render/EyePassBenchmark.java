package org.diacaustic.render;

import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import org.diacaustic.math.Rgb;
import org.diacaustic.parallel.StopSignal;
import org.diacaustic.scene.Camera;
import org.diacaustic.scenefile.Problems;
import org.diacaustic.scenefile.SceneFile;
import org.diacaustic.scenefile.SceneReader;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;

/**
 * Whole eye rays, with their shadow, mirrored and refracted rays, on one thread, in the order of the picture's rows. With
 * {@code -prof gc} it shows that nothing is allocated per ray. Run it from the project's folder, where the scenes are.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.Throughput)
@OutputTimeUnit(TimeUnit.SECONDS)
public class EyePassBenchmark {
    /** Polygons and a sphere; a fractal, glass and polygons; a mesh of glass, area light and textures. */
    @Param({"control", "complex", "glass-of-water"})
    public String scene;

    private final StopSignal never = new StopSignal();
    private EyeTracer tracer;
    private Camera camera;
    private int pixel;

    @Setup
    public void plan() {
        Problems problems = new Problems();
        SceneFile file = SceneReader.read(Path.of("scenes", scene + ".yaml"), problems)
                .orElseThrow(() -> new IllegalStateException(problems.toString()));
        camera = file.scene().camera();
        tracer = new EyeTracer(RenderPlan.of(file.scene(), file.settings()), Illumination.NONE, false);
    }

    @Benchmark
    public Rgb eyeRay() {
        int x = pixel % camera.width();
        int y = pixel / camera.width();
        pixel = (pixel + 1) % (camera.width() * camera.height());
        tracer.random().start(1, 0, pixel);
        camera.aim(x + 0.5, y + 0.5, 0.5, 0.5, tracer.ray());
        return tracer.trace(never);
    }
}
