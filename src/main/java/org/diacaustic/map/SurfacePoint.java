package org.diacaustic.map;

/** A point of a surface where light lands, or where it is asked for. Mutable, owned by one task. */
public final class SurfacePoint {
    /** In scene units. */
    public double x;

    public double y;
    public double z;

    /** The surface's own normal, of length 1, on the side that the light or the eye is on. */
    public double normalX;

    public double normalY;
    public double normalZ;

    /** The number of the object in the scene's list. */
    public int object;

    /** Whether the side is the one that the object's outward normal points to. */
    public boolean front;
}
