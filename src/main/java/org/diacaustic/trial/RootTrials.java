package org.diacaustic.trial;

import java.util.Arrays;
import org.diacaustic.math.Quadratic;
import org.diacaustic.math.Vector3;
import org.diacaustic.shape.Ellipsoid;
import org.diacaustic.shape.Quadric;
import org.diacaustic.shape.Sphere;
import org.diacaustic.stability.Checks;
import org.diacaustic.stability.NumericCase;
import org.diacaustic.stability.Operations;
import org.diacaustic.stability.Values;

/** Rays and surfaces of second degree, and the quadratic equation behind them. */
final class RootTrials {
    /** Farther roots may be left out where a case says so. */
    private static final double FAR = 1e12;

    /** A discriminant below so many units in the last place of b² may have any sign, where a case says so. */
    private static final double UNCERTAIN = 16;

    private RootTrials() {}

    static void addTo(Operations operations) {
        operations.add(
                "quadratic",
                "Quadratic.solve, which quadrics, cylinders and cones ask. The number of roots and the roots themselves, both of"
                        + " which must be there.",
                RootTrials::quadratic);
        operations.add(
                "ray_sphere",
                "A Sphere asked as a render asks it: t0 by intersect, t1 by a ray that leaves the completed first hit, and what is"
                        + " behind the start by a ray the other way. t is in lengths of the direction. A start on the sphere is t0"
                        + " = 0, and a ray that leaves it there must meet t1 first.",
                RootTrials::sphere);
        operations.add(
                "ray_ellipsoid",
                "An Ellipsoid about the origin, asked as ray_sphere asks spheres; the normal is that of the completed first hit.",
                RootTrials::ellipsoid);
        operations.add(
                "ray_quadric_thesis_form",
                "A Quadric of the ten coefficients, asked as ray_sphere asks spheres. Where a case lets far roots be dropped,"
                        + " those beyond 1e12 are not compared.",
                RootTrials::quadric);
    }

    private static void quadratic(NumericCase asked, Checks checks) {
        double a = asked.inputs().number("a");
        double b = asked.inputs().number("b");
        double c = asked.inputs().number("c");
        double[] roots = new double[2];
        int count = Quadratic.solve(a, b, c, roots);
        checks.size(Math.max(
                Math.abs(asked.expected().number("x0", 0)),
                Math.abs(asked.expected().number("x1", 0))));
        int expected = (int) asked.expected().integer("n");
        boolean isDouble = count == 2 && roots[0] == roots[1];
        if (isDouble && expected == 1) {
            count = 1;
        }
        if (count != expected && mayBeEither(asked, a, b, c)) {
            checks.holds("either a double root or none", count == 0 || isDouble)
                    .note("the discriminant is within " + UNCERTAIN + " ulp of b²: " + count + " roots");
            return;
        }
        compare(asked, checks, Arrays.copyOf(roots, count));
    }

    private static boolean mayBeEither(NumericCase asked, double a, double b, double c) {
        return !asked.acceptable().isEmpty() && Math.abs(b * b - 4 * a * c) <= UNCERTAIN * Math.ulp(b * b);
    }

    private static void sphere(NumericCase asked, Checks checks) {
        double radius = asked.inputs().number("radius");
        LineRoots line = LineRoots.of(
                new Sphere(vector(asked.inputs(), "center"), radius),
                vector(asked.inputs(), "origin"),
                vector(asked.inputs(), "dir"));
        checks.size(radius);
        closed(asked, checks, line);
    }

    private static void ellipsoid(NumericCase asked, Checks checks) {
        Vector3 axes = vector(asked.inputs(), "axes");
        Vector3 centre = asked.inputs().has("center") ? vector(asked.inputs(), "center") : Vector3.ZERO;
        LineRoots line = LineRoots.of(
                new Ellipsoid(centre, axes), vector(asked.inputs(), "origin"), vector(asked.inputs(), "dir"));
        checks.size(Math.max(axes.x(), Math.max(axes.y(), axes.z())));
        closed(asked, checks, line);
        if (asked.expected().has("nx")) {
            checks.size(0);
            checks.number("nx", line.first().normalX);
            checks.number("ny", line.first().normalY);
            checks.number("nz", line.first().normalZ);
        }
    }

    private static void closed(NumericCase asked, Checks checks, LineRoots line) {
        Values expected = asked.expected();
        boolean bothKnown = expected.has("t0") && expected.has("t1");
        double[] roots = bothKnown ? line.all(2) : line.all();
        boolean startsOnSurface = Arrays.stream(roots).anyMatch(root -> root == 0);
        checks.same("hit", expected.flag("hit"), line.isAhead());
        if (!bothKnown) {
            if (expected.has("t0")) {
                checks.number("t0", roots.length > 0 ? roots[0] : Double.NaN);
            }
            return;
        }
        checks.number("t0", roots.length > 0 ? roots[0] : Double.NaN);
        checks.number("t1", roots.length > 1 ? roots[1] : Double.NaN);
        if (startsOnSurface && roots.length == 2 && roots[1] > 0) {
            checks.number("t of a ray that leaves the start", expected.decimal("t1"), line.afterLeavingStart(), "t1");
        }
        checks.note("t is in lengths of the direction");
    }

    private static void quadric(NumericCase asked, Checks checks) {
        double[] coefficients = asked.inputs().numbers("coef");
        LineRoots line =
                LineRoots.of(Quadric.of(coefficients), vector(asked.inputs(), "origin"), vector(asked.inputs(), "dir"));
        int count = (int) asked.expected().integer("n");
        double[] roots = line.all(count);
        checks.size(1);
        boolean farMayBeDropped = asked.acceptable().stream().anyMatch(answer -> answer.contains("farther than"));
        if (farMayBeDropped && roots.length != count) {
            checks.note("a root beyond " + FAR + " is left out of account");
            near(asked, checks, roots);
        } else {
            compare(asked, checks, roots);
        }
    }

    /** Compares the roots that are not far, which must be as many on both sides. */
    private static void near(NumericCase asked, Checks checks, double[] roots) {
        double[] found =
                Arrays.stream(roots).filter(root -> Math.abs(root) <= FAR).toArray();
        int place = 0;
        for (int i = 0; i < asked.expected().integer("n"); i++) {
            if (Math.abs(asked.expected().number("x" + i)) <= FAR) {
                checks.number("x" + i, place < found.length ? found[place] : Double.NaN);
                place++;
            }
        }
        checks.same("number of roots within " + FAR, place, found.length);
    }

    private static void compare(NumericCase asked, Checks checks, double[] roots) {
        checks.same("n", asked.expected().integer("n"), (long) roots.length);
        for (int i = 0; i < roots.length && asked.expected().has("x" + i); i++) {
            checks.number("x" + i, roots[i]);
        }
    }

    static Vector3 vector(Values values, String key) {
        double[] v = values.vector(key);
        return new Vector3(v[0], v[1], v[2]);
    }
}
