package org.diacaustic.map;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;

/**
 * The area that two convex polygons in the plane have in common, found without clipping: its corners are those of
 * either that are in the other, and where edges cross. Polygons are x and y of their corners in order.
 */
final class CommonArea {
    private CommonArea() {}

    static double of(double[] p, double[] q) {
        List<double[]> corners = new ArrayList<>();
        for (int i = 0; i < p.length; i += 2) {
            addIfIn(corners, p[i], p[i + 1], q);
            for (int j = 0; j < q.length; j += 2) {
                addCrossing(corners, p, i, q, j);
            }
        }
        for (int j = 0; j < q.length; j += 2) {
            addIfIn(corners, q[j], q[j + 1], p);
        }
        if (corners.size() < 3) {
            return 0;
        }
        double x = corners.stream().mapToDouble(c -> c[0]).average().orElseThrow();
        double y = corners.stream().mapToDouble(c -> c[1]).average().orElseThrow();
        corners.sort(Comparator.comparingDouble(c -> Math.atan2(c[1] - y, c[0] - x)));
        double[] polygon = corners.stream().flatMapToDouble(Arrays::stream).toArray();
        return area(polygon);
    }

    static double area(double[] p) {
        double twice = 0;
        for (int i = 0; i < p.length; i += 2) {
            int next = (i + 2) % p.length;
            twice += (p[i] - p[0]) * (p[next + 1] - p[1]) - (p[next] - p[0]) * (p[i + 1] - p[1]);
        }
        return Math.abs(twice) / 2;
    }

    private static void addIfIn(List<double[]> corners, double x, double y, double[] p) {
        int left = 0;
        int right = 0;
        for (int i = 0; i < p.length; i += 2) {
            int next = (i + 2) % p.length;
            double side = (p[next] - p[i]) * (y - p[i + 1]) - (p[next + 1] - p[i + 1]) * (x - p[i]);
            left += side > 0 ? 1 : 0;
            right += side < 0 ? 1 : 0;
        }
        if (left == 0 || right == 0) {
            corners.add(new double[] {x, y});
        }
    }

    private static void addCrossing(List<double[]> corners, double[] p, int i, double[] q, int j) {
        int pn = (i + 2) % p.length;
        int qn = (j + 2) % q.length;
        double px = p[pn] - p[i];
        double py = p[pn + 1] - p[i + 1];
        double qx = q[qn] - q[j];
        double qy = q[qn + 1] - q[j + 1];
        double determinant = px * qy - py * qx;
        double s = ((q[j] - p[i]) * qy - (q[j + 1] - p[i + 1]) * qx) / determinant;
        double t = ((q[j] - p[i]) * py - (q[j + 1] - p[i + 1]) * px) / determinant;
        if (s >= 0 && s <= 1 && t >= 0 && t <= 1) {
            corners.add(new double[] {p[i] + s * px, p[i + 1] + s * py});
        }
    }
}
