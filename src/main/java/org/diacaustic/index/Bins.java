package org.diacaustic.index;

import java.util.Arrays;

/**
 * Where to cut a range of boxes in two: the boxes are sorted into a few bins by their centres, along each axis, and the
 * cut between two bins with the smallest sum of (surface area × number of boxes) wins [Wald 2007]. Equal sums are
 * decided by axis, then by place. Working storage of one thread.
 */
final class Bins {
    /** The number of bins on an axis; small ranges have one for each item. */
    private static final int LARGEST_BINS = 16;

    /** The cost of a node's two box tests, in tests of one item. */
    private static final float NODE_COST = 2;

    private final float[] boxes;
    private final int[] items;
    private final int[] spare;

    /** The box around the range last measured: low and high x, y, z. */
    private final float[] box = new float[6];

    /** The range of twice the centres on each axis: low and high. */
    private final float[] centres = new float[6];

    private final float[] binBoxes = new float[3 * LARGEST_BINS * 6];
    private final int[] binCounts = new int[3 * LARGEST_BINS];
    private final float[] costFromRight = new float[LARGEST_BINS];
    private final float[] sweep = new float[6];

    private int bins;
    private int cutAxis;
    private int cutBin;
    private float cutCost;

    Bins(float[] boxes, int[] items, int[] spare) {
        this.boxes = boxes;
        this.items = items;
        this.spare = spare;
    }

    /** Finds the box around items[start, end) and the range of their centres. */
    void measure(int start, int end) {
        clear(box, 0);
        clear(centres, 0);
        for (int position = start; position < end; position++) {
            int i = 6 * items[position];
            for (int side = 0; side < 6; side += 2) {
                float low = boxes[i + side];
                float high = boxes[i + side + 1];
                include(box, side, low, high);
                include(centres, side, low + high, low + high);
            }
        }
    }

    void copyBox(float[] planes, int place) {
        System.arraycopy(box, 0, planes, place, 6);
    }

    /** Finds the best cut of the measured range; false if all centres are the same. */
    boolean findCut(int start, int end) {
        bins = Math.min(LARGEST_BINS, end - start);
        Arrays.fill(binCounts, 0, 3 * bins, 0);
        for (int bin = 0; bin < 3 * bins; bin++) {
            clear(binBoxes, 6 * bin);
        }
        sort(start, end);
        cutCost = Float.POSITIVE_INFINITY;
        cutAxis = -1;
        for (int axis = 0; axis < 3; axis++) {
            if (centres[2 * axis] < centres[2 * axis + 1]) {
                sweep(axis);
            }
        }
        return cutAxis >= 0;
    }

    private void sort(int start, int end) {
        float perUnitX = binsPerUnit(0);
        float perUnitY = binsPerUnit(1);
        float perUnitZ = binsPerUnit(2);
        for (int position = start; position < end; position++) {
            int i = 6 * items[position];
            float lowX = boxes[i];
            float highX = boxes[i + 1];
            float lowY = boxes[i + 2];
            float highY = boxes[i + 3];
            float lowZ = boxes[i + 4];
            float highZ = boxes[i + 5];
            int binX = bin(lowX + highX, centres[0], perUnitX);
            int binY = bin(lowY + highY, centres[2], perUnitY) + bins;
            int binZ = bin(lowZ + highZ, centres[4], perUnitZ) + 2 * bins;
            put(binX, lowX, highX, lowY, highY, lowZ, highZ);
            put(binY, lowX, highX, lowY, highY, lowZ, highZ);
            put(binZ, lowX, highX, lowY, highY, lowZ, highZ);
        }
    }

    private void put(int bin, float lowX, float highX, float lowY, float highY, float lowZ, float highZ) {
        binCounts[bin]++;
        int place = 6 * bin;
        include(binBoxes, place, lowX, highX);
        include(binBoxes, place + 2, lowY, highY);
        include(binBoxes, place + 4, lowZ, highZ);
    }

    private float binsPerUnit(int axis) {
        float extent = centres[2 * axis + 1] - centres[2 * axis];
        return extent > 0 ? bins / extent : 0;
    }

    private int bin(float centre, float origin, float perUnit) {
        return Math.min(bins - 1, (int) ((centre - origin) * perUnit));
    }

    private void sweep(int axis) {
        int first = axis * bins;
        clear(sweep, 0);
        int count = 0;
        for (int bin = bins - 1; bin > 0; bin--) {
            count += binCounts[first + bin];
            join(6 * (first + bin));
            costFromRight[bin] = count == 0 ? Float.POSITIVE_INFINITY : count * area(sweep);
        }
        clear(sweep, 0);
        count = 0;
        for (int bin = 1; bin < bins; bin++) {
            count += binCounts[first + bin - 1];
            join(6 * (first + bin - 1));
            float cost = count == 0 ? Float.POSITIVE_INFINITY : count * area(sweep) + costFromRight[bin];
            if (cost < cutCost) {
                cutCost = cost;
                cutAxis = axis;
                cutBin = bin;
            }
        }
    }

    private void join(int place) {
        for (int side = 0; side < 6; side += 2) {
            include(sweep, side, binBoxes[place + side], binBoxes[place + side + 1]);
        }
    }

    /** The tests expected below the cut when the range is entered, its own node included, in tests of one item. */
    float cutCost() {
        float area = area(box);
        return NODE_COST + (area > 0 ? cutCost / area : 0);
    }

    /** Orders items[start, end) by the side of the cut, each side in its former order; returns where the sides meet. */
    int partition(int start, int end) {
        int side = 2 * cutAxis;
        float origin = centres[side];
        float perUnit = binsPerUnit(cutAxis);
        int left = start;
        int right = start;
        for (int position = start; position < end; position++) {
            int item = items[position];
            if (bin(boxes[side + 6 * item] + boxes[side + 6 * item + 1], origin, perUnit) < cutBin) {
                items[left++] = item;
            } else {
                spare[right++] = item;
            }
        }
        System.arraycopy(spare, start, items, left, right - start);
        return left;
    }

    private static void clear(float[] box, int place) {
        for (int side = place; side < place + 6; side += 2) {
            box[side] = Float.POSITIVE_INFINITY;
            box[side + 1] = Float.NEGATIVE_INFINITY;
        }
    }

    private static void include(float[] box, int place, float low, float high) {
        if (low < box[place]) {
            box[place] = low;
        }
        if (high > box[place + 1]) {
            box[place + 1] = high;
        }
    }

    /** Half the surface area; 0 for an empty box has no meaning here. */
    private static float area(float[] box) {
        float x = box[1] - box[0];
        float y = box[3] - box[2];
        float z = box[5] - box[4];
        return x * y + y * z + z * x;
    }
}
