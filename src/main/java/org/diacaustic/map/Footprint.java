package org.diacaustic.map;

import org.diacaustic.math.Arithmetic;

/**
 * What a lookup asks about: the part of a surface that is seen through a convex polygon. Its sides are planes, each through
 * an edge of the polygon and the mean of the eye's directions at the edge's ends; seen directly, that is the pyramid of a
 * pixel. Two footprints that have an edge in common, with the same directions, have exactly the same plane there, and what
 * lies in the plane belongs to just one of them. So footprints that tile what is seen tile the light on it.
 *
 * <p>To be filled in this order: {@link #begin}, the corners, {@link #reach} and {@link #area} if they are not to be as they
 * are by default, {@link #close}. Mutable, owned by one task, used again from lookup to lookup.
 */
public final class Footprint {
    /** The most corners a footprint may have. */
    static final int LARGEST_CORNERS = 4;

    /** What rounding may make of 0, in parts of the numbers that went in. */
    private static final double ROUNDING = 0x1p-40;

    /** Three numbers a corner: the place, the direction of the eye's ray there. */
    final double[] corners = new double[3 * LARGEST_CORNERS];

    final double[] directions = new double[3 * LARGEST_CORNERS];

    /** Three numbers a plane: its normal, which points inwards and has any length, and a point on it. */
    final double[] normals = new double[3 * LARGEST_CORNERS];

    final double[] middles = new double[3 * LARGEST_CORNERS];

    /** Whether what lies in the plane is inside. */
    final boolean[] holdsPlane = new boolean[LARGEST_CORNERS];

    int planeCount;

    /** object · 2 + front, as cells have it. */
    int receiver;

    /** The normal that light must share. */
    double normalX;

    double normalY;
    double normalZ;

    /** The mean direction of the eye's rays, of length 1; or 0. */
    double directionX;

    double directionY;
    double directionZ;

    /** The normal of the polygon, of any length, a point on it, and how far light may be from there, times that length. */
    double polygonX;

    double polygonY;
    double polygonZ;
    double centreX;
    double centreY;
    double centreZ;
    double thickness;

    private int cornerCount;
    private double reach;
    private double area;
    private boolean areaGiven;
    private boolean closed;

    /** Begins anew, at a point whose receiver and side the light must be on, and whose normal it must nearly share. */
    public void begin(SurfacePoint at) {
        receiver = at.object << 1 | (at.front ? 1 : 0);
        normalX = at.normalX;
        normalY = at.normalY;
        normalZ = at.normalZ;
        cornerCount = 0;
        planeCount = 0;
        reach = 0;
        areaGiven = false;
        closed = false;
    }

    /**
     * Adds a corner: 3 or 4, in order around the polygon, either way. Two neighbours may be equal.
     *
     * @param dx the direction, of length 1, of the eye's ray that ends there; as are dy and dz
     * @throws IllegalStateException if there are 4 already
     */
    public void addCorner(double x, double y, double z, double dx, double dy, double dz) {
        if (cornerCount == LARGEST_CORNERS) {
            throw new IllegalStateException("a footprint has at most " + LARGEST_CORNERS + " corners");
        }
        int i = 3 * cornerCount++;
        corners[i] = x;
        corners[i + 1] = y;
        corners[i + 2] = z;
        directions[i] = dx;
        directions[i + 1] = dy;
        directions[i + 2] = dz;
        closed = false;
    }

    /**
     * Sets how far from the polygon, along the eye's rays, before and behind it, light is still taken to be on the same part of
     * the surface.
     *
     * @param distance in scene units: 0 for a flat surface, where rounding is made up for; positive infinity for a
     *     convex one; else at least how far the surface is from the polygon
     */
    public void reach(double distance) {
        reach = distance;
        closed = false;
    }

    /** Sets the area of the surface within, in squared scene units, to what is known better than by the polygon's own. */
    public void area(double known) {
        area = known;
        areaGiven = true;
        closed = false;
    }

    /** The area of the surface within, in squared scene units; of a closed footprint. */
    public double area() {
        return area;
    }

    /** Whether {@link #close} has been called since, and with success. */
    boolean isClosed() {
        return closed;
    }

    /**
     * Computes the planes.
     *
     * @return false if nothing can be asked about it: there are fewer than 3 corners, the polygon is not convex or has no
     *     area, numbers are not finite, or an eye's direction is along an edge
     */
    public boolean close() {
        closed = cornerCount >= 3 && measure() && cutSides();
        return closed;
    }

    /** Finds area, plane and mean direction of the polygon; false if there is none. */
    private boolean measure() {
        int last = 3 * (cornerCount - 1);
        double px = corners[6] - corners[0];
        double py = corners[7] - corners[1];
        double pz = corners[8] - corners[2];
        double qx = corners[last] - corners[3];
        double qy = corners[last + 1] - corners[4];
        double qz = corners[last + 2] - corners[5];
        polygonX = py * qz - pz * qy;
        polygonY = pz * qx - px * qz;
        polygonZ = px * qy - py * qx;
        double twice = Arithmetic.length(polygonX, polygonY, polygonZ);
        if (!areaGiven) {
            area = 0.5 * twice;
        }
        double normal = Arithmetic.length(normalX, normalY, normalZ);
        return twice > 0
                && area > 0
                && area <= Double.MAX_VALUE
                && normal > 0
                && normal <= Double.MAX_VALUE
                && reach >= 0
                && average(last)
                && spread(last);
    }

