package org.diacaustic.map;

/** The k smallest of many numbers, the largest of them on top. Each has a slot, for what belongs to it. */
final class BoundedHeap {
    private float[] keys = new float[0];
    private int[] slots = new int[0];
    private int capacity;
    private int size;

    void clear(int k) {
        if (keys.length < k) {
            keys = new float[k];
            slots = new int[k];
        }
        capacity = k;
        size = 0;
    }

    boolean isFull() {
        return size == capacity;
    }

    float largest() {
        return keys[0];
    }

    int size() {
        return size;
    }

    /** Takes a number that is not larger than the largest, or any while there is room; returns its slot. */
    int add(float key) {
        if (size < capacity) {
            int slot = size;
            int i = size++;
            while (i > 0 && keys[i - 1 >> 1] < key) {
                keys[i] = keys[i - 1 >> 1];
                slots[i] = slots[i - 1 >> 1];
                i = i - 1 >> 1;
            }
            keys[i] = key;
            slots[i] = slot;
            return slot;
        }
        int slot = slots[0];
        int i = 0;
        for (int child = 1; child < size; child = 2 * i + 1) {
            int larger = child + 1 < size && keys[child + 1] > keys[child] ? child + 1 : child;
            if (keys[larger] <= key) {
                break;
            }
            keys[i] = keys[larger];
            slots[i] = slots[larger];
            i = larger;
        }
        keys[i] = key;
        slots[i] = slot;
        return slot;
    }
}
