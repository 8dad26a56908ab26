package org.diacaustic.scenefile;

import java.util.ArrayList;
import java.util.List;

/**
 * A position in a document at which a value is looked for.
 *
 * @param path the keys that lead here, for messages
 * @param place of the value, or of the mapping that lacks it
 * @param node the value; null if there is none
 * @param silent whether what contains this position is itself missing, which has been told already
 */
record Slot(Section section, String path, Place place, Node node, boolean silent) {

    boolean isAbsent() {
        return node == null;
    }

    void error(String message) {
        if (!silent) {
            section.error(place, path, message);
        }
    }

    void unreadable(String message) {
        if (!silent) {
            section.unreadable(place, path, message);
        }
    }

    void limit(String message) {
        if (!silent) {
            section.limit(place, path, message);
        }
    }

    void warning(String message) {
        if (!silent) {
            section.warning(place, path, message);
        }
    }

    void missing(String expected) {
        if (!silent) {
            section.missing(place, path, "is missing: expected " + expected);
        }
    }

    void unexpected(String expected) {
        error("expected " + expected + ", found " + node.describe());
    }

    /** The positions of a list's values. */
    List<Slot> items(Node.Sequence list) {
        List<Slot> slots = new ArrayList<>(list.items().size());
        for (Node item : list.items()) {
            slots.add(new Slot(section, path + "[" + slots.size() + "]", item.place(), item, silent));
        }
        return slots;
    }
}
