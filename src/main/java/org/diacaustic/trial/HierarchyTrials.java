package org.diacaustic.trial;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.diacaustic.index.BoxHierarchy;
import org.diacaustic.math.Bounds;
import org.diacaustic.math.Ray;
import org.diacaustic.math.SampleStream;
import org.diacaustic.math.Vector3;
import org.diacaustic.scene.SceneIndex;
import org.diacaustic.scene.SceneObject;
import org.diacaustic.shape.Box;
import org.diacaustic.shape.FlakeKind;
import org.diacaustic.shape.Sphere;
import org.diacaustic.shape.Sphereflake;
import org.diacaustic.stability.CaseFault;
import org.diacaustic.stability.Checks;
import org.diacaustic.stability.NumericCase;
import org.diacaustic.stability.Operations;

/** Boxes around shapes, and the trees that find shapes by them. */
final class HierarchyTrials {
    private static final Pattern SHAPES = Pattern.compile("(\\d+) mixed shapes");

    /** What some operations on correctly rounded radii may add up to, as a part of the result. */
    private static final double ROUNDING = 0x1p-50;

    /** No path from the root of a tree of boxes is longer. */
    private static final int DEPTH = 64;

    /** A box has so many primitives. */
    private static final int FACES = 6;

    private HierarchyTrials() {}

    static void addTo(Operations operations) {
        operations.add(
                "ray_box",
                "A Box asked as ray_sphere asks spheres; a ray that starts on it and goes away from it touches it. One without volume is no Box, only the Bounds of something flat: tmin"
                        + " is the shortest ray that Bounds.isHitBy finds in it, and tmax the same from beyond. Where the"
                        + " answer is a hit, neither Bounds nor a BoxHierarchy may cull it.",
                HierarchyTrials::box);
        operations.add(
                "bvh_vs_bruteforce",
                "A SceneIndex of so many random shapes of all kinds, as renders build it, against one that asks all objects in list order:"
                        + " object and bits of t.",
                HierarchyTrials::againstAll);
        operations.add(
                "bvh_coincident",
                "A SceneIndex of so many equal Spheres, and the first of the list must be hit, the second time as well. Depth: the most"
                        + " nodes that a walk through the tree of their boxes holds open, which is no more than its depth.",
                HierarchyTrials::coincident);
        operations.add(
                "sphereflake",
                "A Sphereflake of nine children: its spheres counted, the radius of the smallest, the area of each level, and the length"
                        + " of a chain of spheres that touch, from the middle of the root to the far side of a leaf; the last two"
                        + " within 8 units of roundoff, since they are computed from radii that are exact but for one rounding.",
                HierarchyTrials::flake);
    }

    private static void box(NumericCase asked, Checks checks) {
        Vector3 low = RootTrials.vector(asked.inputs(), "lo");
        Vector3 high = RootTrials.vector(asked.inputs(), "hi");
        Vector3 origin = RootTrials.vector(asked.inputs(), "origin");
        Vector3 direction = RootTrials.vector(asked.inputs(), "dir");
        boolean isHit = asked.expected().flag("hit");
        Bounds bounds = Bounds.of(low, high);
        boolean isSolid = low.x() < high.x() && low.y() < high.y() && low.z() < high.z();
        checks.size(bounds.radius());
        LineRoots line = isSolid ? LineRoots.of(new Box(low, high), origin, direction) : null;
        double[] roots = isSolid ? line.all(2, FACES) : span(bounds, origin, direction);
        boolean found = isSolid ? roots.length > 0 && roots[roots.length - 1] >= 0 : enters(bounds, origin, direction);
        checks.same("hit", isHit, found);
        if (!isHit) {
            return;
        }
        checks.holds("Bounds.isHitBy", enters(bounds, origin, direction));
        checks.same("leaves that a BoxHierarchy hands out", 1, leaves(bounds, origin, direction));
        if (!asked.expected().has("tmin") || !found) {
            return;
        }
        checks.number("tmin", roots.length > 0 ? roots[0] : Double.NaN, "t");
        checks.number("tmax", roots.length > 1 ? roots[1] : Double.NaN, "t");
    }

    private static boolean enters(Bounds bounds, Vector3 origin, Vector3 direction) {
        Ray ray = new Ray();
        ray.set(origin, direction);
        return bounds.isHitBy(ray);
    }

    private static int leaves(Bounds bounds, Vector3 origin, Vector3 direction) {
        BoxHierarchy tree = BoxHierarchy.over(
                new double[] {bounds.minX(), bounds.minY(), bounds.minZ(), bounds.maxX(), bounds.maxY(), bounds.maxZ()
                });
        Ray ray = new Ray();
        ray.set(origin, direction);
        int base = tree.enter(ray);
        int leaves = 0;
        while (tree.next(ray, base) != BoxHierarchy.DONE) {
            leaves++;
        }
        return leaves;
    }

