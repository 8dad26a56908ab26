package org.diacaustic.preprocess;

import java.util.Arrays;

/** Which rays have been followed at which places of a grid: a hash table of primitives, used again after {@link #clear}. */
final class PlaceTable {
    private static final int NONE = -1;

    private long[] keys = new long[256];
    private int[] rays = new int[256];
    private int size;

    PlaceTable() {
        clear();
    }

    void clear() {
        Arrays.fill(rays, NONE);
        size = 0;
    }

    /** The ray at a place, or −1. */
    int find(int x, int y) {
        return rays[slot(key(x, y))];
    }

    /** Notes the ray at a place that has none. */
    void put(int x, int y, int ray) {
        if (2 * size >= keys.length) {
            grow();
        }
        insert(key(x, y), ray);
        size++;
    }

    private void insert(long key, int ray) {
        int slot = slot(key);
        keys[slot] = key;
        rays[slot] = ray;
    }

    private void grow() {
        long[] oldKeys = keys;
        int[] oldRays = rays;
        keys = new long[2 * oldKeys.length];
        rays = new int[keys.length];
        Arrays.fill(rays, NONE);
        for (int i = 0; i < oldKeys.length; i++) {
            if (oldRays[i] != NONE) {
                insert(oldKeys[i], oldRays[i]);
            }
        }
    }

    /** Where a key is, or would be put. */
    private int slot(long key) {
        long mixed = key * 0x9E3779B97F4A7C15L;
        int slot = (int) (mixed >>> 32) & keys.length - 1;
        while (rays[slot] != NONE && keys[slot] != key) {
            slot = slot + 1 & keys.length - 1;
        }
        return slot;
    }

    private static long key(int x, int y) {
        return (long) x << 32 | y;
    }
}
