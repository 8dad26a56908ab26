package org.diacaustic.map;

import org.diacaustic.math.Arithmetic;
import org.diacaustic.math.Rgb;

/**
 * Finds the light ray of a cell that lands at a point, and the density of light there: Newton's method in light space
 * [Mitchell and Hanrahan 1992], with derivatives by central differences, and better ones for the ray that was found. Working
 * storage of one task.
 */
final class RaySolver {
    /** How far outside its cell a ray may be, in parts of the cell: the edges of cells on a receiver are bent. */
    private static final double MARGIN = 0.25;

    /** The step of the differences, in parts of the cell: between the errors of curvature and of rounding. */
    private static final double STEP = 0x1p-11;

    /** From nearer than this, in parts of the cell, one more step comes to the ray as nearly as numbers can. */
    private static final double NEAR_ENOUGH = 0x1p-20;

    private static final int MOST_STEPS = 32;

    /** Of a step. */
    private static final double SMALLEST_PART = 0x1p-8;

    private static final int HERE = 0;
    private static final int AFTER_S = 3;
    private static final int BEFORE_S = 6;
    private static final int AFTER_T = 9;
    private static final int BEFORE_T = 12;
    private static final int AFTER_BOTH = 15;

    private final LightPaths paths;
    private final SurfacePoint landing = new SurfacePoint();
    private final Rgb power = new Rgb();
    private final Rgb unread = new Rgb();
    private final LandingSlope alongS;
    private final LandingSlope alongT;

    /** Where rays land, from the point that is asked about, in scene units. */
    private final double[] landed = new double[18];

    private SurfacePoint target;
    private double s;
    private double t;

    /** How the landing point moves with s and with t, in scene units. */
    private double sx;

    private double sy;
    private double sz;
    private double tx;
    private double ty;
    private double tz;

    /** The area on the receiver for a unit of (s, t), as a vector. */
    private double areaX;

    private double areaY;
    private double areaZ;

    RaySolver(LightPaths paths) {
        this.paths = paths;
        this.alongS = new LandingSlope(paths);
        this.alongT = new LandingSlope(paths);
    }

    /**
     * Looks for the ray.
     *
     * @param cell whose triangle the point is in
     * @param at the point
     * @param guessS where in the cell the ray would be, if it were a linear map of light
     * @param orientation positive if the triangle is counterclockwise about the point's normal, else negative
     * @param depth how far along the normal the ray may land, in scene units
     * @param irradiance set to that of the ray, in W·m⁻²
     * @return false if there is no such ray in the cell, or light is folded within it; then nothing is set
     */
    boolean solve(
            CellSeed cell,
            SurfacePoint at,
            double guessS,
            double guessT,
            double orientation,
            double depth,
            Rgb irradiance) {
        target = at;
        s = guessS;
        t = guessT;
        paths.enter(cell);
        if (!iterate(orientation) || !refine() || !(Math.abs(along(HERE)) <= depth)) {
            return false;
        }
        double area = Arithmetic.length(areaX, areaY, areaZ);
        irradiance.set(power.red / area, power.green / area, power.blue / area);
        return true;
    }

    /** The weight of the second corner in the ray that was found. */
    double s() {
        return s;
    }

    double t() {
        return t;
    }

    /** Newton's steps, shortened where they would leave the cell, or the way, or come no nearer. */
    private boolean iterate(double orientation) {
        if (!isNearCell() || !follow(HERE, 0, 0, power)) {
            return false;
        }
        for (int step = 0; step < MOST_STEPS && differentiate(); step++) {
            double determinant = alongNormal(areaX, areaY, areaZ);
            if (!(determinant * orientation > 0)) {
                return false;
            }
            double x = landed[HERE];
            double y = landed[HERE + 1];
            double z = landed[HERE + 2];
            double ds = -alongNormal(y * tz - z * ty, z * tx - x * tz, x * ty - y * tx) / determinant;
            double dt = -alongNormal(sy * z - sz * y, sz * x - sx * z, sx * y - sy * x) / determinant;
            if (Math.abs(ds) <= NEAR_ENOUGH && Math.abs(dt) <= NEAR_ENOUGH) {
                boolean isFolded = isFolded(orientation);
                s += ds;
                t += dt;
                return !isFolded;
            }
            if (!comesNearer(ds, dt)) {
                return false;
            }
        }
        return false;
    }

    /** Goes a step or a part of it; false if even a small part does not come nearer. */
    private boolean comesNearer(double ds, double dt) {
        double fromS = s;
        double fromT = t;
        double distance = distance();
        for (double part = 1; part >= SMALLEST_PART; part *= 0.5) {
            s = fromS + part * ds;
            t = fromT + part * dt;
            if (isNearCell() && follow(HERE, 0, 0, power) && distance() < distance) {
                return true;
            }
        }
        return false;
    }

    private double distance() {
        return Arithmetic.length(landed[HERE], landed[HERE + 1], landed[HERE + 2]);
    }

    /** Computes power and area for the ray itself; false if it goes another way. */
    private boolean refine() {
        if (!follow(HERE, 0, 0, power) || !alongS.find(s, t, 1, 0) || !alongT.find(s, t, 0, 1)) {
            return false;
        }
        areaX = alongS.y * alongT.z - alongS.z * alongT.y;
        areaY = alongS.z * alongT.x - alongS.x * alongT.z;
        areaZ = alongS.x * alongT.y - alongS.y * alongT.x;
        return true;
    }

