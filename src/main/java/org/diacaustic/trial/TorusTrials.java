package org.diacaustic.trial;

import java.math.BigDecimal;
import org.diacaustic.math.Vector3;
import org.diacaustic.shape.Torus;
import org.diacaustic.stability.Checks;
import org.diacaustic.stability.NumericCase;
import org.diacaustic.stability.Operations;

/** Rays and tori, and roots of fourth degree that lie close together. */
final class TorusTrials {
    private TorusTrials() {}

    static void addTo(Operations operations) {
        operations.add(
                "ray_torus",
                "A Torus about the origin with its axis along y, asked as ray_sphere asks spheres until the ray leaves it for good."
                        + " Where a case lets pairs be missed: expected roots that lie closer to their neighbours than the"
                        + " tolerance are a group, of which any may be missing if it is even and all but one if it is odd; no"
                        + " more may be found than it has, each within the tolerance of one of it.",
                TorusTrials::torus);
    }

    private static void torus(NumericCase asked, Checks checks) {
        double major = asked.inputs().number("R");
        double minor = asked.inputs().number("r");
        Vector3 axis = asked.inputs().has("axis") ? RootTrials.vector(asked.inputs(), "axis") : Vector3.UNIT_Y;
        int count = (int) asked.expected().integer("n");
        double[] roots = LineRoots.of(
                        new Torus(Vector3.ZERO, axis, major, minor),
                        RootTrials.vector(asked.inputs(), "origin"),
                        RootTrials.vector(asked.inputs(), "dir"))
                .all(count);
        checks.size(major + minor);
        if (roots.length == count) {
            for (int i = 0; i < count; i++) {
                checks.number("x" + i, roots[i]);
            }
            checks.same("n", count, roots.length);
        } else if (asked.acceptable().stream().anyMatch(answer -> answer.contains("fewer roots"))) {
            groups(asked, checks, roots, count);
        } else {
            checks.same("n", count, roots.length);
        }
    }

    private static void groups(NumericCase asked, Checks checks, double[] roots, int count) {
        int begin = 0;
        int used = 0;
        while (begin < count) {
            int end = begin + 1;
            while (end < count && isClose(asked, end)) {
                end++;
            }
            int found = 0;
            while (used < roots.length && nearest(asked, roots[used], 0, count) < end) {
                int near = nearest(asked, roots[used], begin, end);
                checks.number("x" + near, roots[used]);
                used++;
                found++;
            }
            int size = end - begin;
            checks.rule(
                    "roots in the group from x" + begin,
                    size % 2 == 0 ? "0 to " + size : "1 to " + size,
                    Integer.toString(found),
                    found <= size && (size % 2 == 0 || found > 0));
            begin = end;
        }
        checks.note("of roots that lie closer together than their tolerance, " + roots.length + " of " + count
                + " are reported");
    }

    /** Whether an expected root lies closer to the one before it than its tolerance. */
    private static boolean isClose(NumericCase asked, int root) {
        BigDecimal gap =
                asked.expected().decimal("x" + root).subtract(asked.expected().decimal("x" + (root - 1)));
        return gap.abs().doubleValue() <= asked.tolerance().number("x" + root + "_abs", 0);
    }

    private static int nearest(NumericCase asked, double root, int begin, int end) {
        int nearest = begin;
        double distance = Double.POSITIVE_INFINITY;
        for (int i = begin; i < end; i++) {
            double off = Math.abs(asked.expected().number("x" + i) - root);
            if (off < distance) {
                distance = off;
                nearest = i;
            }
        }
        return nearest;
    }
}
