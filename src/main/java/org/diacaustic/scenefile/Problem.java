package org.diacaustic.scenefile;

/**
 * One thing wrong with an input.
 *
 * @param keyPath the keys that lead to it, as {@code objects[2].sphere.radius}; empty if there are none
 * @param message what is wrong, the value found and the rule, on one line
 */
public record Problem(Severity severity, Kind kind, Place place, String keyPath, String message) {

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
