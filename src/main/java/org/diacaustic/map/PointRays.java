package org.diacaustic.map;

import java.util.Arrays;
import org.diacaustic.math.Rgb;

/**
 * The light rays that land at a point, each counted once: where cells of different sizes meet, or on a round surface, a point
 * may be in the triangles of two cells that find the same ray. Working storage of one task.
 */
final class PointRays {
    /** Rays of one way nearer than this are the same, in parts of their cells. */
    private static final double SAME = 1.0 / 16;

    /** A ray so far outside of a cell, in parts of it, is taken to be on its edge. */
    private static final double EDGE = 0x1p-20;

    private final CellSeeds seeds;
    private final RaySolver solver;
    private final CellSeed seed = new CellSeed();
    private final Rgb irradiance = new Rgb();
    private final Rgb sum = new Rgb();
    private SurfacePoint at;
    private int count;
    private int[] charts = new int[8];
    private long[] paths = new long[8];

    /** Of each ray: place on its chart, and extents of its cell there; p and q. */
    private double[] places = new double[4 * 8];

    PointRays(CellSeeds seeds, LightPaths lightPaths) {
        this.seeds = seeds;
        this.solver = new RaySolver(lightPaths);
    }

    void start(SurfacePoint point) {
        at = point;
        count = 0;
        sum.set(0, 0, 0);
    }

    /**
     * Adds the ray that lands at the point, if it is not among the others yet.
     *
     * @param cell whose triangle the point is in
     * @param s the weight of the triangle's second vertex at the point, as {@code t} is of the third
     * @param orientation positive if the triangle is counterclockwise about the point's normal, else negative
     * @param depth how far along the normal the ray may land, in scene units
     * @return false if no ray is found
     */
    boolean add(int cell, double s, double t, double orientation, double depth) {
        if (!seeds.read(cell, seed) || !solver.solve(seed, at, s, t, orientation, depth, irradiance)) {
            return false;
        }
        if (isNew()) {
            sum.add(irradiance);
        }
        return true;
    }

    /**
     * Adds the ray that lands at the point beside a cell's triangle, if it is one of the cell: where the edges of cells are bent,
     * or rounded, a triangle is not all that its cell lights. The numbers are those of {@link #add}.
     *
     * @return whether the cell has such a ray
     */
    boolean addBeside(int cell, double s, double t, double orientation, double depth) {
        if (!seeds.read(cell, seed) || !solver.solve(seed, at, s, t, orientation, depth, irradiance)) {
            return false;
        }
        if (!(solver.s() >= -EDGE && solver.t() >= -EDGE && solver.s() + solver.t() <= 1 + EDGE)) {
            return false;
        }
        if (isNew()) {
            sum.add(irradiance);
        }
        return true;
    }

    /** Notes the ray that was found last; false if it is there already. */
    private boolean isNew() {
        double p = place(seed.p0, seed.p1, seed.p2);
        double q = place(seed.q0, seed.q1, seed.q2);
        double extentP = extent(seed.p0, seed.p1, seed.p2);
        double extentQ = extent(seed.q0, seed.q1, seed.q2);
        for (int i = 0; i < count; i++) {
            if (paths[i] == seed.path
                    && charts[i] == seed.chart
                    && Math.abs(places[4 * i] - p) <= SAME * Math.min(places[4 * i + 2], extentP)
                    && Math.abs(places[4 * i + 1] - q) <= SAME * Math.min(places[4 * i + 3], extentQ)) {
                return false;
            }
        }
        if (count == paths.length) {
            charts = Arrays.copyOf(charts, 2 * count);
            paths = Arrays.copyOf(paths, 2 * count);
            places = Arrays.copyOf(places, 8 * count);
        }
        charts[count] = seed.chart;
        paths[count] = seed.path;
        places[4 * count] = p;
        places[4 * count + 1] = q;
        places[4 * count + 2] = extentP;
        places[4 * count + 3] = extentQ;
        count++;
        return true;
    }

    private double place(double first, double second, double third) {
        return first + solver.s() * (second - first) + solver.t() * (third - first);
    }

    private static double extent(double first, double second, double third) {
        return Math.max(first, Math.max(second, third)) - Math.min(first, Math.min(second, third));
    }

    /** The irradiance of all rays that were added, in W·m⁻². */
    Rgb sum() {
        return sum;
    }
}
