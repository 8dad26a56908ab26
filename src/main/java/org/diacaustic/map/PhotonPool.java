package org.diacaustic.map;

import java.util.ArrayList;
import java.util.List;

/**
 * The chunks that the slices of a store share: what one gives back another takes. It also counts the photons stored, so
 * that a pass which goes beyond the capacity ends then, and not when it has filled the memory. Safe for many threads,
 * which come here once a chunk.
 */
final class PhotonPool {
    private final int capacity;
    private final List<PhotonChunk> free = new ArrayList<>();
    private long counted;

    PhotonPool(int capacity) {
        this.capacity = capacity;
    }

    synchronized PhotonChunk take() {
        return free.isEmpty() ? new PhotonChunk() : free.remove(free.size() - 1);
    }

    synchronized void give(List<PhotonChunk> chunks) {
        // Not addAll, which copies the list.
        for (int i = 0; i < chunks.size(); i++) {
            free.add(chunks.get(i));
        }
    }

    /**
     * Counts photons that have been stored.
     *
     * @throws PhotonCapacityException if they are too many
     */
    synchronized void count(int photons) {
        counted += photons;
        if (counted > capacity) {
            throw new PhotonCapacityException(capacity);
        }
    }

    synchronized void forget() {
        counted = 0;
    }
}
