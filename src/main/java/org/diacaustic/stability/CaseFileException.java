package org.diacaustic.stability;

/** A file is not one of numeric cases; the message is one line. */
public final class CaseFileException extends RuntimeException {
    private static final long serialVersionUID = 1;

    CaseFileException(String message) {
        super(message);
    }
}
