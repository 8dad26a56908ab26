package org.diacaustic.parallel;

/** Tells the threads of a job to stop; each looks at it before every ray that it follows. */
public final class StopSignal {
    private volatile boolean set;

    public void set() {
        set = true;
    }

    public boolean isSet() {
        return set;
    }
}
