package org.diacaustic.cli;

/** The problems of a scene file, a line each with its place. */
final class ProblemsFailure extends CommandFailure {
    private static final long serialVersionUID = 1;

    ProblemsFailure(int exitCode, String lines) {
        super(exitCode, lines);
    }
}
