package org.diacaustic.stability;

import java.util.Comparator;
import java.util.List;

/**
 * What became of a case.
 *
 * @param checks what was compared; empty if the case cannot apply
 * @param notes what else is to be known
 * @param reason why the case cannot apply; empty if it does
 * @param seconds that it took
 */
public record CaseResult(NumericCase asked, List<Check> checks, List<String> notes, String reason, double seconds) {
    public CaseResult {
        checks = List.copyOf(checks);
        notes = List.copyOf(notes);
    }

    static CaseResult notApplicable(NumericCase asked, String reason) {
        return new CaseResult(asked, List.of(), List.of(), reason, 0);
    }

    /** A case whose operation broke off. */
    static CaseResult broken(NumericCase asked, Throwable thrown, double seconds) {
        Check check = new Check(
                "the operation", "an answer", thrown.toString(), Double.POSITIVE_INFINITY, Tolerance.of(0), 0);
        return new CaseResult(asked, List.of(check), List.of(), "", seconds);
    }

    /** That of the worst check; {@link Verdict#STRETCH} if all that can be stretched is, and the rest passes. */
    public Verdict verdict() {
        if (!reason.isEmpty()) {
            return Verdict.NOT_APPLICABLE;
        }
        Verdict worst = checks.stream()
                .map(Check::verdict)
                .max(Comparator.naturalOrder())
                .orElseThrow();
        boolean stretched = checks.stream().anyMatch(Check::isStretched)
                && checks.stream().filter(Check::isStretched).allMatch(check -> check.verdict() == Verdict.STRETCH);
        return worst == Verdict.PASS && stretched ? Verdict.STRETCH : worst;
    }

    /** The check that is the nearest to failing, or has failed the most. */
    public Check worst() {
        return checks.stream()
                .max(Comparator.comparing(Check::verdict).thenComparingDouble(Check::ratio))
                .orElseThrow();
    }

    /** Error ÷ tolerance of the worst check; not a number if the case cannot apply. */
    public double ratio() {
        return checks.isEmpty() ? Double.NaN : worst().ratio();
    }
}
