package org.diacaustic.map;

/** More photons, or cells of light, were to be stored than the plan has room for. */
public final class PhotonCapacityException extends IllegalStateException {
    private static final long serialVersionUID = 1;

    PhotonCapacityException(String what, int capacity) {
        super("more " + what + " than the store's capacity of " + capacity);
    }
}
