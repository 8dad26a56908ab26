package org.diacaustic.scenefile;

import java.util.function.Supplier;

/** Makes things from values that were read, and turns what their constructors refuse into problems with a place. */
final class Building {
    private Building() {}

    /**
     * Finishes the reader and, if all was well, makes the thing.
     *
     * @return null if anything was wrong, which has been told
     */
    static <T> T of(MappingReader in, Supplier<T> maker) {
        if (!in.finish()) {
            return null;
        }
        try {
            return maker.get();
        } catch (IllegalArgumentException refused) {
            in.error(refused.getMessage());
            return null;
        }
    }
}
