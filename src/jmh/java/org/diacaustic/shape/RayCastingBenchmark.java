package org.diacaustic.shape;

import java.util.concurrent.TimeUnit;
import org.diacaustic.math.Ray;
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
 * Rays a second, one thread, against a mesh of 131,072 triangles and a flake of 7,381 spheres, beside a plain caster with
 * an object for every node, primitive and hit.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.Throughput)
@OutputTimeUnit(TimeUnit.SECONDS)
@OperationsPerInvocation(BenchmarkScenes.RAYS)
public class RayCastingBenchmark {
    @Param({"mesh", "flake", "flake-in-boxes"})
    public String scene;

    @Param({"coherent", "incoherent"})
    public String order;

    private Shape shape;
    private PlainCaster plain;
    private double[] rays;
    private final Ray ray = new Ray();

    @Setup
    public void setUp() {
        if (scene.equals("mesh")) {
            MeshData data = BenchmarkScenes.wavyMesh();
            shape = new TriangleMesh(data, false);
            plain = PlainCaster.of(data);
        } else {
            FlakeSpheres spheres = BenchmarkScenes.flakeSpheres();
            shape = scene.equals("flake") ? BenchmarkScenes.flake() : new BoxSphereflake(spheres);
            plain = PlainCaster.of(spheres.spheres());
        }
        rays = BenchmarkScenes.rays(order.equals("coherent"), shape.bounds());
        compareAnswers();
    }

    /** Both must give the same answers, or the comparison means nothing. */
    private void compareAnswers() {
        for (int i = 0; i < rays.length; i += 6) {
            set(i);
            boolean hit = shape.intersect(ray);
            PlainCaster.PlainHit other = cast(i);
            if (hit != (other != null) || hit && Math.abs(ray.tMax - other.t()) > 1e-9 * other.t()) {
                throw new IllegalStateException("casters disagree on ray " + i / 6);
            }
        }
    }

    private void set(int i) {
        ray.set(rays[i], rays[i + 1], rays[i + 2], rays[i + 3], rays[i + 4], rays[i + 5]);
    }

    private PlainCaster.PlainHit cast(int i) {
        return plain.cast(rays[i], rays[i + 1], rays[i + 2], rays[i + 3], rays[i + 4], rays[i + 5]);
    }

    @Benchmark
    public double arrays() {
        double sum = 0;
        for (int i = 0; i < rays.length; i += 6) {
            set(i);
            if (shape.intersect(ray)) {
                sum += ray.tMax;
            }
        }
        return sum;
    }

    @Benchmark
    public double plainObjects() {
        double sum = 0;
        for (int i = 0; i < rays.length; i += 6) {
            PlainCaster.PlainHit hit = cast(i);
            if (hit != null) {
                sum += hit.t();
            }
        }
        return sum;
    }
}