    private boolean isNearCell() {
        return s >= -MARGIN && t >= -MARGIN && s + t <= 1 + MARGIN;
    }

    /** Follows the ray's neighbours; false if one of them goes another way. */
    private boolean differentiate() {
        if (!(follow(AFTER_S, STEP, 0, unread)
                && follow(BEFORE_S, -STEP, 0, unread)
                && follow(AFTER_T, 0, STEP, unread)
                && follow(BEFORE_T, 0, -STEP, unread))) {
            return false;
        }
        double scale = 0.5 / STEP;
        sx = scale * (landed[AFTER_S] - landed[BEFORE_S]);
        sy = scale * (landed[AFTER_S + 1] - landed[BEFORE_S + 1]);
        sz = scale * (landed[AFTER_S + 2] - landed[BEFORE_S + 2]);
        tx = scale * (landed[AFTER_T] - landed[BEFORE_T]);
        ty = scale * (landed[AFTER_T + 1] - landed[BEFORE_T + 1]);
        tz = scale * (landed[AFTER_T + 2] - landed[BEFORE_T + 2]);
        areaX = sy * tz - sz * ty;
        areaY = sz * tx - sx * tz;
        areaZ = sx * ty - sy * tx;
        return true;
    }

    private boolean follow(int place, double ds, double dt, Rgb landedPower) {
        if (!paths.follow(s + ds, t + dt, landing, landedPower)) {
            return false;
        }
        landed[place] = landing.x - target.x;
        landed[place + 1] = landing.y - target.y;
        landed[place + 2] = landing.z - target.z;
        return true;
    }

    private double along(int place) {
        return alongNormal(landed[place], landed[place + 1], landed[place + 2]);
    }

    private double alongNormal(double x, double y, double z) {
        return target.normalX * x + target.normalY * y + target.normalZ * z;
    }

    /**
     * Whether the map of light turns over at one of the cell's corners: if its second derivatives at the ray tell so, and the rays
     * at the corners do.
     */
    private boolean isFolded(double orientation) {
        boolean isStraight = follow(AFTER_BOTH, STEP, STEP, unread)
                && !isTurnedOver(-s, -t, orientation)
                && !isTurnedOver(1 - s, -t, orientation)
                && !isTurnedOver(-s, 1 - t, orientation);
        return !isStraight
                && (isTurnedOverAt(0, 0, orientation)
                        || isTurnedOverAt(1, 0, orientation)
                        || isTurnedOverAt(0, 1, orientation));
    }

    /** The same at a corner itself, by rays within the cell. */
    private boolean isTurnedOverAt(double cornerS, double cornerT, double orientation) {
        // From any corner to the next two, in order.
        double nextS = cornerS == 1 ? -STEP : cornerT == 1 ? 0 : STEP;
        double nextT = cornerS == 1 ? STEP : cornerT == 1 ? -STEP : 0;
        double lastS = cornerS == 1 ? -STEP : cornerT == 1 ? STEP : 0;
        double lastT = cornerS == 1 ? 0 : cornerT == 1 ? -STEP : STEP;
        if (!(follow(AFTER_S, cornerS - s, cornerT - t, unread)
                && follow(AFTER_T, cornerS + nextS - s, cornerT + nextT - t, unread)
                && follow(AFTER_BOTH, cornerS + lastS - s, cornerT + lastT - t, unread))) {
            return true;
        }
        double ux = landed[AFTER_T] - landed[AFTER_S];
        double uy = landed[AFTER_T + 1] - landed[AFTER_S + 1];
        double uz = landed[AFTER_T + 2] - landed[AFTER_S + 2];
        double vx = landed[AFTER_BOTH] - landed[AFTER_S];
        double vy = landed[AFTER_BOTH + 1] - landed[AFTER_S + 1];
        double vz = landed[AFTER_BOTH + 2] - landed[AFTER_S + 2];
        return !(alongNormal(uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx) * orientation > 0);
    }

    private boolean isTurnedOver(double ds, double dt, double orientation) {
        double ux = sx + ds * second(AFTER_S, BEFORE_S, 0) + dt * mixed(0);
        double uy = sy + ds * second(AFTER_S, BEFORE_S, 1) + dt * mixed(1);
        double uz = sz + ds * second(AFTER_S, BEFORE_S, 2) + dt * mixed(2);
        double vx = tx + ds * mixed(0) + dt * second(AFTER_T, BEFORE_T, 0);
        double vy = ty + ds * mixed(1) + dt * second(AFTER_T, BEFORE_T, 1);
        double vz = tz + ds * mixed(2) + dt * second(AFTER_T, BEFORE_T, 2);
        return !(alongNormal(uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx) * orientation > 0);
    }

    private double second(int after, int before, int axis) {
        return (landed[after + axis] - 2 * landed[HERE + axis] + landed[before + axis]) / (STEP * STEP);
    }

    /** The derivative by s and t, which lacks half a step's third derivatives. */
    private double mixed(int axis) {
        return (landed[AFTER_BOTH + axis] - landed[AFTER_S + axis] - landed[AFTER_T + axis] + landed[HERE + axis])
                / (STEP * STEP);
    }
}
