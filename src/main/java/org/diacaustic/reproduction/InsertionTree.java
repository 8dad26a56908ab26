package org.diacaustic.reproduction;

import java.util.Arrays;

/**
 * The thesis' photon map as its text and counts describe it: a k-d tree into which photons are inserted one after the
 * other, never balanced, split at x, y and z in turn, in single precision [Thesis 4.5, 4.8]. What is smaller goes left,
 * all else right. It is here to be counted, since the published counts are of such a tree; renders use a balanced one.
 *
 * <p>Not for several threads at once.
 */
final class InsertionTree {
    private static final int NONE = -1;

    private float[] x = new float[1024];
    private float[] y = new float[1024];
    private float[] z = new float[1024];
    private int[] place = new int[1024];
    private int[] left = new int[1024];
    private int[] right = new int[1024];
    private int size;
    private int height;
    private int[] waiting = new int[64];
    private int[] waitingAxis = new int[64];
    private long nodesExamined;
    private long photonsUsed;
    private long foreignPhotonsUsed;
    private long mostNodes;
    private long insertionSteps;
    private long lookups;

    /** @param at where the photon lies, as a number: of the object and its side */
    void insert(float px, float py, float pz, int at) {
        int node = add(px, py, pz, at);
        if (node == 0) {
            height = 1;
            return;
        }
        int parent = 0;
        int axis = 0;
        for (int depth = 2; ; depth++) {
            insertionSteps++;
            boolean goesLeft = coordinate(axis, px, py, pz) < coordinate(axis, x[parent], y[parent], z[parent]);
            int next = goesLeft ? left[parent] : right[parent];
            if (next == NONE) {
                (goesLeft ? left : right)[parent] = node;
                height = Math.max(height, depth);
                return;
            }
            parent = next;
            axis = nextAxis(axis);
        }
    }

    private int add(float px, float py, float pz, int at) {
        if (size == x.length) {
            x = Arrays.copyOf(x, 2 * size);
            y = Arrays.copyOf(y, 2 * size);
            z = Arrays.copyOf(z, 2 * size);
            place = Arrays.copyOf(place, 2 * size);
            left = Arrays.copyOf(left, 2 * size);
            right = Arrays.copyOf(right, 2 * size);
        }
        x[size] = px;
        y[size] = py;
        z[size] = pz;
        place[size] = at;
        left[size] = NONE;
        right[size] = NONE;
        return size++;
    }

    /**
     * Searches the volume of interest, a sphere, and counts.
     *
     * @param at where the point lies, as photons are numbered
     */
    void lookUp(float px, float py, float pz, float radius, int at) {
        long before = nodesExamined;
        lookups++;
        int open = 0;
        if (size > 0) {
            waiting[open] = 0;
            waitingAxis[open++] = 0;
        }
        while (open > 0) {
            int node = waiting[--open];
            int axis = waitingAxis[open];
            nodesExamined++;
            count(node, px, py, pz, radius, at);
            reserve(open + 2);
            float split = coordinate(axis, x[node], y[node], z[node]);
            float centre = coordinate(axis, px, py, pz);
            if (left[node] != NONE && centre - radius < split) {
                waiting[open] = left[node];
                waitingAxis[open++] = nextAxis(axis);
            }
            if (right[node] != NONE && centre + radius >= split) {
                waiting[open] = right[node];
                waitingAxis[open++] = nextAxis(axis);
            }
        }
        mostNodes = Math.max(mostNodes, nodesExamined - before);
    }

    private void count(int node, float px, float py, float pz, float radius, int at) {
        float dx = x[node] - px;
        float dy = y[node] - py;
        float dz = z[node] - pz;
        if (dx * dx + dy * dy + dz * dz <= radius * radius) {
            photonsUsed++;
            foreignPhotonsUsed += place[node] == at ? 0 : 1;
        }
    }

    private void reserve(int needed) {
        if (needed > waiting.length) {
            waiting = Arrays.copyOf(waiting, 2 * needed);
            waitingAxis = Arrays.copyOf(waitingAxis, 2 * needed);
        }
    }

    private static float coordinate(int axis, float px, float py, float pz) {
        return axis == 0 ? px : axis == 1 ? py : pz;
    }

    private static int nextAxis(int axis) {
        return axis == 2 ? 0 : axis + 1;
    }

    int size() {
        return size;
    }

    /** The levels of the tree: 1 for a single photon. */
    int height() {
        return height;
    }

    /** Photons that others were compared with as they were inserted. */
    long insertionSteps() {
        return insertionSteps;
    }

    long lookups() {
        return lookups;
    }

    /** Photons looked at, in all lookups. */
    long nodesExamined() {
        return nodesExamined;
    }

    /** Photons in the volume of interest, in all lookups. */
    long photonsUsed() {
        return photonsUsed;
    }

    /** Those of them that lie on another object than the point that asked, or on its other side. */
    long foreignPhotonsUsed() {
        return foreignPhotonsUsed;
    }

    /** The nodes of the lookup that examined most. */
    long mostNodes() {
        return mostNodes;
    }
}
