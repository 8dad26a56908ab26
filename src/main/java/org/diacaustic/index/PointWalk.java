package org.diacaustic.index;

/**
 * A query's way through a {@link PointTree}: the closed ball that it asks for, and the nodes still open. Mutable, owned by
 * one task, used again from query to query.
 */
public final class PointWalk {
    /** The centre of the ball. */
    float x;

    float y;
    float z;

    /** The square of the ball's radius. Whoever walks may shrink it between two leaves. */
    public float radiusSquared;

    final int[] nodes = new int[PointTree.LARGEST_DEPTH];

    /** The squared distance of the centre from the box of each open node. */
    final float[] distancesSquared = new float[PointTree.LARGEST_DEPTH];

    int open;
    long examined;

    /** Inner nodes and points that walks with this have looked at so far. */
    public long examined() {
        return examined;
    }
}
