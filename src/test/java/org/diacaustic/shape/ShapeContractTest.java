package org.diacaustic.shape;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.lang.management.ManagementFactory;
import java.util.SplittableRandom;
import org.diacaustic.math.Bounds;
import org.diacaustic.math.Ray;
import org.diacaustic.math.Vector3;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** What {@link Shape} promises, asked of every shape. All seeds are fixed. */
class ShapeContractTest {
    private static final int RAYS = 4000;
    private static final double U = 0x1p-53;

    private final Ray ray = new Ray();
    private final Hit hit = new Hit();

    @ParameterizedTest
    @EnumSource
    void bounds_givenHits_containThem(ShapeSample sample) {
        Shape shape = sample.shape();
        Bounds bounds = shape.bounds();
        int hits = 0;
        for (SplittableRandom random = new SplittableRandom(1); hits < RAYS / 4; ) {
            aim(sample, random);
            if (shape.intersect(ray)) {
                complete(shape);
                hits++;
                assertThat(bounds.contains(hit.x, hit.y, hit.z))
                        .as("%s holds %s %s %s", bounds, hit.x, hit.y, hit.z)
                        .isTrue();
            }
        }
    }

    @ParameterizedTest
    @EnumSource
    void complete_givenHit_liesOnTheRayAndOnTheSurface(ShapeSample sample) {
        Shape shape = sample.shape();
        SplittableRandom random = new SplittableRandom(2);
        int seenAgain = 0;
        int hits = 0;
        while (hits < RAYS / 4) {
            aim(sample, random);
            if (!shape.intersect(ray)) {
                continue;
            }
            complete(shape);
            hits++;
            double rounding = 64 * U * sample.reach();
            double sine = Math.abs(dot(ray.directionX, ray.directionY, ray.directionZ)) / lengthOfDirection();
            double offRay = distanceFromRay();
            // The computed t is off by the rounding of the intersection, magnified at grazing incidence.
            assertThat(offRay).isLessThanOrEqualTo((rounding + hit.pointError) * sample.conditioning() / sine);
            // From a little above the point the surface is met a little below, unless the point is at a border.
            double height = sample.size() * 0x1p-12;
            ray.set(
                    hit.x + height * hit.normalX,
                    hit.y + height * hit.normalY,
                    hit.z + height * hit.normalZ,
                    -hit.normalX,
                    -hit.normalY,
                    -hit.normalZ);
            if (shape.intersect(ray)) {
                seenAgain++;
                assertThat(ray.tMax).isCloseTo(height, within(hit.pointError + rounding * sample.conditioning()));
            }
        }
        assertThat(seenAgain).isGreaterThan(hits * 95 / 100);
    }

    @ParameterizedTest
    @EnumSource
    void walk_givenLine_crossesClosedShapesInAndOutInTurn(ShapeSample sample) {
        Shape shape = sample.shape();
        SplittableRandom random = new SplittableRandom(3);
        int crossings = 0;
        for (int i = 0; i < RAYS; i++) {
            aim(sample, random);
            double dx = ray.directionX;
            double dy = ray.directionY;
            double dz = ray.directionZ;
            int along = 0;
            while (shape.intersect(ray)) {
                complete(shape);
                assertThat(hit.normalX * hit.normalX + hit.normalY * hit.normalY + hit.normalZ * hit.normalZ)
                        .isCloseTo(1, within(8 * U));
                if (shape.isClosed()) {
                    assertThat(dot(dx, dy, dz) < 0)
                            .as("crossing %s of ray %s", along, i)
                            .isEqualTo(along % 2 == 0);
                }
                along++;
                assertThat(along).isLessThanOrEqualTo(sample.mostCrossings());
                leave(dx, dy, dz);
            }
            if (shape.isClosed()) {
                assertThat(along % 2).as("crossings of ray %s", i).isZero();
            }
            crossings += along;
        }
        assertThat(crossings).isGreaterThan(RAYS / 10);
    }

    @ParameterizedTest
    @EnumSource
    void leave_givenOutwardDirection_neverMeetsTheSamePlace(ShapeSample sample) {
        Shape shape = sample.shape();
        SplittableRandom random = new SplittableRandom(4);
        for (int i = 0; i < RAYS; i++) {
            aim(sample, random);
            if (!shape.intersect(ray)) {
                continue;
            }
            complete(shape);
            Vector3 normal = new Vector3(hit.normalX, hit.normalY, hit.normalZ);
            Vector3 aside = normal.cross(randomDirection(random));
            // From straight up to grazing within rounding.
            double rise = Math.scalb(random.nextDouble(), -random.nextInt(50));
            Vector3 out = aside.plus(normal.times(rise));
            if (out.dot(normal) <= 0) {
                continue;
            }
            leave(out.x(), out.y(), out.z());
            if (shape.intersect(ray)) {
                assertThat(sample.isConvex())
                        .as("ray %s, rise %s, t %s", i, rise, ray.tMax)
                        .isFalse();
                // Along a hollow the surface rises to meet the ray: not nearer than 2·rise·(radius of the hollow).
                assertThat(ray.tMax * out.length()).isGreaterThan(0.02 * rise * sample.size() + hit.pointError);
            }
        }
    }

