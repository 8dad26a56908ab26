package org.diacaustic.index;

/**
 * A query's way through a {@link BoxTree}: the region that it asks for, which is what lies both in a box and on the positive
 * side of some planes, and the nodes still open. Boxes in a corner between two planes may be taken to touch it though they do
 * not. Mutable, owned by one task, used again from query to query.
 */
public final class BoxWalk {
    /** The most planes that a region may have. */
    public static final int LARGEST_PLANES = 6;

    final int[] nodes = new int[BoxTree.LARGEST_DEPTH];
    int open;
    long examined;

    private float lowX;
    private float lowY;
    private float lowZ;
    private float highX;
    private float highY;
    private float highZ;

    /** Four numbers a plane: n and c of n · x + c ≥ 0. */
    private final double[] planes = new double[4 * LARGEST_PLANES];

    private int planeCount;

    /** Sets the region to a closed box, without planes. A bound that is not a number bounds nothing. */
    public void box(double smallX, double smallY, double smallZ, double largeX, double largeY, double largeZ) {
        lowX = Math.nextDown((float) smallX);
        lowY = Math.nextDown((float) smallY);
        lowZ = Math.nextDown((float) smallZ);
        highX = Math.nextUp((float) largeX);
        highY = Math.nextUp((float) largeY);
        highZ = Math.nextUp((float) largeZ);
        planeCount = 0;
    }

    /** Cuts off from the region what is on the negative side of a plane: where n · x + c is negative. */
    public void cut(double nx, double ny, double nz, double c) {
        int place = 4 * planeCount++;
        planes[place] = nx;
        planes[place + 1] = ny;
        planes[place + 2] = nz;
        planes[place + 3] = c;
    }

    /** Whether the box whose coordinates begin at a place may reach into the region. */
    boolean touches(float[] boxes, int place) {
        float smallX = boxes[place];
        float smallY = boxes[place + 1];
        float smallZ = boxes[place + 2];
        float largeX = boxes[place + 3];
        float largeY = boxes[place + 4];
        float largeZ = boxes[place + 5];
        if (smallX > highX || largeX < lowX || smallY > highY || largeY < lowY || smallZ > highZ || largeZ < lowZ) {
            return false;
        }
        for (int i = 0; i < 4 * planeCount; i += 4) {
            double nx = planes[i];
            double ny = planes[i + 1];
            double nz = planes[i + 2];
            // The corner that is the farthest along the normal.
            double farthest = nx * (nx > 0 ? largeX : smallX)
                    + ny * (ny > 0 ? largeY : smallY)
                    + nz * (nz > 0 ? largeZ : smallZ)
                    + planes[i + 3];
            if (farthest < 0) {
                return false;
            }
        }
        return true;
    }

    /** Inner nodes and items of leaves that walks with this have come to so far. */
    public long examined() {
        return examined;
    }
}
