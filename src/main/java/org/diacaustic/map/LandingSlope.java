package org.diacaustic.map;

import org.diacaustic.math.Rgb;

/**
 * How the place where a light ray lands moves with the ray: the derivative by central differences of ever smaller steps,
 * extrapolated to none, at the step where rounding has not yet taken over from curvature [Ridders 1982, "Accurate computation of
 * F'(x) and F'(x)F''(x)"]. Working storage of one task.
 */
final class LandingSlope {
    /** The first step, in parts of the cell; half as wide where rays that far away go another way. */
    private static final double WIDEST = 1;

    private static final int LEVELS = 12;

    /** Smaller steps are not worth it once they change the result by so many times its error. */
    private static final double WORSE = 2;

    /** But with a larger relative error than this they are: wide steps may have come to what is no neighbour. */
    private static final double GOOD = 0x1p-20;

    private final LightPaths paths;
    private final SurfacePoint landing = new SurfacePoint();
    private final Rgb unread = new Rgb();

    /** The last two rows of the table: three numbers for each order. */
    private double[] row = new double[3 * LEVELS];

    private double[] above = new double[3 * LEVELS];
    private double error;

    /** The derivative, in scene units. */
    double x;

    double y;
    double z;

    LandingSlope(LightPaths paths) {
        this.paths = paths;
    }

    /**
     * Finds the derivative at (s, t) along (ds, dt), of rays of the cell that was entered last.
     *
     * @return false if rays nearby go other ways however near they are; then the derivative is of no meaning
     */
    boolean find(double s, double t, double ds, double dt) {
        error = Double.POSITIVE_INFINITY;
        int rows = 0;
        double step = WIDEST;
        for (int level = 0; level < LEVELS; level++) {
            double[] oldest = above;
            above = row;
            row = oldest;
            if (!follow(s + step * ds, t + step * dt, 0.5 / step, false)
                    || !follow(s - step * ds, t - step * dt, -0.5 / step, true)) {
                rows = 0;
                error = Double.POSITIVE_INFINITY;
            } else if (extrapolate(rows++)) {
                return true;
            }
            step *= 0.5;
        }
        return error < Double.POSITIVE_INFINITY;
    }

    /** Adds where a ray lands, times a weight, to the first place of the row, or begins with it. */
    private boolean follow(double s, double t, double weight, boolean isSecond) {
        if (!paths.follow(s, t, landing, unread)) {
            return false;
        }
        row[0] = weight * landing.x + (isSecond ? row[0] : 0);
        row[1] = weight * landing.y + (isSecond ? row[1] : 0);
        row[2] = weight * landing.z + (isSecond ? row[2] : 0);
        return true;
    }

    /** Fills the row, whose first place is there; true if it brings nothing any more. */
    private boolean extrapolate(int number) {
        double power = 1;
        for (int i = 3; i <= 3 * number; i += 3) {
            power *= 4;
            double off = 0;
            for (int axis = i; axis < i + 3; axis++) {
                double change = (row[axis - 3] - above[axis - 3]) / (power - 1);
                row[axis] = row[axis - 3] + change;
                off += Math.max(Math.abs(change), Math.abs(row[axis] - above[axis - 3]));
            }
            if (off <= error) {
                error = off;
                x = row[i];
                y = row[i + 1];
                z = row[i + 2];
            }
        }
        double size = Math.abs(x) + Math.abs(y) + Math.abs(z);
        return number > 0 && error <= GOOD * size && change(number) >= WORSE * error;
    }

    private double change(int number) {
        int last = 3 * number;
        return Math.abs(row[last] - above[last - 3])
                + Math.abs(row[last + 1] - above[last - 2])
                + Math.abs(row[last + 2] - above[last - 1]);
    }
}
