package org.diacaustic.map;

/** A way to find photons by place. */
interface PhotonIndex {
    /** The memory that photons and index take. */
    long bytes();

    GatherQuery query(PhotonFilter filter);
}
