package org.diacaustic.scenefile;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;

/** Collects names and what they stand for, in the order in which messages list them. */
final class Kinds<T> {
    private final Map<String, T> byName = new LinkedHashMap<>();

    Kinds<T> with(String name, T value) {
        byName.put(name, value);
        return this;
    }

    Map<String, T> map() {
        return Collections.unmodifiableMap(byName);
    }
}
