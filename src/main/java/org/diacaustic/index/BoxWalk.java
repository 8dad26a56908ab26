package org.diacaustic.index;

/**
 * A query's way through a {@link BoxTree}: the region that it asks for, which is what lies both in a box and on the positive
 * side of some planes, and the nodes still open. Boxes in a corner between two planes may be taken to touch it though they do
 * not. Mutable, owned by one task, used again from query to query.
 */
public final class BoxWalk {
    /** The most planes that a region may have. */
    public static final int LARGEST_PLANES = 6;

    /** What {@link #touches} returns for a box that is apart from the region. */
    static final int APART = -1;

    /** Makes up for the rounding of boxes that are larger than the region. */
    private static final float WIDER = 1 + 0x1p-19f;

    final int[] nodes = new int[BoxTree.LARGEST_DEPTH];

    /** For each open node, the planes that may cut its box: bit i stands for plane i. */
    final int[] cutting = new int[BoxTree.LARGEST_DEPTH];

    int open;
    long examined;

    private float lowX;
    private float lowY;
    private float lowZ;
    private float highX;
    private float highY;
    private float highZ;

    /** Eight numbers a plane: n, 2c and |n| of n · x + c ≥ 0, at a scale where n is about 1; and twice the margin. */
    private final float[] planes = new float[8 * LARGEST_PLANES];

    private int planeCount;

    /** The planes that may cut the box of the leaf that was found last. */
    int leafCutting;

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

    /**
     * Cuts off from the region what is on the negative side of a plane: where n · x + c is negative. The plane is asked in
     * single precision: what comes as near to it as the margin is taken to be cut by it.
     *
     * @param margin on the scale of n · x + c, at least 2^-21 times the largest |n · x| within the region
     */
    public void cut(double nx, double ny, double nz, double c, double margin) {
        int place = 8 * planeCount++;
        double scale = 1 / Math.max(Math.abs(nx), Math.max(Math.abs(ny), Math.abs(nz)));
        planes[place] = (float) (scale * nx);
        planes[place + 1] = (float) (scale * ny);
        planes[place + 2] = (float) (scale * nz);
        planes[place + 3] = (float) (2 * scale * c);
        planes[place + 4] = WIDER * Math.abs(planes[place]);
        planes[place + 5] = WIDER * Math.abs(planes[place + 1]);
        planes[place + 6] = WIDER * Math.abs(planes[place + 2]);
        planes[place + 7] = (float) (2 * scale * margin);
    }

    /** All planes, as bits. */
    int allPlanes() {
        return (1 << planeCount) - 1;
    }

    /** The planes that may cut the box of the leaf that was found last: bit i for the i-th; the rest of them have it inside. */
    public int cutting() {
        return leafCutting;
    }

    /**
     * Tells how the box whose coordinates begin at a place lies in the region.
     *
     * @param asked the planes to ask, as bits
     * @return those of them that may cut the box; or {@link #APART}
     */
    int touches(float[] boxes, int place, int asked) {
        float smallX = boxes[place];
        float smallY = boxes[place + 1];
        float smallZ = boxes[place + 2];
        float largeX = boxes[place + 3];
        float largeY = boxes[place + 4];
        float largeZ = boxes[place + 5];
        if (smallX > highX || largeX < lowX || smallY > highY || largeY < lowY || smallZ > highZ || largeZ < lowZ) {
            return APART;
        }
        float middleX = smallX + largeX;
        float middleY = smallY + largeY;
        float middleZ = smallZ + largeZ;
        float widthX = largeX - smallX;
        float widthY = largeY - smallY;
        float widthZ = largeZ - smallZ;
        int cut = asked;
        for (int left = asked; left != 0; left &= left - 1) {
            int plane = Integer.numberOfTrailingZeros(left);
            int i = 8 * plane;
            // Twice the distance of the middle, and twice how far a corner is nearer or farther.
            float middle = planes[i] * middleX + planes[i + 1] * middleY + planes[i + 2] * middleZ + planes[i + 3];
            float half = planes[i + 4] * widthX + planes[i + 5] * widthY + planes[i + 6] * widthZ + planes[i + 7];
            if (middle < -half) {
                return APART;
            }
            cut ^= middle > half ? 1 << plane : 0;
        }
        return cut;
    }

    /** Inner nodes and items of leaves that walks with this have come to so far. */
    public long examined() {
        return examined;
    }
}
