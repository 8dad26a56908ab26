package org.diacaustic.shape;

import java.util.SplittableRandom;
import org.diacaustic.math.Bounds;
import org.diacaustic.math.Vector3;

/** The shapes and rays that the benchmarks of ray casting share. */
final class BenchmarkScenes {
    /** The number of rays of one invocation. */
    static final int RAYS = 1 << 16;

    private static final int GRID = 256;

    private BenchmarkScenes() {}

    /** A wavy sheet over the square ±1 of 256 × 256 cells, 131,072 triangles. */
    static MeshData wavyMesh() {
        int side = GRID + 1;
        double[] vertices = new double[3 * side * side];
        for (int row = 0; row < side; row++) {
            for (int column = 0; column < side; column++) {
                double x = 2.0 * column / GRID - 1;
                double z = 2.0 * row / GRID - 1;
                int i = 3 * (row * side + column);
                vertices[i] = x;
                vertices[i + 1] = 0.1 * Math.sin(9 * x + 2 * z) + 0.05 * Math.sin(17 * z - 5 * x);
                vertices[i + 2] = z;
            }
        }
        int[] triangles = new int[6 * GRID * GRID];
        int next = 0;
        for (int row = 0; row < GRID; row++) {
            for (int column = 0; column < GRID; column++) {
                int a = row * side + column;
                int c = a + side;
                for (int vertex : new int[] {a, c, a + 1, a + 1, c, c + 1}) {
                    triangles[next++] = vertex;
                }
            }
        }
        return new MeshData(vertices, triangles, null, null);
    }

    /** Nine children, four levels: 7,381 spheres. */
    static Sphereflake flake() {
        return new Sphereflake(FlakeKind.CLASSIC, 4, Vector3.ZERO, 1);
    }

    static FlakeSpheres flakeSpheres() {
        return new FlakeSpheres(FlakeKind.CLASSIC, 4, Vector3.ZERO, 1, 1.0 / 3, Vector3.UNIT_Y, Vector3.UNIT_X);
    }

    /** Rays of a pinhole camera in scan-line order, or from anywhere in the bounds to anywhere; six numbers each. */
    static double[] rays(boolean coherent, Bounds bounds) {
        return coherent ? cameraRays(bounds) : randomRays(bounds);
    }

    private static double[] cameraRays(Bounds bounds) {
        Vector3 centre = bounds.centre();
        Vector3 eye = centre.plus(new Vector3(0.5, 1.2, -1.6).times(bounds.radius()));
        Vector3 forward = centre.minus(eye).normalized();
        Vector3 right = Vector3.UNIT_Y.cross(forward).normalized();
        Vector3 up = forward.cross(right);
        int size = (int) Math.sqrt(RAYS);
        double[] rays = new double[6 * RAYS];
        for (int i = 0; i < RAYS; i++) {
            double x = (i % size + 0.5) / size - 0.5;
            double y = 0.5 - (i / size + 0.5) / size;
            set(
                    rays,
                    i,
                    eye,
                    forward.plus(right.times(0.6 * x)).plus(up.times(0.6 * y)).normalized());
        }
        return rays;
    }

    private static double[] randomRays(Bounds bounds) {
        SplittableRandom random = new SplittableRandom(20_240_531);
        double[] rays = new double[6 * RAYS];
        for (int i = 0; i < RAYS; i++) {
            Vector3 origin = new Vector3(
                    random.nextDouble(bounds.minX(), bounds.maxX()),
                    random.nextDouble(bounds.minY(), bounds.maxY()),
                    random.nextDouble(bounds.minZ(), bounds.maxZ()));
            double z = random.nextDouble(-1, 1);
            double turn = random.nextDouble(2 * Math.PI);
            double r = Math.sqrt(1 - z * z);
            set(rays, i, origin, new Vector3(r * Math.cos(turn), r * Math.sin(turn), z));
        }
        return rays;
    }

    private static void set(double[] rays, int ray, Vector3 origin, Vector3 direction) {
        rays[6 * ray] = origin.x();
        rays[6 * ray + 1] = origin.y();
        rays[6 * ray + 2] = origin.z();
        rays[6 * ray + 3] = direction.x();
        rays[6 * ray + 4] = direction.y();
        rays[6 * ray + 5] = direction.z();
    }
}
