package org.diacaustic.map;

/** Hoare's selection of the smallest of some numbers that all differ. */
final class LongSelection {
    private LongSelection() {}

    /** Rearranges values[0, count) so that those before {@code place} are smaller, those behind it larger, than the one there. */
    static void select(long[] values, int count, int place) {
        int low = 0;
        int high = count - 1;
        while (high - low > 1) {
            long pivot = median(values[low], values[low + high >>> 1], values[high]);
            // Which side a number belongs to is anyone's guess: moving all of them costs less than guessing.
            int middle = low;
            for (int i = low; i <= high; i++) {
                long value = values[i];
                values[i] = values[middle];
                values[middle] = value;
                middle += value < pivot ? 1 : 0;
            }
            if (place < middle) {
                high = middle - 1;
            } else {
                low = middle;
            }
        }
        if (low < high && values[high] < values[low]) {
            long smaller = values[high];
            values[high] = values[low];
            values[low] = smaller;
        }
    }

    private static long median(long a, long b, long c) {
        return Math.max(Math.min(a, b), Math.min(Math.max(a, b), c));
    }
}