    /** Where a ray that enters bounds is within them. */
    private static double[] span(Bounds bounds, Vector3 origin, Vector3 direction) {
        double reach = (bounds.centre().minus(origin).length() + bounds.radius()) / direction.length();
        double beyond = Math.scalb(1.0, Math.getExponent(reach) + 2);
        double back = shortest(bounds, origin.plus(direction.times(beyond)), direction.negated(), beyond);
        return new double[] {shortest(bounds, origin, direction, beyond), beyond - back};
    }

    private static double shortest(Bounds bounds, Vector3 origin, Vector3 direction, double most) {
        Ray ray = new Ray();
        ray.set(origin, direction);
        double misses = -Double.MIN_VALUE;
        double hits = most;
        while (true) {
            ray.tMax = misses + (hits - misses) / 2;
            if (ray.tMax <= misses || ray.tMax >= hits) {
                return hits;
            }
            if (bounds.isHitBy(ray)) {
                hits = ray.tMax;
            } else {
                misses = ray.tMax;
            }
        }
    }

    private static void againstAll(NumericCase asked, Checks checks) {
        Matcher shapes = SHAPES.matcher(asked.title());
        int count = asked.inputs().has("shapes")
                ? (int) asked.inputs().integer("shapes")
                : shapes.find() ? Integer.parseInt(shapes.group(1)) : 500;
        SampleStream random = new SampleStream();
        random.start(asked.inputs().integer("seed"), 0, 0);
        List<SceneObject> objects = new MixedShapes(random).objects(count);
        SceneIndex tree = SceneIndex.of(objects, false);
        SceneIndex list = SceneIndex.of(objects, true);
        Ray ray = new Ray();
        long otherHits = 0;
        long otherBits = 0;
        long rays = asked.inputs().integer("rays");
        long met = 0;
        for (long i = 0; i < rays; i++) {
            Vector3 origin = DepartureTrials.random(random).times(2 * random.nextDouble());
            Vector3 direction = DepartureTrials.random(random);
            ray.set(origin, direction);
            int byTree = tree.nearest(ray, SceneIndex.NONE, 0);
            double t = ray.tMax;
            ray.set(origin, direction);
            int byList = list.nearest(ray, SceneIndex.NONE, 0);
            met += byList == SceneIndex.NONE ? 0 : 1;
            otherHits += byTree != byList ? 1 : 0;
            otherBits += Double.doubleToLongBits(t) != Double.doubleToLongBits(ray.tMax) ? 1 : 0;
        }
        checks.holds("the scene is arranged in a tree", tree.hasTree());
        checks.holds("many rays hit and many miss", met > rays / 20 && met < rays - rays / 20);
        checks.same("mismatching_hits", asked.expected().integer("mismatching_hits"), otherHits);
        checks.same("mismatching_t_bits", asked.expected().integer("mismatching_t_bits"), otherBits);
    }

    private static void coincident(NumericCase asked, Checks checks) {
        int copies = (int) asked.inputs().integer("copies");
        if (copies < 1) {
            throw new CaseFault("there must be a sphere, but there are " + copies);
        }
        List<SceneObject> objects = new ArrayList<>();
        double[] boxes = new double[6 * copies];
        for (int i = 0; i < copies; i++) {
            objects.add(MixedShapes.object(new Sphere(Vector3.ZERO, 1)));
            for (int k = 0; k < 6; k++) {
                boxes[6 * i + k] = k < 3 ? -1 : 1;
            }
        }
        SceneIndex scene = SceneIndex.of(objects, false);
        Ray ray = new Ray();
        for (int turn = 0; turn < 2; turn++) {
            ray.set(0.1, 0.2, 5, 0, 0, -1);
            checks.same("the object hit", 0, scene.nearest(ray, SceneIndex.NONE, 0));
        }
        BoxHierarchy tree = BoxHierarchy.over(boxes);
        ray.set(0.1, 0.2, 5, 0, 0, -1);
        int base = tree.enter(ray);
        int open = 0;
        while (tree.next(ray, base) != BoxHierarchy.DONE) {
            open = Math.max(open, ray.stackTop - base);
        }
        checks.atMost("open nodes", DEPTH, open);
    }

    private static void flake(NumericCase asked, Checks checks) {
        int level = (int) asked.inputs().integer("level");
        double radius = asked.inputs().number("root_radius");
        Sphereflake flake = new Sphereflake(FlakeKind.CLASSIC, level, Vector3.ZERO, radius);
        checks.size(radius);
        checks.same("spheres", asked.expected().integer("spheres"), (long) flake.sphereCount());
        int sphere = 0;
        double reach = 0;
        for (int k = 0; k <= level; k++) {
            Sphere at = flake.sphere(sphere);
            double area = 4 * Math.PI * (at.radius() * at.radius() * Math.pow(FlakeKind.CLASSIC.children(), k));
            checks.number("area_of_each_level", asked.expected().number("area_of_each_level"), area, ROUNDING * area);
            if (k == level) {
                checks.number("leaf_radius", at.radius());
                reach += at.radius();
                checks.number("reach_along_axis", asked.expected().number("reach_along_axis"), reach, ROUNDING * reach);
            } else {
                sphere = 1 + FlakeKind.CLASSIC.children() * sphere;
                reach += flake.sphere(sphere).centre().minus(at.centre()).length();
            }
        }
    }
}
