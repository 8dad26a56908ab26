package org.diacaustic.scenefile;

import org.diacaustic.math.Arithmetic;

/**
 * Cuts polygons in triangles: convex ones as a fan from the first corner, others by clipping ears [Meisters 1975] in the
 * coordinate plane that the polygon faces most. Corners need not lie exactly in a plane.
 */
final class PolygonCutter {
    /** Clipping takes time with the square of the corners, and the cube for hostile outlines. */
    static final int MOST_CONCAVE_CORNERS = 2000;

    static final String TOO_MANY_CORNERS =
            "a polygon that is not convex has more corners than the limit of " + MOST_CONCAVE_CORNERS;

    private final double[] vertices;
    private final IntList triangles;
    private int first;
    private int second;
    private int turn;
    private int uncertain;

    /**
     * @param vertices x, y, z of each
     * @param triangles where three indices for each triangle are added
     */
    PolygonCutter(double[] vertices, IntList triangles) {
        this.vertices = vertices;
        this.triangles = triangles;
    }

    /**
     * How many polygons were left without an ear, or with a triangle turned over: the outline crosses or touches itself.
     */
    int uncertainCount() {
        return uncertain;
    }

    /** Cuts a polygon of at least 3 vertex indices; false if it is concave with too many corners. */
    boolean cut(int[] polygon) {
        if (polygon.length == 3 || !choosePlane(polygon) || isConvex(polygon)) {
            for (int i = 2; i < polygon.length; i++) {
                add(polygon[0], polygon[i - 1], polygon[i]);
            }
            return true;
        }
        if (polygon.length > MOST_CONCAVE_CORNERS) {
            return false;
        }
        clipEars(polygon.clone());
        return true;
    }

    private void add(int a, int b, int c) {
        triangles.add(a);
        triangles.add(b);
        triangles.add(c);
    }

    /** Takes the axes in which the projected area is largest; false if it is zero in all. */
    private boolean choosePlane(int[] polygon) {
        double largest = 0;
        for (int axis = 0; axis < 3; axis++) {
            int u = (axis + 1) % 3;
            int v = (axis + 2) % 3;
            double area = 0;
            for (int i = 2; i < polygon.length; i++) {
                area += doubleArea(polygon[0], polygon[i - 1], polygon[i], u, v);
            }
            if (Math.abs(area) > largest) {
                largest = Math.abs(area);
                first = u;
                second = v;
                turn = area > 0 ? 1 : -1;
            }
        }
        return largest > 0;
    }

    private double doubleArea(int a, int b, int c, int u, int v) {
        double au = vertices[3 * a + u];
        double av = vertices[3 * a + v];
        return Arithmetic.differenceOfProducts(
                vertices[3 * b + u] - au, vertices[3 * c + v] - av, vertices[3 * b + v] - av, vertices[3 * c + u] - au);
    }

    /** Positive where a, b, c turn as the whole outline does. */
    private double side(int a, int b, int c) {
        return turn * doubleArea(a, b, c, first, second);
    }

    private boolean isConvex(int[] polygon) {
        int n = polygon.length;
        for (int i = 0; i < n; i++) {
            if (side(polygon[i], polygon[(i + 1) % n], polygon[(i + 2) % n]) < 0) {
                return false;
            }
        }
        return true;
    }

    private void clipEars(int[] rest) {
        int n = rest.length;
        boolean certain = true;
        int i = 0;
        int failures = 0;
        while (n > 3) {
            int before = rest[(i + n - 1) % n];
            int after = rest[(i + 1) % n];
            boolean ear = isEar(rest, n, before, rest[i], after);
            if (ear || failures == n) {
                certain &= ear;
                add(before, rest[i], after);
                System.arraycopy(rest, i + 1, rest, i, n - i - 1);
                n--;
                failures = 0;
                i %= n;
            } else {
                failures++;
                i = (i + 1) % n;
            }
        }
        certain &= side(rest[0], rest[1], rest[2]) >= 0;
        add(rest[0], rest[1], rest[2]);
        uncertain += certain ? 0 : 1;
    }

    private boolean isEar(int[] rest, int n, int a, int b, int c) {
        if (!(side(a, b, c) > 0)) {
            return false;
        }
        for (int i = 0; i < n; i++) {
            int p = rest[i];
            // A corner that lies on one of the ear's own, as where a hole is joined to the rim, does not block it.
            boolean own = isSamePoint(p, a) || isSamePoint(p, b) || isSamePoint(p, c);
            if (!own && side(a, b, p) >= 0 && side(b, c, p) >= 0 && side(c, a, p) >= 0) {
                return false;
            }
        }
        return true;
    }

    private boolean isSamePoint(int p, int q) {
        return p == q
                || vertices[3 * p] == vertices[3 * q]
                        && vertices[3 * p + 1] == vertices[3 * q + 1]
                        && vertices[3 * p + 2] == vertices[3 * q + 2];
    }
}
