package org.diacaustic.map;

/** Hoare's selection of the smallest of a few numbers. */
final class LongSelection {
    private LongSelection() {}

    /** Rearranges values[0, count) so that none before {@code place} is larger, and none behind it smaller, than the one there. */
    static void select(long[] values, int count, int place) {
        int low = 0;
        int high = count - 1;
        while (low < high) {
            long pivot = median(values[low], values[low + high >>> 1], values[high]);
            int i = low;
            int j = high;
            while (i <= j) {
                while (values[i] < pivot) {
                    i++;
                }
                while (values[j] > pivot) {
                    j--;
                }
                if (i <= j) {
                    long value = values[i];
                    values[i++] = values[j];
                    values[j--] = value;
                }
            }
            if (place <= j) {
                high = j;
            } else if (place >= i) {
                low = i;
            } else {
                return;
            }
        }
    }

    private static long median(long a, long b, long c) {
        return Math.max(Math.min(a, b), Math.min(Math.max(a, b), c));
    }
}
