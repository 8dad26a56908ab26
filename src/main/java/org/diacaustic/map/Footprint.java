package org.diacaustic.map;

import org.diacaustic.math.Arithmetic;
import org.diacaustic.math.Vector3;

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

    /** Three numbers a corner: the place, and the direction of the eye's ray there. */
    final double[] corners = new double[3 * LARGEST_CORNERS];

    final double[] directions = new double[3 * LARGEST_CORNERS];
    final FootprintSides sides = new FootprintSides();

    /** object · 2 + front, as cells have it. */
    int receiver;

    /** The normal that light must nearly share. */
    double normalX;

    double normalY;
    double normalZ;

    /** The mean direction of the eye's rays, of length 1. */
    double directionX;

    double directionY;
    double directionZ;

    /** The normal of the polygon's plane: its length is twice the polygon's area. */
    double polygonX;

    double polygonY;
    double polygonZ;

    /** The middle of the corners. */
    double centreX;

    double centreY;
    double centreZ;

    /**
     * How far from the polygon's plane light may be, times the length of its normal: as far as the corners are, and the reach.
     * Infinite if the reach is.
     */
    double thickness;

    private int cornerCount;
    /** Where the eye is, if the mean is over the picture. */
    double eyeX;

    double eyeY;
    double eyeZ;

    /** Null if the mean is over the surface. */
    Vector3 eyeForward;

    double pictureArea;
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
        reach = 0;
        areaGiven = false;
        eyeForward = null;
        closed = false;
    }

    /**
     * Adds a corner: 3 or 4, in order around the polygon, either way. Neighbours may be equal.
     *
     * @param x in scene units, as are y and z
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
     * @param distance in scene units: 0, as it is by default, for a flat surface, where rounding is made up for; else at
     *     least how far surface and cells are from the polygon. Positive infinity is right for a convex surface, but then
     *     all cells before and behind are looked at, which takes twice as long
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

    /**
     * Makes the mean one over the picture, and not over the surface: what is nearer, or faces the eye more, is larger there.
     *
     * @param x of the point that all eye rays of the footprint come from
     * @param forward the camera's direction, of length 1
     * @param pictureArea of the footprint, on a plane across that direction at a distance of 1
     */
    public void perspective(double x, double y, double z, Vector3 forward, double pictureArea) {
        eyeX = x;
        eyeY = y;
        eyeZ = z;
        eyeForward = forward;
        this.pictureArea = pictureArea;
    }

    /** The area of the surface within, in squared scene units, once the footprint is closed. */
    public double area() {
        return area;
    }

    /** Whether the surface is taken to be flat. */
    boolean isFlat() {
        return reach == 0;
    }

    /**
     * Computes the planes.
     *
     * @return false if nothing can be asked about it: there are fewer than 3 corners, the polygon is not convex or has no
     *     area, numbers are not finite, or an edge is along the eye's rays
     */
    public boolean close() {
        closed = cornerCount >= 3 && findPlane() && findMeans() && sides.cut(corners, directions, cornerCount);
        if (closed) {
            findThickness();
        }
        return closed;
    }

    boolean isClosed() {
        return closed;
    }

    int cornerCount() {
        return cornerCount;
    }

    /** Finds area and normal of the polygon; false if it has none. */
    private boolean findPlane() {
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
        return isSize(twice) && isSize(area) && isSize(Arithmetic.length(normalX, normalY, normalZ)) && reach >= 0;
    }

    private static boolean isSize(double value) {
        return value > 0 && value <= Double.MAX_VALUE;
    }

    /** Finds the centre of the corners and the mean direction; false if there is none. */
    private boolean findMeans() {
        double x = 0;
        double y = 0;
        double z = 0;
        double dx = 0;
        double dy = 0;
        double dz = 0;
        for (int i = 0; i < 3 * cornerCount; i += 3) {
            x += corners[i];
            y += corners[i + 1];
            z += corners[i + 2];
            dx += directions[i];
            dy += directions[i + 1];
            dz += directions[i + 2];
        }
        double length = Arithmetic.length(dx, dy, dz);
        centreX = x / cornerCount;
        centreY = y / cornerCount;
        centreZ = z / cornerCount;
        directionX = dx / length;
        directionY = dy / length;
        directionZ = dz / length;
        return isSize(length) && 0 * x + 0 * y + 0 * z == 0;
    }

    private void findThickness() {
        double farthest = 0;
        double steepest = 0;
        for (int i = 0; i < 3 * cornerCount; i += 3) {
            double off = polygonX * (corners[i] - centreX)
                    + polygonY * (corners[i + 1] - centreY)
                    + polygonZ * (corners[i + 2] - centreZ);
            farthest = Math.max(farthest, Math.abs(off));
            steepest = Math.max(steepest, throughPolygon(i));
        }
        // Along the polygon there is no telling how far from it infinity is.
        thickness = reach < Double.POSITIVE_INFINITY ? farthest + reach * steepest : reach;
    }

    /** How steeply the eye's ray at a place goes through the polygon: the cosine, times the length of the normal. */
    private double throughPolygon(int i) {
        return Math.abs(polygonX * directions[i] + polygonY * directions[i + 1] + polygonZ * directions[i + 2]);
    }

    /** How far along the eye's ray at a corner, either way, light may be, in scene units; may be infinite. */
    double travel(int corner) {
        return thickness == 0 ? 0 : thickness / throughPolygon(3 * corner);
    }
}
