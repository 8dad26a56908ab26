package org.diacaustic.shape;

import org.diacaustic.math.Arithmetic;
import org.diacaustic.math.Bounds;
import org.diacaustic.math.Ray;
import org.diacaustic.math.Vector3;

/**
 * A fractal of spheres: smaller ones sit on each sphere, and smaller ones on those [Haines 1987]. Its primitives are its
 * spheres, level by level from the root, number 0. Its inverse mapping is that of {@link Sphere}, on each.
 *
 * <p>It is found through the hierarchical bounding volumes of the thesis [Thesis 5.5]: a sphere about each sphere holds
 * all that grows on it. They measured three times as fast as a hierarchy of boxes over the same spheres. Tests are
 * counted as in the thesis, whose rays cost 16 in a scene of this and eight other objects even where they come near none
 * [Thesis Tables 12, 13]: two for the root, its volume and itself, and one for the volume of each of its children,
 * opened or not; then one for the volume of every child when a smaller volume is opened.
 */
public final class Sphereflake implements Shape {
    /** Makes room for the rounding of the volume test for rays from up to 2^30 radii away. */
    private static final double MARGIN = 1 + 0x1p-20;

    private final FlakeSpheres flake;

    /** The radius, about the centre of each sphere, of what holds the sphere and all that grows on it. */
    private final double[] reach;

    private final Bounds bounds;

    /** A flake with its pole up and its equator beginning at +x, and children of a third of their parent's radius. */
    public Sphereflake(FlakeKind kind, int depth, Vector3 centre, double radius) {
        this(kind, depth, centre, radius, 1.0 / 3, Vector3.UNIT_Y, Vector3.UNIT_X);
    }

    /**
     * @param depth the number of levels below the root
     * @param radius of the root, in scene units
     * @param ratio the radius of a child in radii of its parent, between 0 and 1
     * @param up the pole of the root
     * @param side where the equator of the root begins; its part along the pole is left out
     * @throws IllegalArgumentException if a number is out of its range or the flake has more than 2^24 spheres
     */
    public Sphereflake(
            FlakeKind kind, int depth, Vector3 centre, double radius, double ratio, Vector3 up, Vector3 side) {
        this.flake = new FlakeSpheres(kind, depth, centre, radius, ratio, up, side);
        this.reach = new double[flake.count()];
        this.bounds = flake.bounds();
        double[] spheres = flake.spheres();
        for (int sphere = flake.count() - 1; sphere >= 0; sphere--) {
            reach[sphere] = Math.max(reach[sphere], spheres[4 * sphere + 3] * MARGIN);
            if (sphere > 0) {
                int parent = (sphere - 1) / flake.children();
                double distance = Arithmetic.length(
                        spheres[4 * sphere] - spheres[4 * parent],
                        spheres[4 * sphere + 1] - spheres[4 * parent + 1],
                        spheres[4 * sphere + 2] - spheres[4 * parent + 2]);
                reach[parent] = Math.max(reach[parent], distance + reach[sphere]);
            }
        }
    }

    @Override
    public Bounds bounds() {
        return bounds;
    }

    /** The number of spheres. */
    public int sphereCount() {
        return flake.count();
    }

    /** One of the spheres: 0 is the root, the children of i are those from i · children + 1 on. */
    public Sphere sphere(int number) {
        double[] spheres = flake.spheres();
        int i = 4 * number;
        return new Sphere(new Vector3(spheres[i], spheres[i + 1], spheres[i + 2]), spheres[i + 3]);
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
        int base = ray.stackTop;
        ray.tests += flake.count() > 1 ? 2 + flake.children() : 2;
        push(ray, 0, base, inverseSquare);
        boolean found = false;
        while (ray.stackTop > base) {
            int top = --ray.stackTop;
            int sphere = ray.stack[top];
            if (ray.stackFrame[top] >= ray.tMax) {
                continue;
            }
            if (flake.meet(ray, sphere, inverseSquare)) {
                if (anyHit) {
                    ray.stackTop = base;
                    return true;
                }
                found = true;
            }
            open(ray, sphere, inverseSquare);
        }
        return found;
    }

    private void open(Ray ray, int sphere, double inverseSquare) {
        int first = flake.firstChild(sphere);
        if (first >= flake.count()) {
            return;
        }
        ray.reserveStack(flake.children());
        if (sphere > 0) {
            ray.tests += flake.children();
        }
        int bottom = ray.stackTop;
        for (int child = first; child < first + flake.children(); child++) {
            push(ray, child, bottom, inverseSquare);
        }
    }

    /** Puts a volume that the ray enters on the stack, where its siblings from {@code bottom} on end with the nearest. */
    private void push(Ray ray, int sphere, int bottom, double inverseSquare) {
        double entry = entry(ray, sphere, inverseSquare);
        if (!(entry < ray.tMax)) {
            return;
        }
        ray.reserveStack(1);
        int place = ray.stackTop++;
        while (place > bottom && ray.stackFrame[place - 1] < entry) {
            ray.stack[place] = ray.stack[place - 1];
            ray.stackFrame[place] = ray.stackFrame[place - 1];
            place--;
        }
        ray.stack[place] = sphere;
        ray.stackFrame[place] = entry;
    }

    /** Where the ray enters the volume of a sphere, not before its own start; infinite if it never does. */
    private double entry(Ray ray, int sphere, double inverseSquare) {
        double[] spheres = flake.spheres();
        double dx = ray.directionX;
        double dy = ray.directionY;
        double dz = ray.directionZ;
        double fx = ray.originX - spheres[4 * sphere];
        double fy = ray.originY - spheres[4 * sphere + 1];
        double fz = ray.originZ - spheres[4 * sphere + 2];
        double middle = -(fx * dx + fy * dy + fz * dz) * inverseSquare;
        double px = Math.fma(middle, dx, fx);
        double py = Math.fma(middle, dy, fy);
        double pz = Math.fma(middle, dz, fz);
        double discriminant = reach[sphere] * reach[sphere] - (px * px + py * py + pz * pz);
        if (!(discriminant >= 0)) {
            return Double.POSITIVE_INFINITY;
        }
        double halfChord = Math.sqrt(discriminant * inverseSquare);
        return middle + halfChord < 0 ? Double.POSITIVE_INFINITY : Math.max(0, middle - halfChord);
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