    /** Finds the centre of the corners and the mean direction; false if they are not finite. */
    private boolean average(int last) {
        centreX = 0;
        centreY = 0;
        centreZ = 0;
        directionX = 0;
        directionY = 0;
        directionZ = 0;
        for (int i = 0; i <= last; i += 3) {
            centreX += corners[i] / cornerCount;
            centreY += corners[i + 1] / cornerCount;
            centreZ += corners[i + 2] / cornerCount;
            directionX += directions[i];
            directionY += directions[i + 1];
            directionZ += directions[i + 2];
        }
        double length = Arithmetic.length(directionX, directionY, directionZ);
        if (length > 0) {
            directionX /= length;
            directionY /= length;
            directionZ /= length;
        }
        return 0 * centreX + 0 * centreY + 0 * centreZ == 0 && length <= Double.MAX_VALUE;
    }

    /** Finds how far from the polygon's plane light may be. */
    private boolean spread(int last) {
        double farthest = 0;
        double steepest = 0;
        for (int i = 0; i <= last; i += 3) {
            double off = polygonX * (corners[i] - centreX)
                    + polygonY * (corners[i + 1] - centreY)
                    + polygonZ * (corners[i + 2] - centreZ);
            farthest = Math.max(farthest, Math.abs(off));
            steepest = Math.max(steepest, Math.abs(along(i)));
        }
        thickness = reach == 0 ? farthest : farthest + reach * steepest;
        return true;
    }

    /** The part of the eye's direction at a corner that goes through the polygon, times the length of the normal. */
    private double along(int i) {
        return polygonX * directions[i] + polygonY * directions[i + 1] + polygonZ * directions[i + 2];
    }

    /** How far along the eye's ray at a corner, either way, the light is that counts. May be infinite, or not a number. */
    double travel(int corner) {
        return thickness == 0 ? 0 : thickness / Math.abs(along(3 * corner));
    }

    int cornerCount() {
        return cornerCount;
    }

    private boolean cutSides() {
        planeCount = 0;
        for (int corner = 0; corner < cornerCount; corner++) {
            int p = 3 * corner;
            int q = corner + 1 < cornerCount ? p + 3 : 0;
            boolean equal =
                    corners[p] == corners[q] && corners[p + 1] == corners[q + 1] && corners[p + 2] == corners[q + 2];
            if (!equal && !cutSide(p, q)) {
                return false;
            }
        }
        return true;
    }

    /**
     * Adds the plane through an edge. With p and q exchanged all its numbers change their signs and nothing else: then the
     * footprint on the other side has the same plane.
     */
    private boolean cutSide(int p, int q) {
        double ex = corners[q] - corners[p];
        double ey = corners[q + 1] - corners[p + 1];
        double ez = corners[q + 2] - corners[p + 2];
        double mx = directions[p] + directions[q];
        double my = directions[p + 1] + directions[q + 1];
        double mz = directions[p + 2] + directions[q + 2];
        double nx = ey * mz - ez * my;
        double ny = ez * mx - ex * mz;
        double nz = ex * my - ey * mx;
        double x = 0.5 * (corners[p] + corners[q]);
        double y = 0.5 * (corners[p + 1] + corners[q + 1]);
        double z = 0.5 * (corners[p + 2] + corners[q + 2]);
        double lowest = 0;
        double highest = 0;
        double farthest = 0;
        for (int i = 0; i < 3 * cornerCount; i += 3) {
            if (i != p && i != q) {
                double dx = corners[i] - x;
                double dy = corners[i + 1] - y;
                double dz = corners[i + 2] - z;
                double distance = nx * dx + ny * dy + nz * dz;
                lowest = Math.min(lowest, distance);
                highest = Math.max(highest, distance);
                farthest = Math.max(farthest, Math.abs(dx) + Math.abs(dy) + Math.abs(dz));
            }
        }
        double rounding = ROUNDING * farthest * (Math.abs(nx) + Math.abs(ny) + Math.abs(nz));
        boolean positive = highest > rounding && lowest >= -rounding;
        boolean negative = lowest < -rounding && highest <= rounding;
        if (!(positive || negative)) {
            return false;
        }
        double sign = positive ? 1 : -1;
        int i = 3 * planeCount;
        normals[i] = sign * nx;
        normals[i + 1] = sign * ny;
        normals[i + 2] = sign * nz;
        middles[i] = x;
        middles[i + 1] = y;
        middles[i + 2] = z;
        holdsPlane[planeCount] = isFirst(normals[i], normals[i + 1], normals[i + 2]);
        planeCount++;
        return true;
    }

    /** True for just one of a direction and its opposite: as if all light were moved by a little of x, less of y, least of z. */
    static boolean isFirst(double x, double y, double z) {
        return x > 0 || x == 0 && (y > 0 || y == 0 && z > 0);
    }
}
