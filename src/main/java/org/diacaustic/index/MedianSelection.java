package org.diacaustic.index;

/**
 * Brings the points that come first along an axis to the front of a range: Hoare's selection, with the median of a few
 * points as pivot. All coordinates and the number of a point move together, so that what is read next lies in a row; equal
 * coordinates are ordered by number, so no two points are equal. The pivots' places come from a generator that starts
 * anew with every range, so no order of the points is a bad one and every run does the same. Working storage of one
 * thread.
 */
final class MedianSelection {
    /** Ranges up to this size are sorted. */
    private static final int SMALL = 12;

    /** Ranges from this size on take a better pivot. */
    private static final int LARGE = 1 << 10;

    private final float[] x;
    private final float[] y;
    private final float[] z;

    /** A fourth number of each point, or null. */
    private final float[] extents;

    private final int[] numbers;
    private long random;

    /** @param extents a fourth number of each point; may be null */
    MedianSelection(float[] x, float[] y, float[] z, float[] extents, int[] numbers) {
        this.x = x;
        this.y = y;
        this.z = z;
        this.extents = extents;
        this.numbers = numbers;
    }

    /**
     * Rearranges [start, end) so that every point before {@code middle} comes before every point from there on.
     *
     * @param along the coordinates that decide, one of the arrays
     * @param middle after {@code start} and before {@code end}
     */
    void select(float[] along, int start, int end, int middle) {
        random = start;
        int low = start;
        int high = end - 1;
        while (high - low >= SMALL) {
            int pivot = high - low < LARGE ? medianOfThree(along, low, high) : medianOfNine(along, low, high);
            float value = along[pivot];
            int number = numbers[pivot];
            int i = low;
            int j = high;
            while (i <= j) {
                while (along[i] < value || along[i] == value && numbers[i] < number) {
                    i++;
                }
                while (along[j] > value || along[j] == value && numbers[j] > number) {
                    j--;
                }
                if (i <= j) {
                    swap(i++, j--);
                }
            }
            if (middle <= j) {
                high = j;
            } else if (middle >= i) {
                low = i;
            } else {
                return;
            }
        }
        sort(along, low, high);
    }

    private void sort(float[] along, int low, int high) {
        for (int i = low + 1; i <= high; i++) {
            for (int j = i; j > low && before(along, j, j - 1); j--) {
                swap(j, j - 1);
            }
        }
    }

    private int medianOfNine(float[] along, int low, int high) {
        return median(
                along,
                medianOfThree(along, low, high),
                medianOfThree(along, low, high),
                medianOfThree(along, low, high));
    }

    private int medianOfThree(float[] along, int low, int high) {
        return median(along, place(low, high), place(low, high), place(low, high));
    }

    private int median(float[] along, int a, int b, int c) {
        if (before(along, a, b)) {
            return before(along, b, c) ? b : before(along, a, c) ? c : a;
        }
        return before(along, a, c) ? a : before(along, b, c) ? c : b;
    }

    /** A place from low to high: the high bits of a linear congruential generator [Knuth, MMIX]. */
    private int place(int low, int high) {
        random = random * 6364136223846793005L + 1442695040888963407L;
        return low + (int) ((random >>> 33) * (high - low + 1L) >>> 31);
    }

    private boolean before(float[] along, int a, int b) {
        return along[a] < along[b] || along[a] == along[b] && numbers[a] < numbers[b];
    }

    private void swap(int a, int b) {
        float atX = x[a];
        x[a] = x[b];
        x[b] = atX;
        float atY = y[a];
        y[a] = y[b];
        y[b] = atY;
        float atZ = z[a];
        z[a] = z[b];
        z[b] = atZ;
        if (extents != null) {
            float extent = extents[a];
            extents[a] = extents[b];
            extents[b] = extent;
        }
        int number = numbers[a];
        numbers[a] = numbers[b];
        numbers[b] = number;
    }
}