    @ParameterizedTest
    @EnumSource
    void leave_givenInwardDirection_findsTheFarSideOfClosedShapes(ShapeSample sample) {
        Shape shape = sample.shape();
        if (!shape.isClosed()) {
            return;
        }
        SplittableRandom random = new SplittableRandom(5);
        for (int i = 0; i < RAYS; i++) {
            aim(sample, random);
            if (!shape.intersect(ray)) {
                continue;
            }
            complete(shape);
            Vector3 normal = new Vector3(hit.normalX, hit.normalY, hit.normalZ);
            Vector3 aside = normal.cross(randomDirection(random));
            Vector3 in = aside.minus(normal.times(Math.scalb(1 + random.nextDouble(), -random.nextInt(12))));
            leave(in.x(), in.y(), in.z());
            assertThat(shape.intersect(ray)).as("ray %s", i).isTrue();
            complete(shape);
            assertThat(dot(in.x(), in.y(), in.z())).isGreaterThan(0);
        }
    }

    @ParameterizedTest
    @EnumSource
    void occludes_givenAnyEnd_agreesWithIntersect(ShapeSample sample) {
        Shape shape = sample.shape();
        SplittableRandom random = new SplittableRandom(6);
        Ray second = new Ray();
        for (int i = 0; i < RAYS; i++) {
            aim(sample, random);
            ray.tMax = 2 * random.nextDouble();
            second.set(ray.originX, ray.originY, ray.originZ, ray.directionX, ray.directionY, ray.directionZ);
            second.tMax = ray.tMax;
            boolean found = shape.intersect(ray);
            assertThat(shape.occludes(second)).isEqualTo(found);
            assertThat(ray.tMax < second.tMax || !found || ray.tMax == second.tMax)
                    .isTrue();
            if (found) {
                complete(shape);
                leave(second.directionX, second.directionY, second.directionZ);
                second.set(ray.originX, ray.originY, ray.originZ, ray.directionX, ray.directionY, ray.directionZ);
                second.leaving = ray.leaving;
                second.departureError = ray.departureError;
                found = shape.intersect(ray);
                assertThat(shape.occludes(second)).isEqualTo(found);
            }
        }
    }

    @ParameterizedTest
    @EnumSource
    void intersect_givenEveryLengthTimesPowerOfTwo_scalesTExactly(ShapeSample sample) {
        for (double factor : new double[] {0x1p-20, 0x1p20, 0x1p30}) {
            Shape shape = sample.shape();
            Shape scaled = sample.scaled(factor);
            SplittableRandom random = new SplittableRandom(7);
            Ray big = new Ray();
            Hit bigHit = new Hit();
            for (int i = 0; i < RAYS / 4; i++) {
                aim(sample, random);
                Vector3 d = new Vector3(ray.directionX, ray.directionY, ray.directionZ);
                big.set(ray.originX * factor, ray.originY * factor, ray.originZ * factor, d.x(), d.y(), d.z());
                for (int step = 0; step < 3; step++) {
                    boolean found = shape.intersect(ray);
                    assertThat(scaled.intersect(big)).isEqualTo(found);
                    if (!found) {
                        break;
                    }
                    assertThat(big.tMax).isEqualTo(ray.tMax * factor);
                    complete(shape);
                    complete(scaled, big, bigHit);
                    assertThat(bigHit.x).isEqualTo(hit.x * factor);
                    assertThat(bigHit.pointError).isEqualTo(hit.pointError * factor);
                    assertThat(bigHit.normalY).isEqualTo(hit.normalY);
                    leave(d.x(), d.y(), d.z());
                    leave(big, bigHit, d.x(), d.y(), d.z());
                }
            }
        }
    }

    @ParameterizedTest
    @EnumSource
    void inverseMap_givenHits_isWithinTheMapAndHasTrueTangents(ShapeSample sample) {
        Shape shape = sample.shape();
        SplittableRandom random = new SplittableRandom(8);
        int compared = 0;
        int hits = 0;
        while (hits < RAYS / 4) {
            aim(sample, random);
            if (!shape.intersect(ray)) {
                continue;
            }
            hits++;
            complete(shape);
            shape.inverseMap(hit);
            assertThat(hit.u).isBetween(0.0, 1.0);
            assertThat(hit.v).isBetween(0.0, 1.0);
            Vector3 tangentU = new Vector3(hit.tangentUX, hit.tangentUY, hit.tangentUZ);
            Vector3 tangentV = new Vector3(hit.tangentVX, hit.tangentVY, hit.tangentVZ);
            assertThat(tangentU.isFinite() && tangentV.isFinite()).isTrue();
            Vector3 normal = new Vector3(hit.normalX, hit.normalY, hit.normalZ);
            double u = hit.u;
            double v = hit.v;
            // Near the border u and v may jump; where a projection grazes the surface a small step is not small.
            boolean nearBorder = Math.min(u, v) < 0.02 || Math.max(u, v) > 0.98;
            if (nearBorder || Math.max(tangentU.length(), tangentV.length()) > 10 * sample.size()) {
                continue;
            }
            assertThat(tangentU.dot(normal)).isCloseTo(0, within(1e-7 * tangentU.length()));
            assertThat(tangentV.dot(normal)).isCloseTo(0, within(1e-7 * tangentV.length()));
            Vector3 point = new Vector3(hit.x, hit.y, hit.z);
            int primitive = hit.primitive;
            double step = 1e-5;
            boolean alongU = random.nextBoolean();
            Vector3 moved = point.plus((alongU ? tangentU : tangentV).times(step));
            ray.set(moved.plus(normal.times(1e-3 * sample.size())), normal.negated());
            if (shape.intersect(ray) && ray.hitPrimitive == primitive) {
                complete(shape);
                shape.inverseMap(hit);
                compared++;
                assertThat(hit.u - u).isCloseTo(alongU ? step : 0, within(0.02 * step));
                assertThat(hit.v - v).isCloseTo(alongU ? 0 : step, within(0.02 * step));
            }
        }
        assertThat(compared).isGreaterThan(hits / 2);
    }

