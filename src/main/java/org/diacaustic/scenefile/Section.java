package org.diacaustic.scenefile;

import java.util.HashMap;
import java.util.Map;

/** One mapping of a document, as far as it concerns errors: an error in it makes it and all around it flawed. */
final class Section {
    private final Section around;
    private final Problems problems;
    private final FileScope files;
    private final Map<String, Problem> missing = new HashMap<>();
    private boolean flawed;

    private Section(Section around, Problems problems, FileScope files) {
        this.around = around;
        this.problems = problems;
        this.files = files;
    }

    static Section ofDocument(Problems problems, FileScope files) {
        return new Section(null, problems, files);
    }

    Section inside() {
        return new Section(this, problems, files);
    }

    FileScope files() {
        return files;
    }

    boolean isFlawed() {
        return flawed;
    }

    void error(Place place, String path, String message) {
        markFlawed();
        problems.error(place, path, message);
    }

    void missing(Place place, String path, String message) {
        markFlawed();
        Problem problem = new Problem(Problem.Severity.ERROR, Problem.Kind.BAD_INPUT, place, path, message);
        missing.put(path, problem);
        problems.add(problem);
    }

    /** Says that a key which may have been missed is there under a misspelt name: one mistake, one line. */
    void misspelt(String path) {
        Problem problem = missing.remove(path);
        if (problem != null) {
            problems.retract(problem);
        }
    }

    void unreadable(Place place, String path, String message) {
        markFlawed();
        problems.unreadable(place, path, message);
    }

    void limit(Place place, String path, String message) {
        markFlawed();
        problems.limit(place, path, message);
    }

    void warning(Place place, String path, String message) {
        problems.warning(place, path, message);
    }

    private void markFlawed() {
        for (Section section = this; section != null; section = section.around) {
            section.flawed = true;
        }
    }
}
