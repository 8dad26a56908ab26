package org.diacaustic.stability;

/** A case does not say what its operation needs to know: the message is the reason why the case cannot apply. */
public final class CaseFault extends RuntimeException {
    private static final long serialVersionUID = 1;

    public CaseFault(String reason) {
        super(reason);
    }
}