    @ParameterizedTest
    @EnumSource
    void everything_afterWarmUp_allocatesNothing(ShapeSample sample) {
        Shape shape = sample.shape();
        var threads = (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
        double[] rays = new double[6 * 512];
        SplittableRandom random = new SplittableRandom(9);
        for (int i = 0; i < 512; i++) {
            aim(sample, random);
            double[] one = {ray.originX, ray.originY, ray.originZ, ray.directionX, ray.directionY, ray.directionZ};
            System.arraycopy(one, 0, rays, 6 * i, 6);
        }
        int found = trace(shape, rays);
        long before = threads.getCurrentThreadAllocatedBytes();
        found += trace(shape, rays);
        long bytes = threads.getCurrentThreadAllocatedBytes() - before;
        assertThat(found).isPositive();
        // The measurement itself may take a few bytes; one object for each of 512 rays would take 8 kB.
        assertThat(bytes).isLessThan(1024);
    }

    private int trace(Shape shape, double[] rays) {
        int found = 0;
        for (int i = 0; i < rays.length; i += 6) {
            ray.set(rays[i], rays[i + 1], rays[i + 2], rays[i + 3], rays[i + 4], rays[i + 5]);
            if (shape.occludes(ray)) {
                ray.set(rays[i], rays[i + 1], rays[i + 2], rays[i + 3], rays[i + 4], rays[i + 5]);
                shape.intersect(ray);
                complete(shape);
                shape.inverseMap(hit);
                leave(rays[i + 3], rays[i + 4], rays[i + 5]);
                found += shape.intersect(ray) ? 2 : 1;
            }
        }
        return found;
    }

    /** A ray from around the shape to a point of its box; its direction reaches that point at t = 1. */
    private void aim(ShapeSample sample, SplittableRandom random) {
        Vector3 centre = sample.centre();
        Vector3 from = centre.plus(randomDirection(random).times(sample.size() * (1.2 + 3 * random.nextDouble())));
        Vector3 to = centre.plus(randomDirection(random).times(sample.size() * random.nextDouble()));
        ray.set(from, to.minus(from));
    }

    private void complete(Shape shape) {
        complete(shape, ray, hit);
    }

    private static void complete(Shape shape, Ray ray, Hit hit) {
        hit.t = ray.tMax;
        hit.primitive = ray.hitPrimitive;
        hit.noteU = ray.hitU;
        hit.noteV = ray.hitV;
        shape.complete(ray, hit);
    }

    private void leave(double dx, double dy, double dz) {
        leave(ray, hit, dx, dy, dz);
    }

    private static void leave(Ray ray, Hit hit, double dx, double dy, double dz) {
        ray.set(hit.x, hit.y, hit.z, dx, dy, dz);
        ray.leaving = hit.primitive;
        ray.departureError = hit.pointError / Math.sqrt(dx * dx + dy * dy + dz * dz);
    }

    private double dot(double dx, double dy, double dz) {
        return dx * hit.normalX + dy * hit.normalY + dz * hit.normalZ;
    }

    private double lengthOfDirection() {
        return new Vector3(ray.directionX, ray.directionY, ray.directionZ).length();
    }

    private static Vector3 randomDirection(SplittableRandom random) {
        while (true) {
            Vector3 v =
                    new Vector3(2 * random.nextDouble() - 1, 2 * random.nextDouble() - 1, 2 * random.nextDouble() - 1);
            if (v.length() > 0.1 && v.length() < 1) {
                return v.normalized();
            }
        }
    }

    /** How far the hit lies from the line of its ray. */
    private double distanceFromRay() {
        Vector3 d = new Vector3(ray.directionX, ray.directionY, ray.directionZ).normalized();
        Vector3 f = new Vector3(hit.x - ray.originX, hit.y - ray.originY, hit.z - ray.originZ);
        return f.minus(d.times(f.dot(d))).length();
    }
}
