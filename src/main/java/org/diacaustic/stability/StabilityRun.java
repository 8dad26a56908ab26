package org.diacaustic.stability;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.function.Consumer;
import org.diacaustic.parallel.Workers;

/** Runs cases on several threads, and tells of their results in the order of the cases. */
public final class StabilityRun {
    private final Operations operations;
    private final Set<Operation.Need> allowed;

    /** @param allowed what operations may need */
    public StabilityRun(Operations operations, Set<Operation.Need> allowed) {
        this.operations = operations;
        this.allowed = Set.copyOf(allowed);
    }

    /**
     * Runs all cases.
     *
     * @param listener hears of each result, in order, as soon as those before it are there
     */
    public StabilityReport run(List<NumericCase> cases, Workers workers, Consumer<CaseResult> listener) {
        long start = System.nanoTime();
        CaseResult[] results = new CaseResult[cases.size()];
        List<CaseResult> told = new ArrayList<>();
        workers.run(cases.size(), () -> number -> {
            CaseResult result = result(cases.get(number));
            synchronized (told) {
                results[number] = result;
                while (told.size() < results.length && results[told.size()] != null) {
                    CaseResult next = results[told.size()];
                    told.add(next);
                    listener.accept(next);
                }
            }
        });
        return new StabilityReport(told, operations, (System.nanoTime() - start) * 1e-9);
    }

    private CaseResult result(NumericCase asked) {
        Operation operation = operations.find(asked.operation()).orElse(null);
        if (operation == null) {
            return CaseResult.notApplicable(asked, "there is no operation " + asked.operation());
        }
        if (operation.need() == Operation.Need.FAULTS && !allowed.contains(Operation.Need.FAULTS)) {
            return CaseResult.notApplicable(asked, "it starts processes, which --faults allows");
        }
        return result(asked, operation);
    }

    /** Whether the answer is that there is none: then what scenes are built of must refuse the inputs. */
    private static boolean expectsRefusal(NumericCase asked) {
        return asked.expected().text("result", "").toLowerCase(Locale.ROOT).startsWith("reject");
    }

    private static CaseResult result(NumericCase asked, Operation operation) {
        long start = System.nanoTime();
        Checks checks = new Checks(asked);
        try {
            operation.trial().run(asked, checks);
            return checks.result((System.nanoTime() - start) * 1e-9);
        } catch (CaseFault unreadable) {
            checks.notApplicable(unreadable.getMessage());
            return checks.result((System.nanoTime() - start) * 1e-9);
        } catch (IllegalArgumentException refused) {
            return expectsRefusal(asked)
                    ? checks.rule("refused", "a message", refused.getMessage(), true)
                            .result((System.nanoTime() - start) * 1e-9)
                    : CaseResult.broken(asked, refused, (System.nanoTime() - start) * 1e-9);
        } catch (Exception | StackOverflowError broken) {
            return CaseResult.broken(asked, broken, (System.nanoTime() - start) * 1e-9);
        }
    }
}
