package org.diacaustic.study;

import java.lang.management.ManagementFactory;
import java.lang.management.OperatingSystemMXBean;

/** Times something: by the clock, and by the time that all threads of the process have run. */
final class Clock {
    private static final double NANOSECOND = 1e-9;

    private final long wallStart = System.nanoTime();
    private final double processorStart = processorNow();

    /** Seconds since the clock was made. */
    double wallSeconds() {
        return (System.nanoTime() - wallStart) * NANOSECOND;
    }

    /** Seconds that threads have run since then, with compiling and cleaning up; not a number if the system does not tell. */
    double processorSeconds() {
        return processorNow() - processorStart;
    }

    private static double processorNow() {
        OperatingSystemMXBean system = ManagementFactory.getOperatingSystemMXBean();
        if (system instanceof com.sun.management.OperatingSystemMXBean known) {
            long nanoseconds = known.getProcessCpuTime();
            return nanoseconds < 0 ? Double.NaN : nanoseconds * NANOSECOND;
        }
        return Double.NaN;
    }
}
