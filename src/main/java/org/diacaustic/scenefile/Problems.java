package org.diacaustic.scenefile;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Collectors;
import org.diacaustic.scenefile.Problem.Kind;
import org.diacaustic.scenefile.Problem.Severity;

/**
 * Collects everything that is wrong with a scene and its files, so that all of it is told at once. At most {@value
 * #KEPT} are kept; those beyond are counted.
 */
public final class Problems {
    private static final int KEPT = 1000;

    private final List<Problem> kept = new ArrayList<>();
    private int errors;
    private int dropped;

    public void error(Place place, String keyPath, String message) {
        add(new Problem(Severity.ERROR, Kind.BAD_INPUT, place, keyPath, message));
    }

    public void warning(Place place, String keyPath, String message) {
        add(new Problem(Severity.WARNING, Kind.BAD_INPUT, place, keyPath, message));
    }

    /** A file that is not there, or that the system does not let us read. */
    public void unreadable(Place place, String keyPath, String message) {
        add(new Problem(Severity.ERROR, Kind.UNREADABLE_FILE, place, keyPath, message));
    }

    /** An input that is larger than we take on; the message names the limit. */
    public void limit(Place place, String keyPath, String message) {
        add(new Problem(Severity.ERROR, Kind.RESOURCE_LIMIT, place, keyPath, message));
    }

    public void add(Problem problem) {
        if (problem.severity() == Severity.ERROR) {
            errors++;
        }
        if (kept.size() < KEPT) {
            kept.add(problem);
        } else {
            dropped++;
        }
    }

    /** Takes back an error that another one, found later, tells better. */
    void retract(Problem error) {
        if (kept.remove(error)) {
            errors--;
        }
    }

    public boolean hasErrors() {
        return errors > 0;
    }

    public int errorCount() {
        return errors;
    }

    /** How many more there were than {@link #sorted} gives. */
    public int droppedCount() {
        return dropped;
    }

    /** The problems by source, line and column; those of one place in the order in which they were found. */
    public List<Problem> sorted() {
        return kept.stream().sorted(Comparator.comparing(Problem::place)).toList();
    }

    /** 0 without errors; else the smallest code among them, so that bad input is told before anything it led to. */
    public int exitCode() {
        return kept.stream()
                .filter(problem -> problem.severity() == Severity.ERROR)
                .mapToInt(problem -> problem.kind().exitCode())
                .min()
                .orElse(0);
    }

    /** One problem a line. */
    @Override
    public String toString() {
        String lines = sorted().stream().map(Problem::toString).collect(Collectors.joining("\n"));
        return dropped == 0 ? lines : lines + "\nand " + dropped + " more problems";
    }
}
