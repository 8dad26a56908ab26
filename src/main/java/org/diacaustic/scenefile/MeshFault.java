package org.diacaustic.scenefile;

/** Ends the reading of a mesh file at the first thing in it that cannot be right. */
final class MeshFault extends RuntimeException {
    private static final long serialVersionUID = 1;

    /** Counted from 1; 0 if the fault has no line. */
    private final int line;

    private MeshFault(int line, String message) {
        super(message, null, false, false);
        this.line = line;
    }

    static MeshFault atLine(int line, String message) {
        return new MeshFault(line, message);
    }

    static MeshFault atByte(long offset, String message) {
        return new MeshFault(0, "byte " + offset + ": " + message);
    }

    int line() {
        return line;
    }
}
