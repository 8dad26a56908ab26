package org.diacaustic.cli;

/** What a command returns to the shell. */
final class ExitCode {
    static final int DONE = 0;
    static final int INTERNAL = 1;
    static final int BAD_INPUT = 2;
    static final int FILE = 3;
    static final int LIMIT = 4;

    private ExitCode() {}
}
