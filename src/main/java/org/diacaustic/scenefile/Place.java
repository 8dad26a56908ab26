package org.diacaustic.scenefile;

/**
 * Where something stands: a file or an option, and the line and column in it.
 *
 * @param source the file's name as the user gave it, or an option such as {@code -D seed}
 * @param line counted from 1; 0 if the whole source is meant
 * @param column counted from 1 in characters; 0 if the whole line is meant
 */
public record Place(String source, int line, int column) implements Comparable<Place> {

    public static Place of(String source) {
        return new Place(source, 0, 0);
    }

    @Override
    public int compareTo(Place other) {
        int order = source.compareTo(other.source);
        order = order != 0 ? order : Integer.compare(line, other.line);
        return order != 0 ? order : Integer.compare(column, other.column);
    }

    /** As compilers write it: {@code scene.yaml:12:9}. */
    @Override
    public String toString() {
        return source + (line > 0 ? ":" + line : "") + (line > 0 && column > 0 ? ":" + column : "");
    }
}
