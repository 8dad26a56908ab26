package org.diacaustic.map;

/**
 * How much of a triangle is on the positive side of some planes, from nothing but the distances of its vertices to
 * them. It is cut in barycentric coordinates, where every triangle is the same half of a unit square: no area is
 * divided by, and slivers, lines and points are triangles like any others.
 *
 * <p>Which vertices are on which side is anyone's guess, so that code which branches on it waits for its guesses most of the
 * time. Signs are taken from the bits of numbers instead. Working storage of one task.
 */
final class TriangleClip {
    /**
     * Exactly, a triangle gains at most a vertex for each of 4 planes. Where rounding makes every second vertex lie on the
     * other side, n become at most 3n/2; and one is written before it is known whether it is wanted.
     */
    private static final int ROOM = 16;

    /** By the signs of the three distances as bits, 1 for negative: the vertex that is alone on its side. */
    private static final int[] LONE = {0, 0, 1, 2, 2, 1, 0, 0};

    /** Likewise: 1 if the lone vertex is on the negative side, so that its corner is what is missing. */
    private static final double[] WHOLE = {1, 1, 1, 0, 1, 0, 0, 0};

    private static final double THIRD = 1.0 / 3;

    /** Of smaller parts, rounding says where their middle is. */
    private static final double LEAST_PART = 0x1p-40;

    private double middleU;
    private double middleV;

    /** Three numbers a plane: the distances of the vertices, on any scale. */
    private final double[] distances = new double[3 * (Footprint.LARGEST_CORNERS + 1)];

    private int planes;

    /** Negative if all of the triangle is on the wrong side of a plane. */
    private long outside;

    /** The weights of the second and third vertex at every vertex of what is left. */
    private double[] u = new double[ROOM];

    private double[] v = new double[ROOM];
    private double[] otherU = new double[ROOM];
    private double[] otherV = new double[ROOM];
    private int count;

    void begin() {
        planes = 0;
        outside = 0;
    }

    /**
     * Adds a plane, unless all of the triangle is on its positive side; at most 4.
     *
     * @param first the distance of the first vertex, as are the others
     * @param holdsPlane whether what lies in the plane is on the positive side
     */
    void add(double first, double second, double third, boolean holdsPlane) {
        int i = 3 * planes;
        // No zero has a sign then.
        double a = first + 0.0;
        double b = second + 0.0;
        double c = third + 0.0;
        distances[i] = a;
        distances[i + 1] = b;
        distances[i + 2] = c;
        long p = Double.doubleToRawLongBits(a);
        long q = Double.doubleToRawLongBits(b);
        long r = Double.doubleToRawLongBits(c);
        // The bits of 0 less 1 are those of a negative number.
        long lean = holdsPlane ? 0 : 1;
        outside |= p - lean & q - lean & r - lean;
        planes += (int) ((p | q | r) >>> 63);
    }

    /** The weight of the second vertex at the middle of what {@link #fraction} found. */
    double middleU() {
        return middleU;
    }

    /** The weight of the third. */
    double middleV() {
        return middleV;
    }

    /** The part of the triangle that is on the positive side of all planes. */
    double fraction() {
        middleU = THIRD;
        middleV = THIRD;
        if (outside < 0) {
            return 0;
        }
        if (planes <= 1) {
            return planes == 0 ? 1 : fractionOfOne();
        }
        u[0] = 0;
        v[0] = 0;
        u[1] = 1;
        v[1] = 0;
        u[2] = 0;
        v[2] = 1;
        count = 3;
        for (int i = 0; i < 3 * planes && count > 0; i += 3) {
            cut(distances[i], distances[i + 1], distances[i + 2]);
        }
        double twice = 0;
        double sumU = 0;
        double sumV = 0;
        for (int i = 2; i < count; i++) {
            double part = (u[i - 1] - u[0]) * (v[i] - v[0]) - (u[i] - u[0]) * (v[i - 1] - v[0]);
            twice += part;
            sumU += part * (u[i - 1] - u[0] + u[i] - u[0]);
            sumV += part * (v[i - 1] - v[0] + v[i] - v[0]);
        }
        if (twice > LEAST_PART) {
            middleU = u[0] + THIRD * sumU / twice;
            middleV = v[0] + THIRD * sumV / twice;
        } else if (count > 0) {
            middleU = u[0];
            middleV = v[0];
        }
        return Math.min(1, Math.max(0, twice));
    }

    /** The part on the positive side of the only plane: the corner at the lone vertex, or what that leaves. */
    private double fractionOfOne() {
        int signs = (int) (sign(distances[0]) | sign(distances[1]) << 1 | sign(distances[2]) << 2);
        int lone = LONE[signs];
        double distance = distances[lone];
        double other = distances[lone == 2 ? 0 : lone + 1];
        double another = distances[lone == 0 ? 2 : lone - 1];
        double next = distance / (distance - other);
        double last = distance / (distance - another);
        double corner = next * last;
        // The middle of the corner, from weights 1, 0, 0 of the lone vertex on.
        double ofNext = THIRD * next;
        double ofLast = THIRD * last;
        double left = 1 - corner;
        if (WHOLE[signs] == 1 && left > LEAST_PART) {
            ofNext = (THIRD - corner * ofNext) / left;
            ofLast = (THIRD - corner * ofLast) / left;
        }
        double ofLone = 1 - ofNext - ofLast;
        middleU = lone == 0 ? ofNext : lone == 1 ? ofLone : ofLast;
        middleV = lone == 0 ? ofLast : lone == 1 ? ofNext : ofLone;
        return Math.abs(WHOLE[signs] - corner);
    }

    private static long sign(double value) {
        return Double.doubleToRawLongBits(value) >>> 63;
    }

    /** Leaves what is on the positive side of a plane [Sutherland and Hodgman 1974]. */
    private void cut(double first, double second, double third) {
        double alongU = second - first;
        double alongV = third - first;
        double uBefore = u[count - 1];
        double vBefore = v[count - 1];
        double before = first + uBefore * alongU + vBefore * alongV + 0.0;
        int kept = 0;
        for (int i = 0; i < count; i++) {
            double uHere = u[i];
            double vHere = v[i];
            double here = first + uHere * alongU + vHere * alongV + 0.0;
            double t = before / (before - here);
            otherU[kept] = uBefore + t * (uHere - uBefore);
            otherV[kept] = vBefore + t * (vHere - vBefore);
            kept += (int) (sign(before) ^ sign(here));
            otherU[kept] = uHere;
            otherV[kept] = vHere;
            kept += (int) (1 - sign(here));
            uBefore = uHere;
            vBefore = vHere;
            before = here;
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
