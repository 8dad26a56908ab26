package org.diacaustic.shape;

import org.diacaustic.index.BoxHierarchy;
import org.diacaustic.math.Bounds;
import org.diacaustic.math.Ray;

/**
 * The loser: a flake that finds its spheres through a hierarchy of boxes. It answers as {@link Sphereflake}, bit by bit,
 * and takes about three times as long.
 */
final class BoxSphereflake implements Shape {
    private final FlakeSpheres flake;
    private final BoxHierarchy hierarchy;

    /** x, y, z and radius of each sphere in the order of the hierarchy. */
    private final double[] ordered;

    BoxSphereflake(FlakeSpheres flake) {
        this.flake = flake;
        double[] spheres = flake.spheres();
        double[] boxes = new double[6 * flake.count()];
        for (int sphere = 0; sphere < flake.count(); sphere++) {
            double r = spheres[4 * sphere + 3];
            for (int axis = 0; axis < 3; axis++) {
                boxes[6 * sphere + axis] = Math.nextDown(spheres[4 * sphere + axis] - r);
                boxes[6 * sphere + 3 + axis] = Math.nextUp(spheres[4 * sphere + axis] + r);
            }
        }
        this.hierarchy = BoxHierarchy.over(boxes);
        this.ordered = new double[spheres.length];
        for (int position = 0; position < flake.count(); position++) {
            System.arraycopy(spheres, 4 * hierarchy.item(position), ordered, 4 * position, 4);
        }
    }

    @Override
    public Bounds bounds() {
        return hierarchy.bounds();
    }

    @Override
    public boolean intersect(Ray ray) {
        return walk(ray, false);
    }

    @Override
    public boolean occludes(Ray ray) {
        return walk(ray, true);
    }

    private boolean walk(Ray ray, boolean anyHit) {
        double dx = ray.directionX;
        double dy = ray.directionY;
        double dz = ray.directionZ;
        double inverseSquare = 1 / (dx * dx + dy * dy + dz * dz);
        double[] ordered = this.ordered;
        boolean found = false;
        int base = hierarchy.enter(ray);
        for (int leaf = hierarchy.next(ray, base); leaf != BoxHierarchy.DONE; leaf = hierarchy.next(ray, base)) {
            int first = BoxHierarchy.first(leaf);
            int end = BoxHierarchy.end(leaf);
            ray.tests += end - first;
            for (int position = first; position < end; position++) {
                int i = 4 * position;
                if (FlakeSpheres.meet(
                        ray,
                        hierarchy.item(position),
                        ordered[i],
                        ordered[i + 1],
                        ordered[i + 2],
                        ordered[i + 3],
                        inverseSquare)) {
                    if (anyHit) {
                        hierarchy.leave(ray, base);
                        return true;
                    }
                    found = true;
                }
            }
        }
        return found;
    }

    @Override
    public void complete(Ray ray, Hit hit) {
        flake.complete(ray, hit);
    }

    @Override
    public void inverseMap(Hit hit) {
        flake.inverseMap(hit);
    }

    @Override
    public boolean isClosed() {
        return true;
    }
}
