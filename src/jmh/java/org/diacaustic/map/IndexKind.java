package org.diacaustic.map;

import java.util.function.BiFunction;
import org.diacaustic.parallel.Workers;

/** The ways to find photons that are compared. Building takes the photons out of the store, or copies them. */
public enum IndexKind {
    ARRANGED((store, radius) -> new ArrangedIndex(store, new Workers(1))),
    LEFT_BALANCED((store, radius) -> new LeftBalancedIndex(store)),
    OBJECT_TREE((store, radius) -> new ObjectTreeIndex(store)),
    HASH_GRID(HashGridIndex::new);

    private final BiFunction<PhotonStore, Double, PhotonIndex> builder;

    IndexKind(BiFunction<PhotonStore, Double, PhotonIndex> builder) {
        this.builder = builder;
    }

    /** @param radius that gathers will mostly have */
    PhotonIndex build(PhotonStore store, double radius) {
        return builder.apply(store, radius);
    }
}
