package org.diacaustic.math;

/**
 * A ray asking what it meets first: origin + t·direction for 0 &lt; t &lt; {@link #tMax}, and the answer so far. It is
 * mutable and owned by one task, which uses it again for every ray it traces: nothing is allocated per ray.
 *
 * <p>The direction need not have length 1; t is measured in lengths of it. There is no smallest t: a ray that leaves a
 * surface is told which primitive it leaves, and that primitive leaves out the point where the ray starts. So no
 * distance is too small to be hit, at any scale.
 */
public final class Ray {
    /** The value of {@link #leaving} of a ray that starts in free space. */
    public static final int FREE = -1;

    /** How many errors of its start a ray may need to get off a surface that it leaves at a flat angle. */
    private static final double ROUNDING_ERRORS = 0x1p12;

    public double originX;
    public double originY;
    public double originZ;
    public double directionX;
    public double directionY;
    public double directionZ;

    /** The open end of the ray; a hit shortens it to its own t. */
    public double tMax;

    /**
     * The primitive, of the shape that is being asked, on which the ray starts; {@link #FREE} if it starts on none of
     * its primitives.
     */
    public int leaving;

    /**
     * How far the origin may lie off the surface that the ray leaves, measured in t: the error of the point ÷ the
     * length of the direction. 0 in free space.
     */
    public double departureError;

    /**
     * How far before the surface that it leaves the ray starts, measured in t, so that it meets what touches that surface; of
     * no meaning in free space.
     */
    public double departureOffset;

    /** The primitive of the nearest hit so far: a number that its shape gave it. */
    public int hitPrimitive;

    /** What the shape wants to remember of its nearest hit, such as barycentric coordinates. */
    public double hitU;

    public double hitV;

    /** Tests against primitives and bounding volumes made for this ray and its predecessors in the same task. */
    public long tests;

    /** Where the hierarchies that this ray is in keep their open nodes; see {@link #stackTop}. */
    public int[] stack = new int[128];

    /** The entry distances of the nodes in {@link #stack}. */
    public float[] stackDistance = new float[128];

    /** What a hierarchy keeps beside {@link #stackDistance} that does not fit into floats. */
    public double[] stackFrame = new double[128];

    /** How many entries of the stack are in use. Nested hierarchies use it one above the other. */
    public int stackTop;

    /** Where shapes that solve for several roots keep them; of no meaning between calls. */
    public final double[] roots = new double[4];

    /** What a shape keeps with the ray so as not to make it for every ray; of no meaning between calls. */
    public Object scratch;

    private Ray local;

    /** Sets a ray in free space without end, and forgets the last answer. */
    public void set(double ox, double oy, double oz, double dx, double dy, double dz) {
        originX = ox;
        originY = oy;
        originZ = oz;
        directionX = dx;
        directionY = dy;
        directionZ = dz;
        tMax = Double.POSITIVE_INFINITY;
        leaving = FREE;
        departureError = 0;
        departureOffset = 0;
        hitPrimitive = 0;
        hitU = 0;
        hitV = 0;
    }

    public void set(Vector3 origin, Vector3 direction) {
        set(origin.x(), origin.y(), origin.z(), direction.x(), direction.y(), direction.z());
    }

    /**
     * The smallest t for a shape that cannot tell which of its points the ray leaves: well beyond the rounding error of
     * the start if the ray leaves this very shape, 0 otherwise. It lets such a shape be used at any scale; shapes that
     * know better leave out exactly their starting point.
     */
    public double nearest() {
        return leaving == FREE ? 0 : ROUNDING_ERRORS * departureError;
    }

    /** Notes a nearer hit. */
    public void hit(double t, int primitive) {
        tMax = t;
        hitPrimitive = primitive;
    }

    /** Makes room for {@code entries} more entries of the traversal stack. */
    public void reserveStack(int entries) {
        if (stackTop + entries > stack.length) {
            int size = Math.max(2 * stack.length, stackTop + entries);
            stack = java.util.Arrays.copyOf(stack, size);
            stackDistance = java.util.Arrays.copyOf(stackDistance, size);
            stackFrame = java.util.Arrays.copyOf(stackFrame, size);
        }
    }

    /** A second ray that belongs to this one, for a shape that asks another in coordinates of its own. */
    public Ray local() {
        if (local == null) {
            local = new Ray();
        }
        return local;
    }

    public double pointX(double t) {
        return Math.fma(t, directionX, originX);
    }

    public double pointY(double t) {
        return Math.fma(t, directionY, originY);
    }

    public double pointZ(double t) {
        return Math.fma(t, directionZ, originZ);
    }
}
