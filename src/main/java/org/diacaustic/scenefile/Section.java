package org.diacaustic.scenefile;

/** One mapping of a document, as far as it concerns errors: an error in it makes it and all around it flawed. */
final class Section {
    private final Section around;
    private final Problems problems;
    private final FileScope files;
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
