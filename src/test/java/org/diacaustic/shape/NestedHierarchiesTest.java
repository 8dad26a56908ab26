package org.diacaustic.shape;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.management.ManagementFactory;
import java.util.SplittableRandom;
import org.diacaustic.index.BoxHierarchy;
import org.diacaustic.math.Bounds;
import org.diacaustic.math.Ray;
import org.diacaustic.math.Vector3;
import org.junit.jupiter.api.Test;

/** A tree over shapes that have trees of their own, as a scene is. */
class NestedHierarchiesTest {
    private static final Shape[] SHAPES = new Shape[27];
    private static final BoxHierarchy TREE = treeOf(SHAPES);

    private static BoxHierarchy treeOf(Shape[] shapes) {
        double[] boxes = new double[6 * shapes.length];
        for (int i = 0; i < shapes.length; i++) {
            Vector3 centre = new Vector3(i % 3, i / 3 % 3, i / 9).times(1.5);
            shapes[i] = i % 2 == 0
                    ? new TriangleMesh(TestMeshes.icosphere(2, centre, 0.5, 0.5, i), true)
                    : new Sphereflake(FlakeKind.CLASSIC, 2, centre, 0.5);
            Bounds b = shapes[i].bounds();
            double[] box = {b.minX(), b.minY(), b.minZ(), b.maxX(), b.maxY(), b.maxZ()};
            System.arraycopy(box, 0, boxes, 6 * i, 6);
        }
        return BoxHierarchy.over(boxes);
    }

    private static boolean intersect(Ray ray) {
        boolean found = false;
        int base = TREE.enter(ray);
        for (int leaf = TREE.next(ray, base); leaf != BoxHierarchy.DONE; leaf = TREE.next(ray, base)) {
            for (int at = BoxHierarchy.first(leaf); at < BoxHierarchy.end(leaf); at++) {
                found |= SHAPES[TREE.item(at)].intersect(ray);
            }
        }
        return found;
    }

    @Test
    void intersect_givenATreeOverMeshesAndFlakes_answersAsAllAskedOneByOne() {
        SplittableRandom random = new SplittableRandom(1);
        Ray ray = new Ray();
        Ray other = new Ray();
        int hits = 0;
        for (int i = 0; i < 10_000; i++) {
            setRandomly(ray, random);
            other.set(ray.originX, ray.originY, ray.originZ, ray.directionX, ray.directionY, ray.directionZ);
            boolean expected = false;
            for (Shape shape : SHAPES) {
                expected |= shape.intersect(other);
            }
            assertThat(intersect(ray)).isEqualTo(expected);
            assertThat(ray.tMax).isEqualTo(other.tMax);
            assertThat(ray.stackTop).isZero();
            hits += expected ? 1 : 0;
        }
        assertThat(hits).isBetween(1000, 9900);
    }

    @Test
    void intersect_givenAWarmVirtualMachine_allocatesNothing() {
        com.sun.management.ThreadMXBean threads = (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
        long thread = Thread.currentThread().getId();
        Ray ray = new Ray();
        Hit hit = new Hit();
        castMany(ray, hit, 1000);
        long before = threads.getThreadAllocatedBytes(thread);
        long nothing = threads.getThreadAllocatedBytes(thread) - before;
        before = threads.getThreadAllocatedBytes(thread);
        castMany(ray, hit, 5000);
        assertThat(threads.getThreadAllocatedBytes(thread) - before - nothing).isZero();
    }

    /** Rays on a lattice of directions, for a generator of random numbers would allocate. */
    private static void castMany(Ray ray, Hit hit, int rays) {
        for (int i = 0; i < rays; i++) {
            ray.set(-1, -1, -1, 1 + i % 7, 1 + i % 11, 1 + i % 13);
            if (intersect(ray)) {
                hit.t = ray.tMax;
                hit.primitive = ray.hitPrimitive;
                hit.noteU = ray.hitU;
                hit.noteV = ray.hitV;
                // The nearest shape's number is not noted here: any mesh with that triangle will do.
                SHAPES[hit.primitive < 91 ? 1 : 0].complete(ray, hit);
                SHAPES[hit.primitive < 91 ? 1 : 0].inverseMap(hit);
            }
        }
    }

    private static void setRandomly(Ray ray, SplittableRandom random) {
        ray.set(
                random.nextDouble(-1, 4),
                random.nextDouble(-1, 4),
                random.nextDouble(-1, 4),
                random.nextDouble(-1, 1),
                random.nextDouble(-1, 1),
                random.nextDouble(-1, 1));
    }
}
