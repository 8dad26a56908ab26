package org.diacaustic.render;

/** Tells the threads of a job to stop; each looks at it before every ray that it follows. */
final class StopSignal {
    private volatile boolean set;

    void set() {
        set = true;
    }

    boolean isSet() {
        return set;
    }
}
