package org.diacaustic.render;

/** Settings that cannot be rendered as they stand: an unknown name, or two that exclude each other. */
public final class PlanException extends RuntimeException {
    private static final long serialVersionUID = 1;

    public PlanException(String message) {
        super(message);
    }
}
