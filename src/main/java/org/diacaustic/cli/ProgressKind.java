package org.diacaustic.cli;

import java.io.PrintStream;
import java.util.Locale;
import org.diacaustic.render.ProgressListener;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/** How progress is shown on standard error. */
enum ProgressKind {
    /** A line that is written over, if someone is watching; otherwise nothing. */
    AUTO {
        @Override
        ProgressListener listener(PrintStream out) {
            return System.console() == null
                    ? NONE.listener(out)
                    : new ProgressLine(out, "\r%3.0f %%  %.1f s left ", "\r");
        }
    },
    /** A line whenever another tenth is done. */
    PLAIN {
        @Override
        ProgressListener listener(PrintStream out) {
            return new ProgressLine(out, "%.0f %%, %.1f s left%n", "");
        }
    },
    /** The same as JSON objects, one a line. */
    JSON {
        @Override
        ProgressListener listener(PrintStream out) {
            return new ProgressLine(out, "{\"percent\": %.0f, \"secondsLeft\": %.1f}%n", "");
        }
    },
    NONE {
        @Override
        ProgressListener listener(PrintStream out) {
            return (done, total) -> {};
        }
    };

    /** As it is written on the command line. */
    @Override
    public String toString() {
        return name().toLowerCase(Locale.ROOT);
    }

    abstract ProgressListener listener(PrintStream out);

    /** Reads a kind as it is written on the command line. */
    static final class Converter implements ITypeConverter<ProgressKind> {
        @Override
        public ProgressKind convert(String text) {
            for (ProgressKind kind : values()) {
                if (kind.toString().equals(text)) {
                    return kind;
                }
            }
            throw new TypeConversionException("expected one of auto, plain, json, none, found '" + text + "'");
        }
    }

    /** Prints the part done and the time left, at most once a step. */
    private static final class ProgressLine implements ProgressListener {
        private final PrintStream out;
        private final String format;
        private final String end;
        private long start = System.nanoTime();
        private int lastDone;
        private int lastStep;

        ProgressLine(PrintStream out, String format, String end) {
            this.out = out;
            this.format = format;
            this.end = end;
        }

        @Override
        public void progressed(int done, int total) {
            if (done < lastDone) {
                // Another round: what the last one took says nothing of it.
                start = System.nanoTime();
            }
            lastDone = done;
            int steps = end.isEmpty() ? 10 : 100;
            int step = (int) ((long) done * steps / total);
            if (step == lastStep) {
                return;
            }
            lastStep = step;
            double seconds = (System.nanoTime() - start) * 1e-9;
            double left = seconds * (total - done) / done;
            out.printf(Locale.ROOT, format, 100.0 * done / total, left);
            if (done == total && !end.isEmpty()) {
                out.print(end + " ".repeat(40) + end);
            }
            out.flush();
        }
    }
}
