package org.diacaustic.shape;

import org.diacaustic.math.Arithmetic;

/**
 * Whether a point lies in a polygon of the plane, convex or not, by the even-odd rule: where edges cross each other,
 * what is surrounded twice is outside. Of two polygons that share an edge exactly one has a point of it, since an edge
 * owns its lower end only and the side of the point is decided with the exact sign [Haines 1994].
 */
public final class PolygonContainment {
    private PolygonContainment() {}

    /**
     * @param x coordinates of the vertices in order; the last is joined to the first
     * @param y as many
     */
    public static boolean contains(double[] x, double[] y, double pointX, double pointY) {
        boolean inside = false;
        for (int i = 0, k = x.length - 1; i < x.length; k = i++) {
            boolean above = y[i] > pointY;
            if (above == y[k] > pointY) {
                continue;
            }
            int low = above ? k : i;
            int high = above ? i : k;
            double side = Arithmetic.differenceOfProducts(
                    x[high] - pointX, y[low] - pointY, x[low] - pointX, y[high] - pointY);
            inside ^= side < 0;
        }
        return inside;
    }
}
