package org.diacaustic.map;

/** More photons were to be stored than the plan has room for. */
public final class PhotonCapacityException extends IllegalStateException {
    private static final long serialVersionUID = 1;

    PhotonCapacityException(int capacity) {
        super("more photons than the store's capacity of " + capacity);
    }
}
