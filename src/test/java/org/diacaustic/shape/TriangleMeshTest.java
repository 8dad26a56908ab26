package org.diacaustic.shape;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.diacaustic.math.Bounds;
import org.diacaustic.math.Ray;
import org.diacaustic.math.Vector3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class TriangleMeshTest {
    private static final Vector3 FAR = new Vector3(148376, 1234, -223423);

    @Test
    void intersect_givenTrianglesWithoutArea_missesAndCountsThem() {
        // Corners on one line, and two corners in one place.
        TriangleMesh line = TestMeshes.triangle(
                -1113.45459,
                -79.049614,
                -56.2431908,
                -1113.45459,
                -87.0922699,
                -56.2431908,
                -1113.45459,
                -79.2090149,
                -56.2431908);
        Ray ray = new Ray();
        ray.set(-1081.47925, 99.9999542, 87.7701111, -32.1072998, -183.355865, -144.607635);
        assertThat(line.intersect(ray)).isFalse();
        assertThat(line.degenerateCount()).isEqualTo(1);

        TriangleMesh twoEqual = TestMeshes.triangle(0, 0, 0, 0, 0, 0, 1, 1, 0);
        ray.set(0.2, 0.2, 1, 0, 0, -1);
        assertThat(twoEqual.intersect(ray)).isFalse();
        assertThat(twoEqual.degenerateCount()).isEqualTo(1);
        assertThat(twoEqual.bounds()).isEqualTo(Bounds.EMPTY);
    }

    @Test
    void intersect_givenASliver_hitsIt() {
        assertHit(TestMeshes.triangle(0, 0, 0, 1, 0, 0, 0.5, 1e-9, 0), 0.5, 5e-10, 3, 3.0, 0.25, 0.5, 0x1p-49);
    }

    @Test
    void intersect_givenATriangleFarFromTheOrigin_keepsItsDigits() {
        // 1e8 + 0.25 has 2^-27 for its last digit.
        TriangleMesh mesh = TestMeshes.triangle(1e8, 1e8, 0, 1e8 + 1, 1e8, 0, 1e8, 1e8 + 1, 0);
        assertHit(mesh, 1e8 + 0.25, 1e8 + 0.25, 10, 10, 0.25, 0.25, 0x1p-26);
    }

    @Test
    void intersect_givenAHugeTriangleCloseBy_hitsIt() {
        TriangleMesh mesh = TestMeshes.triangle(-1e6, -1e6, 5, 1e6, -1e6, 5, 0, 2e6, 5);
        // Barycentric coordinates of (0.1, 0.2) by hand: 1/3 + y/(3·10^6) for the third, (1 − it)/2 + x/(2·10^6).
        assertHit(mesh, 0.1, 0.2, 5.000001, 5.000001 - 5, 0.33333335, 0.3333334, 0x1p-49);
    }

    private static void assertHit(
            TriangleMesh mesh, double x, double y, double z, double t, double u, double v, double tolerance) {
        Ray ray = new Ray();
        ray.set(x, y, z, 0, 0, -1);
        assertThat(mesh.intersect(ray)).isTrue();
        assertThat(ray.tMax).isCloseTo(t, within(1e-15 * t));
        assertThat(ray.hitU).isCloseTo(u, within(tolerance));
        assertThat(ray.hitV).isCloseTo(v, within(tolerance));
    }

    @Test
    void intersect_givenRandomTriangles_answersAsAllOfThemAskedOneByOne() {
        SplittableRandom random = new SplittableRandom(3);
        double[] vertices = new double[3 * 600];
        int[] triangles = new int[600];
        for (int i = 0; i < vertices.length; i += 9) {
            for (int k = 0; k < 9; k++) {
                // A tenth of them flat and parallel to an axis.
                boolean flat = i % 10 == 0 && k % 3 == 0 && k > 0;
                vertices[i + k] = flat ? vertices[i] : random.nextDouble(-1, 1) * (k < 3 ? 1 : 0.3);
                vertices[i + k] += k < 3 || flat ? 0 : vertices[i + k % 3];
            }
        }
        for (int i = 0; i < triangles.length; i++) {
            triangles[i] = i;
        }
        MeshData data = new MeshData(vertices, triangles, null, null);
        TriangleMesh mesh = new TriangleMesh(data, false);
        Ray ray = new Ray();
        Ray again = new Ray();
        int hits = 0;
        for (int i = 0; i < 100_000; i++) {
            setRandomly(ray, random, i % 4 == 0 ? 0 : 3, i % 5);
            again.set(ray.originX, ray.originY, ray.originZ, ray.directionX, ray.directionY, ray.directionZ);
            double expected = nearestOneByOne(data, ray);
            boolean hit = mesh.intersect(ray);
            assertThat(ray.tMax).isEqualTo(expected);
            assertThat(hit).isEqualTo(expected < Double.POSITIVE_INFINITY);
            assertThat(mesh.occludes(again)).isEqualTo(hit);
            hits += hit ? 1 : 0;
        }
        assertThat(hits).isBetween(30_000, 99_000);
    }

    /** The same arithmetic [Woop, Benthin and Wald 2013] without a tree. */
    private static double nearestOneByOne(MeshData data, Ray ray) {
        double[] origin = {ray.originX, ray.originY, ray.originZ};
        double[] direction = {ray.directionX, ray.directionY, ray.directionZ};
        int z = 2;
        for (int axis = 1; axis >= 0; axis--) {
            z = Math.abs(direction[axis]) > Math.abs(direction[z]) ? axis : z;
        }
        int x = (z + 1) % 3;
        int y = (z + 2) % 3;
        double shearX = -direction[x] / direction[z];
        double shearY = -direction[y] / direction[z];
        double nearest = Double.POSITIVE_INFINITY;
        double[][] p = new double[3][3];
        for (int i = 0; i < data.vertices().length; i += 9) {
            for (int corner = 0; corner < 3; corner++) {
                int at = i + 3 * corner;
                double along = data.vertices()[at + z] - origin[z];
                p[corner][0] = Math.fma(shearX, along, data.vertices()[at + x] - origin[x]);
                p[corner][1] = Math.fma(shearY, along, data.vertices()[at + y] - origin[y]);
                p[corner][2] = along;
            }
            double a = p[2][0] * p[1][1] - p[2][1] * p[1][0];
            double b = p[0][0] * p[2][1] - p[0][1] * p[2][0];
            double c = p[1][0] * p[0][1] - p[1][1] * p[0][0];
            double sum = a + b + c;
            double t = (a * p[0][2] + b * p[1][2] + c * p[2][2]) / (sum * direction[z]);
            boolean inside = a >= 0 && b >= 0 && c >= 0 || a <= 0 && b <= 0 && c <= 0;
            if (inside && sum != 0 && t > 0 && t < nearest) {
                nearest = t;
            }
        }
        return nearest;
    }

    /** From within ±1, or from further away towards it; one in five along an axis. */
    private static void setRandomly(Ray ray, SplittableRandom random, double distance, int kind) {
        double[] d = {random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1)};
        if (kind == 0) {
            int axis = random.nextInt(3);
            d[(axis + 1) % 3] = 0.0;
            d[(axis + 2) % 3] = -0.0;
        }
        ray.set(
                random.nextDouble(-1, 1) - d[0] * distance,
                random.nextDouble(-1, 1) - d[1] * distance,
                random.nextDouble(-1, 1) - d[2] * distance,
                d[0],
                d[1],
                d[2]);
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void intersect_givenRaysFromInsideAClosedMesh_neverSlipsBetweenTriangles(boolean far) {
        Vector3 centre = far ? FAR : Vector3.ZERO;
        MeshData data = TestMeshes.icosphere(far ? 3 : 4, centre, 2, 0.5, 12111);
        TriangleMesh mesh = new TriangleMesh(data, false);
        assertThat(mesh.isClosed()).isTrue();
        SplittableRandom random = new SplittableRandom(7);
        Ray ray = new Ray();
        for (int i = 0; i < 150_000; i++) {
            Vector3 origin = centre.plus(randomDirection(random).times(0.5 * random.nextDouble()));
            int triangle = random.nextInt(data.triangleCount());
            Vector3 direction = switch (i % 3) {
                case 0 -> randomDirection(random);
                case 1 ->
                    TestMeshes.vertex(data, data.triangles()[3 * triangle]).minus(origin);
                default -> TestMeshes.edgeMiddle(data, triangle, i % 9 / 3).minus(origin);
            };
            ray.set(origin, direction);
            assertThat(mesh.intersect(ray)).isTrue();
            assertThat(ray.stackTop).isZero();
        }
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void intersect_givenRaysThatLeaveASphere_neverMeetWhatTheyLeaveAndNeverLoseTheOtherSide(boolean far) {
        // A convex mesh: outward of every facet around the start there is nothing, inward of all of them one exit.
        Vector3 centre = far ? FAR : Vector3.ZERO;
        MeshData data = TestMeshes.icosphere(3, centre, 2, 0, 1);
        TriangleMesh mesh = new TriangleMesh(data, false);
        SplittableRandom random = new SplittableRandom(5);
        Ray ray = new Ray();
        Hit hit = new Hit();
        for (int i = 0; i < 60_000; i++) {
            int triangle = random.nextInt(data.triangleCount());
            Vector3 target = switch (i % 3) {
                case 0 -> TestMeshes.vertex(data, data.triangles()[3 * triangle]);
                case 1 -> TestMeshes.edgeMiddle(data, triangle, i % 9 / 3);
                default ->
                    TestMeshes.edgeMiddle(data, triangle, 0)
                            .plus(TestMeshes.edgeMiddle(data, triangle, 1))
                            .times(0.5);
            };
            Vector3 from = centre.plus(randomDirection(random).times(0.5));
            ray.set(from, target.minus(from));
            assertThat(mesh.intersect(ray)).isTrue();
            complete(mesh, ray, hit);
            // Facets around a vertex differ by less than 0.3 rad: 0.5 is steep enough to be on one side of all.
            Vector3 out = new Vector3(hit.normalX, hit.normalY, hit.normalZ);
            Vector3 beside = randomDirection(random).cross(out).normalized();
            leave(ray, hit, out.times(0.6).plus(beside.times(0.8)));
            assertThat(mesh.intersect(ray)).isFalse();
            leave(ray, hit, out.times(-0.6).plus(beside.times(0.8)));
            assertThat(mesh.intersect(ray)).isTrue();
            // The chord of a sphere of radius about 2 at 0.6 to the normal is about 2.4 long.
            assertThat(ray.tMax).isGreaterThan(2);
            complete(mesh, ray, hit);
            leave(ray, hit, out.times(-0.6).plus(beside.times(0.8)));
            assertThat(mesh.intersect(ray)).isFalse();
        }
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void intersect_givenRaysThroughABumpyMesh_crossItAnOddNumberOfTimesFromInside(boolean far) {
        Vector3 centre = far ? FAR : Vector3.ZERO;
        MeshData data = TestMeshes.icosphere(3, centre, 2, 0.5, 17);
        TriangleMesh mesh = new TriangleMesh(data, false);
        SplittableRandom random = new SplittableRandom(5);
        Ray ray = new Ray();
        Hit hit = new Hit();
        for (int i = 0; i < 30_000; i++) {
            int triangle = random.nextInt(data.triangleCount());
            Vector3 origin = centre.plus(randomDirection(random).times(0.5));
            Vector3 target = i % 3 == 0
                    ? centre.plus(randomDirection(random).times(5))
                    : i % 3 == 1
                            ? TestMeshes.vertex(data, data.triangles()[3 * triangle])
                            : TestMeshes.edgeMiddle(data, triangle, 0);
            Vector3 direction = target.minus(origin).normalized();
            ray.set(origin, direction);
            int crossings = 0;
            while (mesh.intersect(ray)) {
                crossings++;
                complete(mesh, ray, hit);
                leave(ray, hit, direction);
            }
            assertThat(crossings % 2)
                    .as("ray %d from %s along %s", i, origin, direction)
                    .isOne();
        }
    }

    private static void complete(TriangleMesh mesh, Ray ray, Hit hit) {
        hit.t = ray.tMax;
        hit.primitive = ray.hitPrimitive;
        hit.noteU = ray.hitU;
        hit.noteV = ray.hitV;
        mesh.complete(ray, hit);
    }

    private static void leave(Ray ray, Hit hit, Vector3 direction) {
        ray.set(new Vector3(hit.x, hit.y, hit.z), direction);
        ray.leaving = hit.primitive;
        ray.departureError = hit.pointError / direction.length();
    }

    private static Vector3 randomDirection(SplittableRandom random) {
        double z = random.nextDouble(-1, 1);
        double turn = random.nextDouble(2 * Math.PI);
        double r = Math.sqrt(1 - z * z);
        return new Vector3(r * Math.cos(turn), r * Math.sin(turn), z);
    }

    @Test
    void intersect_givenAMeshScaledByAPowerOfTwo_givesTheSameBits() {
        for (int exponent : new int[] {-20, 20}) {
            double scale = Math.scalb(1.0, exponent);
            MeshData data = TestMeshes.icosphere(3, new Vector3(1, 2, 3), 2, 0.5, 3);
            double[] vertices = data.vertices().clone();
            for (int i = 0; i < vertices.length; i++) {
                vertices[i] *= scale;
            }
            TriangleMesh mesh = new TriangleMesh(data, true);
            TriangleMesh scaled = new TriangleMesh(new MeshData(vertices, data.triangles(), null, null), true);
            SplittableRandom random = new SplittableRandom(4);
            Ray ray = new Ray();
            Ray scaledRay = new Ray();
            Hit hit = new Hit();
            Hit scaledHit = new Hit();
            for (int i = 0; i < 2000; i++) {
                setRandomly(ray, random, 3, 1);
                scaledRay.set(
                        ray.originX * scale,
                        ray.originY * scale,
                        ray.originZ * scale,
                        ray.directionX,
                        ray.directionY,
                        ray.directionZ);
                boolean found = mesh.intersect(ray);
                assertThat(scaled.intersect(scaledRay)).isEqualTo(found);
                assertThat(scaledRay.tMax).isEqualTo(ray.tMax * scale);
                assertThat(scaledRay.tests).isEqualTo(ray.tests);
                if (found) {
                    complete(mesh, ray, hit);
                    complete(scaled, scaledRay, scaledHit);
                    assertThat(scaledHit.x).isEqualTo(hit.x * scale);
                    assertThat(scaledHit.pointError).isEqualTo(hit.pointError * scale);
                    assertThat(scaledHit.shadingX).isEqualTo(hit.shadingX);
                }
            }
        }
    }

    @Test
    void complete_givenHitsFarFromTheOrigin_boundsTheDistanceFromThePlane() {
        MeshData data = TestMeshes.icosphere(2, FAR, 2, 0.5, 9);
        TriangleMesh mesh = new TriangleMesh(data, false);
        SplittableRandom random = new SplittableRandom(2);
        Ray ray = new Ray();
        Hit hit = new Hit();
        double largest = 0;
        for (int i = 0; i < 2000; i++) {
            ray.set(FAR, randomDirection(random));
            assertThat(mesh.intersect(ray)).isTrue();
            complete(mesh, ray, hit);
            double distance = distanceFromPlane(data, hit);
            assertThat(distance).isLessThanOrEqualTo(hit.pointError);
            largest = Math.max(largest, distance);
        }
        // The bound is honest, and not a hundred times too cautious.
        assertThat(largest).isGreaterThan(hit.pointError / 100);
    }

    /** In exact arithmetic up to one square root. */
    private static double distanceFromPlane(MeshData data, Hit hit) {
        java.math.BigDecimal[][] e = new java.math.BigDecimal[3][3];
        int[] t = data.triangles();
        int a = 3 * t[3 * hit.primitive];
        double[] p = {hit.x, hit.y, hit.z};
        for (int axis = 0; axis < 3; axis++) {
            java.math.BigDecimal origin = new java.math.BigDecimal(data.vertices()[a + axis]);
            e[0][axis] =
                    new java.math.BigDecimal(data.vertices()[3 * t[3 * hit.primitive + 1] + axis]).subtract(origin);
            e[1][axis] =
                    new java.math.BigDecimal(data.vertices()[3 * t[3 * hit.primitive + 2] + axis]).subtract(origin);
            e[2][axis] = new java.math.BigDecimal(p[axis]).subtract(origin);
        }
        java.math.BigDecimal volume = java.math.BigDecimal.ZERO;
        double squaredArea = 0;
        for (int axis = 0; axis < 3; axis++) {
            int y = (axis + 1) % 3;
            int z = (axis + 2) % 3;
            java.math.BigDecimal n = e[0][y].multiply(e[1][z]).subtract(e[0][z].multiply(e[1][y]));
            volume = volume.add(n.multiply(e[2][axis]));
            squaredArea += n.doubleValue() * n.doubleValue();
        }
        return Math.abs(volume.doubleValue()) / Math.sqrt(squaredArea);
    }

    @Test
    void complete_givenASmoothMesh_shadesWithTheNormalsOfItsVertices() {
        // At the first corner the normal given, along −z as little as +z: it is turned to the side of the winding.
        double[] normals = {1, 0, -1, 0, 0, 1, 0, 0, 1};
        double[] vertices = {0, 0, 0, 1, 0, 0, 0, 1, 0};
        TriangleMesh mesh = new TriangleMesh(new MeshData(vertices, new int[] {0, 1, 2}, normals, null), true);
        Ray ray = new Ray();
        Hit hit = new Hit();
        ray.set(0, 0, 1, 0, 0, -1);
        assertThat(mesh.intersect(ray)).isTrue();
        complete(mesh, ray, hit);
        assertThat(hit.normalZ).isEqualTo(1);
        assertThat(hit.shadingX).isCloseTo(-Math.sqrt(0.5), within(1e-15));
        assertThat(hit.shadingZ).isCloseTo(Math.sqrt(0.5), within(1e-15));
        ray.set(0.25, 0.25, 1, 0, 0, -1);
        assertThat(mesh.intersect(ray)).isTrue();
        complete(mesh, ray, hit);
        // (0.5, 0, −0.5) + (0, 0, 0.25) + (0, 0, 0.25) = (0.5, 0, 0).
        assertThat(hit.shadingX).isCloseTo(1, within(1e-15));
    }

    @Test
    void complete_givenASmoothSphereWithoutNormals_shadesAlmostAsASphere() {
        TriangleMesh mesh = new TriangleMesh(TestMeshes.icosphere(3, Vector3.ZERO, 1, 0, 1), true);
        TriangleMesh facets = new TriangleMesh(TestMeshes.icosphere(3, Vector3.ZERO, 1, 0, 1), false);
        SplittableRandom random = new SplittableRandom(2);
        Ray ray = new Ray();
        Hit hit = new Hit();
        double largest = 0;
        for (int i = 0; i < 500; i++) {
            Vector3 direction = randomDirection(random);
            ray.set(Vector3.ZERO, direction);
            assertThat(mesh.intersect(ray)).isTrue();
            complete(mesh, ray, hit);
            double off = new Vector3(hit.shadingX, hit.shadingY, hit.shadingZ)
                    .minus(direction)
                    .length();
            assertThat(off).isLessThan(0.02);
            ray.set(Vector3.ZERO, direction);
            assertThat(facets.intersect(ray)).isTrue();
            complete(facets, ray, hit);
            largest = Math.max(
                    largest,
                    new Vector3(hit.shadingX, hit.shadingY, hit.shadingZ)
                            .minus(direction)
                            .length());
        }
        assertThat(largest).isGreaterThan(0.05);
    }

    @Test
    void inverseMap_givenMapCoordinates_interpolatesThemAndTheTangents() {
        // u = x / 4, v = 1 − y / 2 on the triangle, so ∂p/∂u = (4, 0, 0) and ∂p/∂v = (0, −2, 0).
        double[] vertices = {0, 0, 0, 4, 0, 0, 0, 2, 0};
        double[] maps = {0, 1, 1, 1, 0, 0};
        TriangleMesh mesh = new TriangleMesh(new MeshData(vertices, new int[] {0, 1, 2}, null, maps), false);
        Ray ray = new Ray();
        Hit hit = new Hit();
        ray.set(1, 0.5, 3, 0, 0, -1);
        assertThat(mesh.intersect(ray)).isTrue();
        complete(mesh, ray, hit);
        mesh.inverseMap(hit);
        assertThat(new double[] {hit.u, hit.v}).containsExactly(new double[] {0.25, 0.75}, within(1e-15));
        assertThat(new double[] {hit.tangentUX, hit.tangentUY, hit.tangentVX, hit.tangentVY})
                .containsExactly(new double[] {4, 0, 0, -2}, within(0.0));
    }

    @Test
    void isClosed_givenAMissingOrTurnedTriangle_isFalse() {
        MeshData data = TestMeshes.icosphere(1, Vector3.ZERO, 1, 0, 1);
        assertThat(new TriangleMesh(data, false).isClosed()).isTrue();
        int[] missing = java.util.Arrays.copyOf(data.triangles(), data.triangles().length - 3);
        assertThat(new TriangleMesh(new MeshData(data.vertices(), missing, null, null), false).isClosed())
                .isFalse();
        int[] turned = data.triangles().clone();
        turned[0] = data.triangles()[1];
        turned[1] = data.triangles()[0];
        assertThat(new TriangleMesh(new MeshData(data.vertices(), turned, null, null), false).isClosed())
                .isFalse();
        assertThat(new TriangleMesh(new MeshData(new double[0], new int[0], null, null), false).isClosed())
                .isFalse();
    }

    @Test
    void isClosed_givenVerticesListedOncePerTriangle_isTrue() {
        MeshData data = TestMeshes.icosphere(1, Vector3.ZERO, 1, 0, 1);
        int[] triangles = new int[data.triangles().length];
        double[] vertices = new double[3 * triangles.length];
        for (int i = 0; i < triangles.length; i++) {
            triangles[i] = i;
            System.arraycopy(data.vertices(), 3 * data.triangles()[i], vertices, 3 * i, 3);
        }
        assertThat(new TriangleMesh(new MeshData(vertices, triangles, null, null), false).isClosed())
                .isTrue();
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void leave_givenRaysThroughEdgesAndCornersOfSpikes_meetsTheTwoSidesByTurns(boolean far) {
        // Rays through a closed mesh go out and in by turns, and out in the end, however it is folded where they pass.
        Vector3 centre = far ? FAR : Vector3.ZERO;
        MeshData data = TestMeshes.icosphere(4, centre, 2, 0.5, 12111);
        TriangleMesh mesh = new TriangleMesh(data, false);
        SplittableRandom random = new SplittableRandom(23);
        Ray ray = new Ray();
        Hit hit = new Hit();
        for (int i = 0; i < 150_000; i++) {
            Vector3 origin = centre.plus(randomDirection(random).times(0.5 * random.nextDouble()));
            int triangle = random.nextInt(data.triangleCount());
            Vector3 target = i % 2 == 0
                    ? TestMeshes.vertex(data, data.triangles()[3 * triangle])
                    : TestMeshes.edgeMiddle(data, triangle, i / 2 % 3);
            Vector3 direction = target.minus(origin).normalized();
            boolean inside = true;
            ray.set(origin, direction);
            while (mesh.intersect(ray)) {
                complete(mesh, ray, hit);
                double along = direction.x() * hit.normalX + direction.y() * hit.normalY + direction.z() * hit.normalZ;
                assertThat(along > 0).as("ray %d", i).isEqualTo(inside);
                inside = !inside;
                leave(ray, hit, direction);
            }
            assertThat(inside).as("ray %d", i).isFalse();
        }
    }
}
