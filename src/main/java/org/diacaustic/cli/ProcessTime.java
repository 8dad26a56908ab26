package org.diacaustic.cli;

import java.lang.management.ManagementFactory;

/** How long the process has been there, in seconds. */
@FunctionalInterface
interface ProcessTime {
    double seconds();

    /** Since the virtual machine was started. */
    static ProcessTime ofMachine() {
        return () -> ManagementFactory.getRuntimeMXBean().getUptime() * 1e-3;
    }

    /** Since now: for a command that is run by another program. */
    static ProcessTime ofCall() {
        long start = System.nanoTime();
        return () -> (System.nanoTime() - start) * 1e-9;
    }
}
