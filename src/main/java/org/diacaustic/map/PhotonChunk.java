package org.diacaustic.map;

/**
 * Room for a few photons, an array for each of their numbers. Small, so that a task with few photons holds little, and so
 * that the memory of chunks already merged can be used for what comes next.
 */
final class PhotonChunk {
    static final int BITS = 8;

    /** The number of photons that fit. */
    static final int SIZE = 1 << BITS;

    /** Arrays become null when a {@link PhotonTree} has taken what is in them. */
    float[] x = new float[SIZE];

    float[] y = new float[SIZE];
    float[] z = new float[SIZE];
    float[] red = new float[SIZE];
    float[] green = new float[SIZE];
    float[] blue = new float[SIZE];
    int[] normal = new int[SIZE];
    int[] receiver = new int[SIZE];

    /** Copies photons from another chunk. */
    void copy(PhotonChunk from, int fromPlace, int place, int count) {
        System.arraycopy(from.x, fromPlace, x, place, count);
        System.arraycopy(from.y, fromPlace, y, place, count);
        System.arraycopy(from.z, fromPlace, z, place, count);
        System.arraycopy(from.red, fromPlace, red, place, count);
        System.arraycopy(from.green, fromPlace, green, place, count);
        System.arraycopy(from.blue, fromPlace, blue, place, count);
        System.arraycopy(from.normal, fromPlace, normal, place, count);
        System.arraycopy(from.receiver, fromPlace, receiver, place, count);
    }
}
