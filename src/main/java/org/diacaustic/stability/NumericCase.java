package org.diacaustic.stability;

import java.util.List;

/**
 * A question with an exact answer.
 *
 * @param id unique in its file
 * @param category what the case belongs to
 * @param title what the case is, in a line
 * @param operation which operation it is a case of; see {@link Operations}
 * @param inputs exact doubles, and texts
 * @param expected the answer for exactly those doubles: decimals of many digits, and rules in words
 * @param tolerance how far off what is found may be
 * @param acceptable what else is an honest answer, in words; empty if there is one only
 * @param typicalFailure what renderers do wrong there; empty if nothing is known
 */
public record NumericCase(
        String id,
        String category,
        String title,
        String operation,
        Values inputs,
        Values expected,
        Values tolerance,
        List<String> acceptable,
        String typicalFailure) {

    public NumericCase {
        acceptable = List.copyOf(acceptable);
    }
}
