package org.diacaustic.scenefile;

import java.util.Arrays;

/** Numbers distinct triples of longs from 0, in the order in which they first come; an open-addressed hash table. */
final class TripleIndex {
    private static final int FREE = -1;

    private long[] keys = new long[3 * 64];
    private int[] slots = new int[256];
    private int size;

    TripleIndex() {
        Arrays.fill(slots, FREE);
    }

    int size() {
        return size;
    }

    /** The number of a triple, a new one if it has not come before. */
    int indexOf(long a, long b, long c) {
        int slot = find(a, b, c);
        if (slots[slot] != FREE) {
            return slots[slot];
        }
        if (3 * size == keys.length) {
            keys = Arrays.copyOf(keys, IntList.grown(keys.length) / 3 * 3);
        }
        keys[3 * size] = a;
        keys[3 * size + 1] = b;
        keys[3 * size + 2] = c;
        slots[slot] = size;
        if (2L * ++size > slots.length) {
            enlarge();
        }
        return size - 1;
    }

    /** One part (0, 1 or 2) of a numbered triple. */
    long key(int index, int part) {
        return keys[3 * index + part];
    }

    private int find(long a, long b, long c) {
        int mask = slots.length - 1;
        int slot = hash(a, b, c) & mask;
        while (slots[slot] != FREE) {
            int k = 3 * slots[slot];
            if (keys[k] == a && keys[k + 1] == b && keys[k + 2] == c) {
                break;
            }
            slot = (slot + 1) & mask;
        }
        return slot;
    }

    private void enlarge() {
        slots = new int[2 * slots.length];
        Arrays.fill(slots, FREE);
        for (int i = 0; i < size; i++) {
            slots[find(keys[3 * i], keys[3 * i + 1], keys[3 * i + 2])] = i;
        }
    }

    private static int hash(long a, long b, long c) {
        long h = (a * 0x9E3779B97F4A7C15L + b) * 0xBF58476D1CE4E5B9L;
        h = ((h ^ h >>> 29) + c) * 0x94D049BB133111EBL;
        return (int) (h ^ h >>> 32);
    }
}
