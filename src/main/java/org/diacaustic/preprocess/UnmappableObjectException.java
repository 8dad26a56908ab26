package org.diacaustic.preprocess;

/** An object has no end and so no map of its own [Thesis 4.4]; the message names it and says what to use instead. */
public final class UnmappableObjectException extends RuntimeException {
    private static final long serialVersionUID = 1;

    UnmappableObjectException(String message) {
        super(message);
    }
}
