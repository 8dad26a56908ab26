package org.diacaustic.map;

import java.util.Locale;

/** More photons, or cells of light, were to be stored than the plan has room for. */
public final class PhotonCapacityException extends IllegalStateException {
    private static final long serialVersionUID = 1;

    /** Before any are stored: so many are expected. */
    public PhotonCapacityException(String what, double expected, int capacity) {
        super(String.format(
                Locale.ROOT, "about %.2g %s are to be expected, but there is room for %d", expected, what, capacity));
    }

    PhotonCapacityException(String what, int capacity) {
        super("more " + what + " than the store's capacity of " + capacity);
    }
}
