package org.diacaustic.map;

/**
 * How much of a triangle is on the positive side of some planes, from nothing but the distances of its vertices to
 * them. It is cut in barycentric coordinates, where every triangle is the same half of a unit square: no area is
 * divided by, and slivers, lines and points are triangles like any others. Working storage of one task.
 */
final class TriangleClip {
    /** A triangle has gained a vertex for each plane. */
    private static final int LARGEST = 3 + Footprint.LARGEST_CORNERS;

    /** Three numbers a plane: the distances of the vertices, on any scale, not all of the same sign. */
    private final double[] distances = new double[3 * Footprint.LARGEST_CORNERS];

    private int planes;

    /** The weights of the second and third vertex at every vertex of what is left. */
    private double[] u = new double[LARGEST];

    private double[] v = new double[LARGEST];
    private double[] otherU = new double[LARGEST];
    private double[] otherV = new double[LARGEST];
    private int count;

    void begin() {
        planes = 0;
    }

    /** Adds a plane that some of the vertices are on the wrong side of. */
    void add(double first, double second, double third) {
        int i = 3 * planes++;
        distances[i] = first;
        distances[i + 1] = second;
        distances[i + 2] = third;
    }

    /** The part of the triangle that is inside of all planes. */
    double fraction() {
        if (planes == 0) {
            return 1;
        }
        if (planes == 1) {
            return fraction(distances[0], distances[1], distances[2]);
        }
        u[0] = 0;
        v[0] = 0;
        u[1] = 1;
        v[1] = 0;
        u[2] = 0;
        v[2] = 1;
        count = 3;
        for (int i = 0; i < 3 * planes; i += 3) {
            cut(distances[i], distances[i + 1], distances[i + 2]);
        }
        double twice = 0;
        for (int i = 2; i < count; i++) {
            twice += (u[i - 1] - u[0]) * (v[i] - v[0]) - (u[i] - u[0]) * (v[i - 1] - v[0]);
        }
        return Math.min(1, Math.max(0, twice));
    }

    /** The part of the triangle that is on the positive side of the only plane. */
    private static double fraction(double first, double second, double third) {
        if (first > 0) {
            if (second > 0) {
                return 1 - corner(third, first, second);
            }
            return third > 0 ? 1 - corner(second, third, first) : corner(first, second, third);
        }
        if (second > 0) {
            return third > 0 ? 1 - corner(first, second, third) : corner(second, third, first);
        }
        return corner(third, first, second);
    }

    /** The part of a triangle that is on the same side of a plane as one vertex, when the other two are not. */
    private static double corner(double distance, double other, double another) {
        return distance / (distance - other) * (distance / (distance - another));
    }

    /** Leaves what is on the positive side of a plane [Sutherland and Hodgman 1974]. */
    private void cut(double first, double second, double third) {
        double alongU = second - first;
        double alongV = third - first;
        int kept = 0;
        int before = count - 1;
        double distanceBefore = count == 0 ? 0 : first + u[before] * alongU + v[before] * alongV;
        for (int i = 0; i < count; i++) {
            double distance = first + u[i] * alongU + v[i] * alongV;
            if (distanceBefore < 0 && distance > 0 || distanceBefore > 0 && distance < 0) {
                double t = distanceBefore / (distanceBefore - distance);
                otherU[kept] = u[before] + t * (u[i] - u[before]);
                otherV[kept++] = v[before] + t * (v[i] - v[before]);
            }
            if (distance >= 0) {
                otherU[kept] = u[i];
                otherV[kept++] = v[i];
            }
            before = i;
            distanceBefore = distance;
        }
        double[] swapU = u;
        u = otherU;
        otherU = swapU;
        double[] swapV = v;
        v = otherV;
        otherV = swapV;
        count = kept;
    }
}
