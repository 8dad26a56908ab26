package org.diacaustic.fault;

import org.diacaustic.stability.Checks;
import org.diacaustic.stability.Launcher;
import org.diacaustic.stability.NumericCase;
import org.diacaustic.stability.Operation;
import org.diacaustic.stability.Operations;

/**
 * Collects operations of faults. What a case's {@code variant} says is words for people: of each fault all variants are tried
 * that are known here, whichever of them a case is about.
 */
final class FaultOperations {
    private static final String PREFIX = "cli_fault:";

    private final Operations operations;
    private final Launcher launcher;

    FaultOperations(Operations operations, Launcher launcher) {
        this.operations = operations;
        this.launcher = launcher;
    }

    /** Brings a fault about. */
    @FunctionalInterface
    interface Fault {
        /** @throws Exception whatever breaks off: the case has failed then */
        void meet(FaultBench bench, NumericCase asked, Checks checks) throws Exception;
    }

    /** A fault that is met in a temporary folder. */
    FaultOperations add(String name, String meaning, Fault fault) {
        operations.add(new Operation(PREFIX + name, meaning, Operation.Need.FAULTS, (asked, checks) -> {
            try (FaultBench bench = new FaultBench(launcher, checks)) {
                fault.meet(bench, asked, checks);
            }
        }));
        return this;
    }
}
