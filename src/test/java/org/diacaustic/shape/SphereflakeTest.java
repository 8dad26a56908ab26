package org.diacaustic.shape;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.diacaustic.math.Ray;
import org.diacaustic.math.Vector3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class SphereflakeTest {

    @Test
    void constructor_givenNumbersOutOfRange_throws() {
        assertThatThrownBy(() -> new Sphereflake(FlakeKind.CLASSIC, -1, Vector3.ZERO, 1))
                .isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> new Sphereflake(FlakeKind.CLASSIC, 30, Vector3.ZERO, 1))
                .isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> new Sphereflake(FlakeKind.CLASSIC, 1, Vector3.ZERO, 0))
                .isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> flake(FlakeKind.CLASSIC, 1, 1)).isInstanceOf(IllegalArgumentException.class);
    }

    @Test
    void constructor_givenTheClassicKind_hasTheKnownNumbers() {
        // 1 + 9 + 81 + 729 + 6561 spheres; the smallest has 1/81 of the radius.
        FlakeSpheres flake =
                new FlakeSpheres(FlakeKind.CLASSIC, 4, Vector3.ZERO, 1, 1.0 / 3, Vector3.UNIT_Y, Vector3.UNIT_X);
        assertThat(flake.count()).isEqualTo(7381);
        double[] spheres = flake.spheres();
        assertThat(spheres[4 * 7380 + 3]).isCloseTo(1.0 / 81, within(1e-16));
        // 9^k spheres of a third the radius: each level has the area of the root.
        double area = 0;
        for (int sphere = 820; sphere < 7381; sphere++) {
            area += 4 * Math.PI * spheres[4 * sphere + 3] * spheres[4 * sphere + 3];
        }
        assertThat(area).isCloseTo(12.566370614359173, within(1e-11));
    }

    @Test
    void bounds_givenTheOctahedralKind_reachesAsFarAsAllLevelsInARow() {
        // 1 + 2/3 + 2/9 + 2/27 + 2/81 = 161/81 along each axis.
        Sphereflake flake = new Sphereflake(FlakeKind.OCTAHEDRAL, 4, Vector3.ZERO, 1);
        assertThat(flake.sphereCount()).isEqualTo(1 + 6 + 36 + 216 + 1296);
        assertThat(flake.bounds().maxX()).isCloseTo(161.0 / 81, within(1e-14));
        assertThat(flake.bounds().minZ()).isCloseTo(-161.0 / 81, within(1e-14));
    }

    @ParameterizedTest
    @EnumSource(FlakeKind.class)
    void constructor_givenAnyKind_putsChildrenAgainstTheirParent(FlakeKind kind) {
        double[] s = new FlakeSpheres(kind, 3, new Vector3(1, 2, 3), 2, 0.4, new Vector3(1, 1, 1), new Vector3(1, 0, 0))
                .spheres();
        for (int i = 1; i < s.length / 4; i++) {
            int parent = 4 * ((i - 1) / kind.children());
            Vector3 offset = new Vector3(s[4 * i], s[4 * i + 1], s[4 * i + 2])
                    .minus(new Vector3(s[parent], s[parent + 1], s[parent + 2]));
            assertThat(offset.length()).isCloseTo(1.4 * s[parent + 3], within(1e-14));
            assertThat(s[4 * i + 3]).isCloseTo(0.4 * s[parent + 3], within(1e-15));
        }
    }

    @ParameterizedTest
    @EnumSource(FlakeKind.class)
    void intersect_givenRandomRays_answersAsAllSpheresAskedOneByOne(FlakeKind kind) {
        Sphereflake flake = new Sphereflake(kind, 3, Vector3.ZERO, 1);
        FlakeSpheres spheres = new FlakeSpheres(kind, 3, Vector3.ZERO, 1, 1.0 / 3, Vector3.UNIT_Y, Vector3.UNIT_X);
        SplittableRandom random = new SplittableRandom(1);
        Ray ray = new Ray();
        Ray other = new Ray();
        int hits = 0;
        for (int i = 0; i < 20_000; i++) {
            setRandomly(ray, random, i % 2 == 0 ? 0.5 : 1e4);
            if (i % 3 == 0) {
                ray.leaving = random.nextInt(flake.sphereCount());
            }
            other.set(ray.originX, ray.originY, ray.originZ, ray.directionX, ray.directionY, ray.directionZ);
            other.leaving = ray.leaving;
            boolean hit = flake.intersect(ray);
            boolean expected = false;
            for (int sphere = 0; sphere < spheres.count(); sphere++) {
                expected |= spheres.meet(other, sphere, inverseSquare(other));
            }
            assertThat(hit).isEqualTo(expected);
            assertThat(ray.tMax).isEqualTo(other.tMax);
            assertThat(ray.stackTop).isZero();
            ray.tMax = Double.POSITIVE_INFINITY;
            assertThat(flake.occludes(ray)).isEqualTo(expected);
            assertThat(ray.stackTop).isZero();
            hits += hit ? 1 : 0;
        }
        assertThat(hits).isBetween(5_000, 19_000);
    }

    @Test
    void intersect_givenAFlakeOfOneSphere_meetsItAsASphere() {
        Vector3 centre = new Vector3(10, -4, 2);
        Sphereflake flake = new Sphereflake(FlakeKind.OCTAHEDRAL, 0, centre, 0.5);
        Sphere sphere = new Sphere(centre, 0.5);
        SplittableRandom random = new SplittableRandom(2);
        Ray ray = new Ray();
        Ray other = new Ray();
        Hit hit = new Hit();
        Hit otherHit = new Hit();
        int hits = 0;
        for (int i = 0; i < 2000; i++) {
            Vector3 origin = centre.plus(randomDirection(random).times(i % 2 == 0 ? 0.3 : 0.8));
            Vector3 direction = randomDirection(random);
            ray.set(origin, direction);
            other.set(origin, direction);
            boolean found = flake.intersect(ray);
            assertThat(sphere.intersect(other)).isEqualTo(found);
            if (found) {
                assertThat(ray.tMax).isCloseTo(other.tMax, within(1e-14));
                complete(flake, ray, hit);
                complete(sphere, other, otherHit);
                assertThat(hit.normalY).isCloseTo(otherHit.normalY, within(1e-13));
                flake.inverseMap(hit);
                sphere.inverseMap(otherHit);
                assertThat(hit.v).isCloseTo(otherHit.v, within(1e-13));
                hits++;
            }
        }
        assertThat(hits).isGreaterThan(1000);
    }

    @Test
    void intersect_givenOctahedralKind_countsTestsAsTheThesis() {
        Sphereflake flake = new Sphereflake(FlakeKind.OCTAHEDRAL, 3, Vector3.ZERO, 1);
        Ray ray = new Ray();
        ray.set(5, 5, 5, 0, 1, 0);
        flake.intersect(ray);
        assertThat(ray.tests).isEqualTo(8);
        // Through the root's own volume but past those of its children: no more than from afar.
        ray.tests = 0;
        ray.set(1.1, 1.1, -5, 0, 0, 1);
        assertThat(flake.intersect(ray)).isFalse();
        assertThat(ray.tests).isEqualTo(8);
        // Through the volume of one child, past those of its own.
        ray.tests = 0;
        ray.set(1.7, 0.37, -5, 0, 0, 1);
        assertThat(flake.intersect(ray)).isFalse();
        assertThat(ray.tests).isEqualTo(14);
        SplittableRandom random = new SplittableRandom(1);
        for (int i = 0; i < 1000; i++) {
            setRandomly(ray, random, 3);
            ray.tests = 0;
            flake.intersect(ray);
            assertThat(ray.tests % 6).isEqualTo(2);
        }
    }

    @Test
    void intersect_givenRaysThatLeaveASphere_meetsItAgainOnlyThroughIt() {
        Sphereflake flake = new Sphereflake(FlakeKind.CLASSIC, 3, new Vector3(100, 50, -70), 2);
        double[] spheres = new FlakeSpheres(
                        FlakeKind.CLASSIC, 3, new Vector3(100, 50, -70), 2, 1.0 / 3, Vector3.UNIT_Y, Vector3.UNIT_X)
                .spheres();
        SplittableRandom random = new SplittableRandom(3);
        Ray ray = new Ray();
        Hit hit = new Hit();
        int inward = 0;
        for (int i = 0; i < 20_000; i++) {
            Vector3 origin =
                    new Vector3(100, 50, -70).plus(randomDirection(random).times(6));
            Vector3 target =
                    new Vector3(100, 50, -70).plus(randomDirection(random).times(2));
            ray.set(origin, target.minus(origin));
            if (!flake.intersect(ray)) {
                continue;
            }
            complete(flake, ray, hit);
            int left = hit.primitive;
            Vector3 normal = new Vector3(hit.normalX, hit.normalY, hit.normalZ);
            Vector3 direction = randomDirection(random);
            double cosine = direction.dot(normal);
            ray.set(new Vector3(hit.x, hit.y, hit.z), direction);
            ray.leaving = left;
            ray.departureError = hit.pointError;
            boolean found = flake.intersect(ray);
            double chord = -2 * spheres[4 * left + 3] * cosine;
            if (cosine > 0) {
                assertThat(found && ray.hitPrimitive == left).isFalse();
            } else if (chord > 1e-9) {
                assertThat(found).isTrue();
                assertThat(ray.tMax).isLessThanOrEqualTo(chord * (1 + 1e-6));
                inward++;
            }
        }
        assertThat(inward).isGreaterThan(3000);
    }

    private static Sphereflake flake(FlakeKind kind, int depth, double ratio) {
        return new Sphereflake(kind, depth, Vector3.ZERO, 1, ratio, Vector3.UNIT_Y, Vector3.UNIT_X);
    }

    private static double inverseSquare(Ray ray) {
        return 1
                / (ray.directionX * ray.directionX + ray.directionY * ray.directionY + ray.directionZ * ray.directionZ);
    }

    private static void setRandomly(Ray ray, SplittableRandom random, double distance) {
        Vector3 direction = randomDirection(random).times(random.nextDouble(0.5, 2));
        Vector3 target = randomDirection(random).times(1.5 * random.nextDouble());
        ray.set(target.minus(direction.times(distance)), direction);
    }

    private static Vector3 randomDirection(SplittableRandom random) {
        double z = random.nextDouble(-1, 1);
        double turn = random.nextDouble(2 * Math.PI);
        double r = Math.sqrt(1 - z * z);
        return new Vector3(r * Math.cos(turn), r * Math.sin(turn), z);
    }

    private static void complete(Shape shape, Ray ray, Hit hit) {
        hit.t = ray.tMax;
        hit.primitive = ray.hitPrimitive;
        shape.complete(ray, hit);
    }
}
