package org.diacaustic.stability;

import java.util.Collection;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;

/** The operations that are known, by name. */
public final class Operations {
    private final Map<String, Operation> byName = new LinkedHashMap<>();

    /** An operation that runs in this process. */
    public Operations add(String name, String meaning, Operation.Trial trial) {
        return add(new Operation(name, meaning, Operation.Need.NOTHING, trial));
    }

    /** @throws IllegalArgumentException if the name is taken */
    public Operations add(Operation operation) {
        if (byName.putIfAbsent(operation.name(), operation) != null) {
            throw new IllegalArgumentException("the operation " + operation.name() + " is there already");
        }
        return this;
    }

    public Optional<Operation> find(String name) {
        return Optional.ofNullable(byName.get(name));
    }

    public Collection<Operation> all() {
        return Collections.unmodifiableCollection(byName.values());
    }
}
