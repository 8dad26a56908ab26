package org.diacaustic.scenefile;

/** Faces as a mesh file gives them: lists of corners, each with the line or byte where it stands. */
final class Polygons {
    private final IntList corners = new IntList();
    private final IntList ends = new IntList();
    private final IntList locations = new IntList();

    void addCorner(int index) {
        corners.add(index);
    }

    /** Ends the face whose corners have been added; {@code location} is its line, or its offset in bytes. */
    void endFace(int location) {
        ends.add(corners.size());
        locations.add(location);
    }

    int count() {
        return ends.size();
    }

    /** The number of the first corner of a face. */
    int begin(int face) {
        return face == 0 ? 0 : ends.get(face - 1);
    }

    int end(int face) {
        return ends.get(face);
    }

    int corner(int number) {
        return corners.get(number);
    }

    int location(int face) {
        return locations.get(face);
    }
}
