package org.diacaustic.shape;

import java.util.concurrent.TimeUnit;
import org.diacaustic.math.Ray;
import org.diacaustic.math.Vector3;
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
 * What care costs: rays a second, one thread, against a sphere, a triangle alone and a mesh of 131,072 triangles, by the tests
 * that renders use and by those of textbooks, which lose digits, leak at edges and have a smallest distance.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.Throughput)
@OutputTimeUnit(TimeUnit.SECONDS)
@OperationsPerInvocation(BenchmarkScenes.RAYS)
public class RobustnessBenchmark {
    @Param({"sphere", "triangle", "mesh"})
    public String scene;

    @Param({"robust", "textbook"})
    public String form;

    private Shape shape;
    private double[] rays;
    private final Ray ray = new Ray();

    @Setup
    public void setUp() {
        boolean textbook = form.equals("textbook");
        if (scene.equals("sphere")) {
            Sphere sphere = new Sphere(Vector3.ZERO, 1);
            shape = textbook ? new TextbookSphere(sphere) : sphere;
        } else {
            MeshData data = scene.equals("mesh") ? BenchmarkScenes.wavyMesh() : triangle();
            TriangleMesh mesh = new TriangleMesh(data, false);
            shape = textbook ? new TextbookMesh(data, mesh) : mesh;
        }
        rays = BenchmarkScenes.rays(scene.equals("mesh"), shape.bounds());
    }

    private static MeshData triangle() {
        return new MeshData(new double[] {0, 0, 0, 1, 0.5, 0, 0, 1, 0.75}, new int[] {0, 1, 2}, null, null);
    }

    @Benchmark
    public double cast() {
        double sum = 0;
        for (int i = 0; i < rays.length; i += 6) {
            ray.set(rays[i], rays[i + 1], rays[i + 2], rays[i + 3], rays[i + 4], rays[i + 5]);
            if (shape.intersect(ray)) {
                sum += ray.tMax;
            }
        }
        return sum;
    }
}
