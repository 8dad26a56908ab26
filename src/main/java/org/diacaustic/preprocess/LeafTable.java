package org.diacaustic.preprocess;

import java.util.Arrays;
import org.diacaustic.map.SurfacePoint;
import org.diacaustic.math.Arithmetic;
import org.diacaustic.math.Rgb;

/**
 * Light rays, by number, and the leaves of each: where parts of it landed on diffuse surfaces, by which path, with how much
 * power for a unit of light space. Arrays of one task, used again for its next part.
 */
final class LeafTable {
    /** Where the power of a ray went: emitted, stored, absorbed, escaped, cut. */
    static final int BOOKS = 5;

    private static final int PLACE = 9;

    /** The cosine of the angle that normals within one cell may span: more is an edge, or too round for a flat cell. */
    private static final double ALIKE_COSINE = 0.866;

    /** The sine of the angle to the surface at which it may run from one corner of a cell to another. */
    private static final double STEEPEST_SINE = 0.35;

    /** Of coordinates, with a wide margin. */
    private static final double ROUNDING = 0x1p-40;

    private int rays;
    private int[] firstLeaf = new int[64];
    private double[] books = new double[64 * BOOKS];
    /** Two numbers for each ray. */
    private double[] aimed = new double[2 * 64];

    private int leaves;
    private long[] signature = new long[128];
    private int[] receiver = new int[128];
    /** The part of the ray that came here, the largest colour. */
    private float[] weight = new float[128];
    /** Point, normal and power for each leaf. */
    private double[] place = new double[128 * PLACE];

    /** Forgets all rays. */
    void clear() {
        rays = 0;
        leaves = 0;
    }

    int size() {
        return rays;
    }

    /** Starts a ray, to which what is added from now on belongs, and gives its number. */
    int startRay() {
        if (rays + 1 >= firstLeaf.length) {
            firstLeaf = Arrays.copyOf(firstLeaf, 2 * firstLeaf.length);
            books = Arrays.copyOf(books, 2 * books.length);
            aimed = Arrays.copyOf(aimed, 2 * aimed.length);
        }
        firstLeaf[rays] = leaves;
        firstLeaf[rays + 1] = leaves;
        Arrays.fill(books, rays * BOOKS, rays * BOOKS + BOOKS, 0);
        return rays++;
    }

    /** Notes at which place of its chart a ray was aimed. */
    void aimed(int ray, double p, double q) {
        aimed[2 * ray] = p;
        aimed[2 * ray + 1] = q;
    }

    double aimedP(int ray) {
        return aimed[2 * ray];
    }

    double aimedQ(int ray) {
        return aimed[2 * ray + 1];
    }

    /** Books power of the last ray, all colours together, for a unit of light space. */
    void book(int account, double power) {
        books[(rays - 1) * BOOKS + account] += power;
    }

    /** What was booked for a ray. */
    double booked(int ray, int account) {
        return books[ray * BOOKS + account];
    }

    /** Adds a leaf to the last ray. */
    void addLeaf(long path, double part, SurfacePoint at, Rgb power) {
        if (leaves == signature.length) {
            int size = 2 * leaves;
            signature = Arrays.copyOf(signature, size);
            receiver = Arrays.copyOf(receiver, size);
            weight = Arrays.copyOf(weight, size);
            place = Arrays.copyOf(place, size * PLACE);
        }
        signature[leaves] = path;
        receiver[leaves] = at.object << 1 | (at.front ? 1 : 0);
        weight[leaves] = (float) part;
        int i = leaves * PLACE;
        place[i] = at.x;
        place[i + 1] = at.y;
        place[i + 2] = at.z;
        place[i + 3] = at.normalX;
        place[i + 4] = at.normalY;
        place[i + 5] = at.normalZ;
        place[i + 6] = power.red;
        place[i + 7] = power.green;
        place[i + 8] = power.blue;
        leaves++;
        firstLeaf[rays] = leaves;
    }

    int firstLeaf(int ray) {
        return firstLeaf[ray];
    }

    int endLeaf(int ray) {
        return firstLeaf[ray + 1];
    }

    /** Which way a leaf came, with its end. */
    long signature(int leaf) {
        return signature[leaf];
    }

    /** The leaf of a ray that came the same way as a given leaf, to a surface that goes on there; −1 if there is none. */
    int alike(int leaf, int ray) {
        long path = signature[leaf];
        for (int i = firstLeaf[ray]; i < firstLeaf[ray + 1]; i++) {
            if (signature[i] == path) {
                return goesOn(leaf * PLACE, i * PLACE) ? i : -1;
            }
        }
        return -1;
    }

    /** Whether two places may lie on one smooth surface, and not across an edge or a gap of it. */
    private boolean goesOn(int a, int b) {
        double x = place[b] - place[a];
        double y = place[b + 1] - place[a + 1];
        double z = place[b + 2] - place[a + 2];
        double rounding = ROUNDING * (size(a) + size(b));
        double steepest = STEEPEST_SINE * Arithmetic.length(x, y, z) + rounding;
        double cosine = place[a + 3] * place[b + 3] + place[a + 4] * place[b + 4] + place[a + 5] * place[b + 5];
        return cosine > ALIKE_COSINE
                && Math.abs(place[a + 3] * x + place[a + 4] * y + place[a + 5] * z) <= steepest
                && Math.abs(place[b + 3] * x + place[b + 4] * y + place[b + 5] * z) <= steepest;
    }

    private double size(int i) {
        return Math.abs(place[i]) + Math.abs(place[i + 1]) + Math.abs(place[i + 2]);
    }

    /** Whether all leaves of either ray that carry at least such a part have one in the other that came the same way. */
    boolean agree(int a, int b, double significant) {
        return contains(a, b, significant) && contains(b, a, significant);
    }

    /** Whether the rays of a cell's corners, in order around it, and of a place inside agree. */
    boolean agree(int p, int q, int r, int s, int inside, double significant) {
        return agree(p, q, significant)
                && agree(q, r, significant)
                && agree(r, s, significant)
                && agree(s, p, significant)
                && (inside == p || agree(inside, p, significant));
    }

    private boolean contains(int all, int some, double significant) {
        for (int leaf = firstLeaf[some]; leaf < firstLeaf[some + 1]; leaf++) {
            if (weight[leaf] >= significant && alike(leaf, all) < 0) {
                return false;
            }
        }
        return true;
    }

    /** Sets where a leaf is. */
    void place(int leaf, SurfacePoint out) {
        int i = leaf * PLACE;
        out.x = place[i];
        out.y = place[i + 1];
        out.z = place[i + 2];
        out.normalX = place[i + 3];
        out.normalY = place[i + 4];
        out.normalZ = place[i + 5];
        out.object = receiver[leaf] >>> 1;
        out.front = (receiver[leaf] & 1) != 0;
    }

    /** Adds the power of a leaf, for so much of light space. */
    void addPower(int leaf, double measure, Rgb out) {
        int i = leaf * PLACE;
        out.add(measure * place[i + 6], measure * place[i + 7], measure * place[i + 8]);
    }
}
