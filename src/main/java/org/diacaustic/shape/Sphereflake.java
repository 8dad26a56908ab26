package org.diacaustic.shape;

import org.diacaustic.index.BoxHierarchy;
import org.diacaustic.math.Bounds;
import org.diacaustic.math.Ray;
import org.diacaustic.math.Vector3;

/**
 * A fractal of spheres: smaller ones sit on each sphere, and smaller ones on those [Haines 1987]. Its primitives are its
 * spheres, level by level from the root, number 0.
 */
public final class Sphereflake implements Shape {

    /** Where the children of a sphere sit. */
    public enum Kind {
        /**
         * Six children along both ways of three axes, which are the same for all spheres. One of them sits inside its
         * grandparent, where only a transparent flake shows it.
         */
        OCTAHEDRAL,

        /** Nine children: six around the equator and three towards the pole, which points away from the parent. */
        CLASSIC;

        private static final double HALF_ROOT_3 = Math.sqrt(3) / 2;
        private static final double RING = Math.sqrt(1.0 / 3);
        private static final double RISE = Math.sqrt(2.0 / 3);

        public int children() {
            return this == OCTAHEDRAL ? 6 : 9;
        }

        /** The directions of the children in the frame of their parent, whose pole is z. */
        Vector3[] directions() {
            return this == OCTAHEDRAL
                    ? new Vector3[] {
                        new Vector3(1, 0, 0),
                        new Vector3(-1, 0, 0),
                        new Vector3(0, 1, 0),
                        new Vector3(0, -1, 0),
                        new Vector3(0, 0, 1),
                        new Vector3(0, 0, -1)
                    }
                    : new Vector3[] {
                        new Vector3(1, 0, 0),
                        new Vector3(0.5, HALF_ROOT_3, 0),
                        new Vector3(-0.5, HALF_ROOT_3, 0),
                        new Vector3(-1, 0, 0),
                        new Vector3(-0.5, -HALF_ROOT_3, 0),
                        new Vector3(0.5, -HALF_ROOT_3, 0),
                        new Vector3(RING * HALF_ROOT_3, RING / 2, RISE),
                        new Vector3(-RING * HALF_ROOT_3, RING / 2, RISE),
                        new Vector3(0, -RING, RISE)
                    };
        }
    }

    private final double[] spheres;
    private final BoxHierarchy hierarchy;

    /** x, y, z and radius in the order of the hierarchy. */
    private final double[] ordered;

    public Sphereflake(Kind kind, int depth, Vector3 centre, double radius, double ratio, Vector3 up, Vector3 side) {
        this.spheres = new FlakeSpheres(kind, depth, centre, radius, ratio, up, side).spheres;
        int n = spheres.length / 4;
        double[] boxes = new double[6 * n];
        for (int i = 0; i < n; i++) {
            double r = spheres[4 * i + 3];
            for (int axis = 0; axis < 3; axis++) {
                boxes[6 * i + axis] = Math.nextDown(spheres[4 * i + axis] - r);
                boxes[6 * i + 3 + axis] = Math.nextUp(spheres[4 * i + axis] + r);
            }
        }
        this.hierarchy = BoxHierarchy.over(boxes);
        this.ordered = new double[4 * n];
        for (int position = 0; position < n; position++) {
            System.arraycopy(spheres, 4 * hierarchy.item(position), ordered, 4 * position, 4);
        }
    }

    public int size() {
        return spheres.length / 4;
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
        double ox = ray.originX;
        double oy = ray.originY;
        double oz = ray.originZ;
        double dx = ray.directionX;
        double dy = ray.directionY;
        double dz = ray.directionZ;
        double inverseA = 1 / (dx * dx + dy * dy + dz * dz);
        double[] ordered = this.ordered;
        boolean found = false;
        int base = hierarchy.enter(ray);
        for (int leaf = hierarchy.next(ray, base); leaf != BoxHierarchy.DONE; leaf = hierarchy.next(ray, base)) {
            int first = BoxHierarchy.first(leaf);
            int end = BoxHierarchy.end(leaf);
            ray.tests += end - first;
            for (int position = first; position < end; position++) {
                int i = 4 * position;
                double fx = ox - ordered[i];
                double fy = oy - ordered[i + 1];
                double fz = oz - ordered[i + 2];
                double radius = ordered[i + 3];
                // The part of f at right angles to the ray gives the discriminant without cancellation.
                double along = -(fx * dx + fy * dy + fz * dz) * inverseA;
                double px = Math.fma(along, dx, fx);
                double py = Math.fma(along, dy, fy);
                double pz = Math.fma(along, dz, fz);
                double discriminant = radius * radius - (px * px + py * py + pz * pz);
                if (discriminant >= 0 && accept(ray, position, fx, fy, fz, along, discriminant, inverseA)) {
                    found = true;
                    if (anyHit) {
                        hierarchy.leave(ray, base);
                        return true;
                    }
                }
            }
        }
        return found;
    }

    private boolean accept(
            Ray ray,
            int position,
            double fx,
            double fy,
            double fz,
            double along,
            double discriminant,
            double inverseA) {
        double halfChord = Math.sqrt(discriminant * inverseA);
        int sphere = hierarchy.item(position);
        double t;
        if (sphere == ray.leaving) {
            // The start is a root; the other is as far beyond the middle of the chord.
            t = 2 * along;
        } else {
            double radius = ordered[4 * position + 3];
            double distance = Math.sqrt(fx * fx + fy * fy + fz * fz);
            double product = (distance - radius) * (distance + radius) * inverseA;
            double q = along + Math.copySign(halfChord, along);
            double near = along > 0 ? product / q : q;
            t = near > 0 ? near : along > 0 ? q : product / q;
        }
        if (t > 0 && t < ray.tMax) {
            ray.hit(t, sphere);
            return true;
        }
        return false;
    }

    @Override
    public void complete(Ray ray, Hit hit) {}

    @Override
    public void inverseMap(Hit hit) {}

    @Override
    public boolean isClosed() {
        return true;
    }
}
