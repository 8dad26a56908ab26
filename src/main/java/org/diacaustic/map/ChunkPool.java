package org.diacaustic.map;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;

/**
 * The chunks that the slices of a store share: what one gives back another takes. It also counts what has been stored, so
 * that a pass which goes beyond the capacity ends then, and not when it has filled the memory. Safe for many threads,
 * which come here once a chunk.
 *
 * @param <C> the chunks
 */
final class ChunkPool<C> {
    private final Supplier<C> make;
    private final String what;
    private final int capacity;
    private final List<C> free = new ArrayList<>();
    private long counted;

    /**
     * @param what chunks hold, for messages
     * @param capacity the most of them that may be stored
     */
    ChunkPool(Supplier<C> make, String what, int capacity) {
        if (capacity < 0) {
            throw new IllegalArgumentException("a capacity must not be negative, but is " + capacity);
        }
        this.make = make;
        this.what = what;
        this.capacity = capacity;
    }

    synchronized C take() {
        return free.isEmpty() ? make.get() : free.remove(free.size() - 1);
    }

    synchronized void give(List<C> chunks) {
        // Not addAll, which copies the list.
        for (int i = 0; i < chunks.size(); i++) {
            free.add(chunks.get(i));
        }
    }

    /**
     * Counts what has been stored.
     *
     * @throws PhotonCapacityException if it is too much
     */
    synchronized void count(int stored) {
        counted += stored;
        if (counted > capacity) {
            throw new PhotonCapacityException(what, capacity);
        }
    }

    synchronized void forget() {
        counted = 0;
    }
}
