package org.diacaustic.reproduction;

/**
 * Something that must come out exactly.
 *
 * @param expected what must be found
 * @param found what was found
 */
record Identity(String claim, String expected, String found) {
    boolean holds() {
        return expected.equals(found);
    }
}
