package org.diacaustic.fault;

import java.util.List;
import java.util.regex.Pattern;

/**
 * A process of the program that has ended, and what came of it.
 *
 * @param code its exit code; {@link #HUNG} if it had to be killed
 * @param seconds from its start, or from the signal that it was sent, to its end
 * @param output what it wrote to standard output
 * @param errors what it wrote to standard error
 */
record ProgramRun(int code, double seconds, String output, String errors) {
    /** The code of a process that did not end by itself. */
    static final int HUNG = -1;

    private static final Pattern TRACE = Pattern.compile("(?m)^\\s+at [\\w.$/]+\\(|^Exception in thread|^Caused by: ");

    List<String> errorLines() {
        return errors.lines().toList();
    }

    boolean showsTrace() {
        return TRACE.matcher(errors).find();
    }

    /** Whether a regular expression matches a part of what was said on standard error. */
    boolean says(String pattern) {
        return Pattern.compile(pattern, Pattern.DOTALL).matcher(errors).find();
    }

    /** Exit code, time, and the beginning of what was said. */
    @Override
    public String toString() {
        String said = errors.isBlank() ? "nothing said" : errors.strip().replaceAll("\\s*\\R\\s*", "; ");
        return (code == HUNG ? "hung" : "exit " + code) + " after " + Math.rint(100 * seconds) / 100 + " s: "
                + said.substring(0, Math.min(200, said.length()));
    }
}
