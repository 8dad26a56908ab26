package org.diacaustic.scenefile;

/**
 * One thing wrong with an input.
 *
 * @param keyPath the keys that lead to it, as {@code objects[2].sphere.radius}; empty if there are none
 * @param message what is wrong, the value found and the rule, on one line
 */
public record Problem(Severity severity, Kind kind, Place place, String keyPath, String message) {

    private static final int LONGEST_PATH = 200;
    private static final int LONGEST_MESSAGE = 1000;

    /** Parts that come from a file are made fit to print: one line, no control characters, a bounded length. */
    public Problem {
        keyPath = printable(keyPath, LONGEST_PATH);
        message = printable(message, LONGEST_MESSAGE);
    }

    /** The start of a text, with a mark in place of each control character. */
    static String printable(String text, int longest) {
        StringBuilder shown = new StringBuilder();
        text.codePoints().limit(longest).forEach(c -> shown.appendCodePoint(Character.isISOControl(c) ? '\ufffd' : c));
        return text.codePointCount(0, text.length()) > longest
                ? shown.append('…').toString()
                : shown.toString();
    }

    public enum Severity {
        ERROR,
        WARNING
    }

    /** What sort of thing went wrong, with the exit code that tells it to a shell. */
    public enum Kind {
        BAD_INPUT(2),
        UNREADABLE_FILE(3),
        RESOURCE_LIMIT(4);

        private final int exitCode;

        Kind(int exitCode) {
            this.exitCode = exitCode;
        }

        public int exitCode() {
            return exitCode;
        }
    }

    /** One line: {@code scene.yaml:12:9: objects[2].sphere.radius: expected a number above 0, found 'one'}. */
    @Override
    public String toString() {
        StringBuilder line = new StringBuilder().append(place).append(": ");
        if (severity == Severity.WARNING) {
            line.append("warning: ");
        }
        if (!keyPath.isEmpty()) {
            line.append(keyPath).append(": ");
        }
        return line.append(message).toString();
    }
}
