package org.diacaustic.scenefile;

import java.util.ArrayList;
import java.util.List;

/** A value as it stands in a document, with its place. What the text of a scalar means is decided by who asks for it. */
sealed interface Node {

    Place place();

    /** What an error message says was found. */
    String describe();

    /** @param plain whether the text stands without quotes, so that it may be a number, a flag or null */
    record Scalar(Place place, String text, boolean plain) implements Node {
        private static final int SHOWN = 40;

        boolean isNull() {
            return plain && (text.isEmpty() || text.equals("~") || text.equalsIgnoreCase("null"));
        }

        @Override
        public String describe() {
            if (isNull()) {
                return "nothing";
            }
            return "'" + Problem.printable(text, SHOWN) + "'";
        }
    }

    record Sequence(Place place, List<Node> items) implements Node {
        @Override
        public String describe() {
            return items.size() == 1 ? "a list of 1 value" : "a list of " + items.size() + " values";
        }
    }

    record Mapping(Place place, List<Entry> entries) implements Node {
        @Override
        public String describe() {
            return entries.isEmpty() ? "an empty mapping" : "a mapping with '" + entries.get(0).key.text + "'";
        }

        /** The same mapping with {@code value} under a key, in place of what was there. */
        Mapping with(String key, Node value) {
            List<Entry> changed = new ArrayList<>(entries);
            changed.removeIf(entry -> entry.key.text.equals(key));
            changed.add(new Entry(new Scalar(value.place(), key, true), value));
            return new Mapping(place, changed);
        }
    }

    record Entry(Scalar key, Node value) {}
}
