package org.diacaustic.reproduction;

import java.util.Locale;

/** What became of a statement. */
enum Finding {
    CONFIRMED,
    CONTRADICTED,
    NOT_TESTED;

    /** In words. */
    String title() {
        return name().toLowerCase(Locale.ROOT).replace('_', ' ');
    }
}
