package org.diacaustic.map;

/**
 * A left-balanced kd-tree without pointers: the children of photon i are 2i and 2i + 1, each range is cut where the left half is
 * a full tree [Jensen 2001, Appendix B]. One byte a photon for the axis.
 */
final class LeftBalancedIndex implements PhotonIndex {
    private final PhotonColumns photons;
    private final byte[] axis;

    LeftBalancedIndex(PhotonStore store) {
        PhotonColumns source = PhotonColumns.of(store);
        int size = source.size();
        photons = new PhotonColumns(size + 1);
        axis = new byte[size + 1];
        long[] keys = new long[size];
        for (int i = 0; i < size; i++) {
            keys[i] = i;
        }
        build(source, keys, new long[size], 0, size, 1);
    }

    private void build(PhotonColumns source, long[] keys, long[] spare, int start, int end, int node) {
        int count = end - start;
        if (count <= 0) {
            return;
        }
        float[][] sides = {source.x, source.y, source.z};
        float widest = -1;
        for (byte side = 0; side < 3; side++) {
            float low = Float.POSITIVE_INFINITY;
            float high = Float.NEGATIVE_INFINITY;
            for (int i = start; i < end; i++) {
                float value = sides[side][(int) keys[i]];
                low = Math.min(low, value);
                high = Math.max(high, value);
            }
            if (high - low > widest) {
                widest = high - low;
                axis[node] = side;
            }
        }
        float[] along = sides[axis[node]];
        for (int i = 0; i < count; i++) {
            int photon = (int) keys[start + i];
            int bits = Float.floatToRawIntBits(along[photon] + 0f);
            spare[i] = (long) (bits ^ bits >> 31 & Integer.MAX_VALUE) << 32 | photon;
        }
        int left = leftSize(count);
        LongSelection.select(spare, count, left);
        for (int i = 0; i < count; i++) {
            keys[start + i] = (int) spare[i];
        }
        photons.copy(source, (int) keys[start + left], node);
        build(source, keys, spare, start, start + left, 2 * node);
        build(source, keys, spare, start + left + 1, end, 2 * node + 1);
    }

    /** The size of the left subtree of a left-balanced tree. */
    private static int leftSize(int count) {
        int lastRow = Integer.highestOneBit(count);
        int full = lastRow - 1;
        return (full - 1) / 2 + Math.min(count - full, lastRow / 2);
    }

    @Override
    public long bytes() {
        return photons.bytes() + axis.length;
    }

    @Override
    public GatherQuery query(PhotonFilter filter) {
        return new ColumnQuery(filter, photons) {
            @Override
            void walk() {
                if (axis.length > 1) {
                    visit(1);
                }
            }

            private void visit(int node) {
                int first = 2 * node;
                if (first < axis.length) {
                    float beyond = switch (axis[node]) {
                        case 0 -> x - photons.x[node];
                        case 1 -> y - photons.y[node];
                        default -> z - photons.z[node];
                    };
                    int near = beyond < 0 ? first : first + 1;
                    if (near < axis.length) {
                        visit(near);
                    }
                    int far = near ^ 1;
                    if (beyond * beyond <= radiusSquared && far < axis.length) {
                        visit(far);
                    }
                }
                look(node);
            }
        };
    }
}
