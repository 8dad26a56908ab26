package org.diacaustic.fault;

import org.diacaustic.stability.Launcher;
import org.diacaustic.stability.Operations;

/** What the program does when something is wrong with what it is given, or with where it runs. */
public final class FaultTrials {
    private FaultTrials() {}

    /** @param launcher of the program that they start */
    public static void addTo(Operations operations, Launcher launcher) {
        FaultOperations faults = new FaultOperations(operations, launcher);
        TextFaults.addTo(faults);
        KeyFaults.addTo(faults);
        ValueFaults.addTo(faults);
        FileFaults.addTo(faults);
        OptionFaults.addTo(faults);
        StreamFaults.addTo(faults);
        SignalFaults.addTo(faults);
        OutputFaults.addTo(faults);
        LibraryFaults.addTo(faults);
    }
}
