package org.diacaustic.shape;

import org.diacaustic.math.Vector3;

/**
 * The spheres of a flake, level by level: the children of sphere i are i·children + 1 and those after it. Every child
 * touches its parent from outside.
 */
final class FlakeSpheres {
    /** x, y, z and radius of each sphere. */
    final double[] spheres;

    private final double ratio;
    private final Vector3[] directions;

    FlakeSpheres(
            Sphereflake.Kind kind, int depth, Vector3 centre, double radius, double ratio, Vector3 up, Vector3 side) {
        this.ratio = ratio;
        this.directions = kind.directions();
        this.spheres = new double[4 * count(directions.length, depth)];
        Vector3 pole = up.normalized();
        Vector3 third = pole.cross(side.normalized()).normalized();
        grow(0, centre, radius, new Frame(third.cross(pole), third, pole), kind == Sphereflake.Kind.OCTAHEDRAL);
    }

    /** 1 + k + k² + … of depth + 1 terms. */
    static int count(int children, int depth) {
        long count = 1;
        for (int level = 0; level < depth; level++) {
            count = count * children + 1;
            if (count > 1 << 26) {
                throw new IllegalArgumentException("depth " + depth + " makes more than 2^26 spheres");
            }
        }
        return (int) count;
    }

    private void grow(int index, Vector3 centre, double radius, Frame frame, boolean upright) {
        int i = 4 * index;
        spheres[i] = centre.x();
        spheres[i + 1] = centre.y();
        spheres[i + 2] = centre.z();
        spheres[i + 3] = radius;
        int firstChild = index * directions.length + 1;
        if (firstChild >= spheres.length / 4) {
            return;
        }
        for (int child = 0; child < directions.length; child++) {
            Vector3 direction = frame.toScene(directions[child]);
            grow(
                    firstChild + child,
                    centre.plus(direction.times(radius * (1 + ratio))),
                    radius * ratio,
                    upright ? frame : frame.pointing(direction),
                    upright);
        }
    }

    /** Three axes at right angles, of length 1. */
    private record Frame(Vector3 x, Vector3 y, Vector3 z) {

        Vector3 toScene(Vector3 v) {
            return x.times(v.x()).plus(y.times(v.y())).plus(z.times(v.z()));
        }

        /** The frame with its pole in another direction, turned the short way. */
        Frame pointing(Vector3 pole) {
            Vector3 side = z.cross(pole).normalized();
            return new Frame(side.cross(pole), side, pole);
        }
    }
}
