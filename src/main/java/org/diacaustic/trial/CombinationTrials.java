package org.diacaustic.trial;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import org.diacaustic.math.Ray;
import org.diacaustic.math.Vector3;
import org.diacaustic.shape.Box;
import org.diacaustic.shape.Combination;
import org.diacaustic.shape.Hit;
import org.diacaustic.shape.Shape;
import org.diacaustic.stability.CaseFault;
import org.diacaustic.stability.Checks;
import org.diacaustic.stability.NumericCase;
import org.diacaustic.stability.Operations;
import org.diacaustic.stability.Values;

/** Solids made of solids. */
final class CombinationTrials {
    /** Boxes are built of stretches between these only: of longer ones a ray's t keeps no digits. */
    private static final double FARTHEST = 0x1p40;

    /** The rounding of a face of a box, with a margin. */
    private static final double FACE_ERROR = 0x1p-44;

    private CombinationTrials() {}

    static void addTo(Operations operations) {
        operations.add(
                "csg_intervals",
                "The code by which combined shapes go through the boundaries of their parts, given the ends of the stretches; and,"
                        + " where A and B are one stretch each, a ray through two boxes that are as thick, combined,"
                        + " if none of their faces are one but for rounding. Stretches of no"
                        + " length are left out, and those that touch become one.",
                CombinationTrials::intervals);
    }

    private static void intervals(NumericCase asked, Checks checks) {
        double[] a = stretches(asked.inputs(), "A");
        double[] b = stretches(asked.inputs(), "B");
        for (Combination.Kind kind : Combination.Kind.values()) {
            String name = kind.name().toLowerCase(Locale.ROOT);
            if (asked.expected().has(name)) {
                double[] expected = stretches(asked.expected(), name);
                checks.same(name, Arrays.toString(expected), Arrays.toString(kind.intervals(a, b)));
                if (isBox(a) && isBox(b) && areToldApart(a, b)) {
                    checks.same(name + " of boxes", Arrays.toString(expected), Arrays.toString(ofBoxes(kind, a, b)));
                }
            }
        }
    }

    /** One stretch as two numbers, or a list of them; in order, and without those that have no length. */
    private static double[] stretches(Values values, String key) {
        List<?> list = values.list(key);
        double[][] rows = !list.isEmpty() && !(list.get(0) instanceof List<?>)
                ? new double[][] {values.numbers(key)}
                : values.rows(key);
        List<double[]> stretches = new ArrayList<>();
        for (double[] row : rows) {
            if (row.length != 2) {
                throw new CaseFault(key + " should be two numbers, or a list of two each, but is " + list);
            }
            if (row[0] < row[1]) {
                stretches.add(row);
            }
        }
        stretches.sort(Comparator.comparingDouble(row -> row[0]));
        return stretches.stream().flatMapToDouble(Arrays::stream).toArray();
    }

    private static boolean isBox(double[] stretch) {
        return stretch.length == 2 && Math.abs(stretch[0]) < FARTHEST && Math.abs(stretch[1]) < FARTHEST;
    }

    /** Whether ends are the same or farther apart than boxes know their faces. */
    private static boolean areToldApart(double[] a, double[] b) {
        boolean apart = true;
        for (double x : a) {
            for (double y : b) {
                double gap = Math.abs(x - y);
                apart &= gap == 0 || gap > FACE_ERROR * Math.max(1, Math.max(Math.abs(x), Math.abs(y)));
            }
        }
        return apart;
    }

    /** Where a ray along x from x = −1 before both enters the combination and leaves it, in x. */
    private static double[] ofBoxes(Combination.Kind kind, double[] a, double[] b) {
        Shape shape;
        try {
            shape = new Combination(kind, box(a), box(b));
        } catch (IllegalArgumentException apart) {
            return new double[0];
        }
        double[] ends = new double[8];
        int count = 0;
        Ray ray = new Ray();
        ray.set(new Vector3(Math.min(a[0], b[0]) - 1, 0.5, 0.5), Vector3.UNIT_X);
        Hit hit = new Hit();
        while (count < ends.length && shape.intersect(ray)) {
            hit.take(ray);
            shape.complete(ray, hit);
            ends[count++] = hit.x;
            ray.set(hit.x, hit.y, hit.z, 1, 0, 0);
            ray.leaving = hit.primitive;
            ray.departureError = hit.pointError;
        }
        return Arrays.copyOf(ends, count);
    }

    private static Box box(double[] stretch) {
        return new Box(new Vector3(stretch[0], 0, 0), new Vector3(stretch[1], 1, 1));
    }
}
