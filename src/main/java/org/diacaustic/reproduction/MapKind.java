package org.diacaustic.reproduction;

import java.util.Locale;

/** What keeps the light that a pre-processor brings [Thesis 4.4, 4.5]. */
enum MapKind {
    NONE("no map"),
    AMBIENT_MAPS("individual ambient maps"),
    PHOTON_MAP("a global photon map");

    private final String title;

    MapKind(String title) {
        this.title = title;
    }

    /** The name of the map in settings. */
    String key() {
        return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    String title() {
        return title;
    }
}
