package org.diacaustic.preprocess;

/** A forward pass that the scene does not allow; the message says why in one line. */
public final class ForwardPlanException extends RuntimeException {
    private static final long serialVersionUID = 1;

    public ForwardPlanException(String message) {
        super(message);
    }
}
