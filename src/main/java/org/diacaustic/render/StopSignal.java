package org.diacaustic.render;

/** Tells the threads of a job to stop; each looks at it before every eye ray. */
final class StopSignal {
    private volatile boolean set;

    void set() {
        set = true;
    }

    boolean isSet() {
        return set;
    }
}
