package org.diacaustic.render;

/** A render that needs more than there is. */
public final class ResourceLimitException extends RuntimeException {
    private static final long serialVersionUID = 1;

    public ResourceLimitException(String message) {
        super(message);
    }

    static ResourceLimitException ofMemory(String what, long neededBytes, long availableBytes) {
        return new ResourceLimitException(
                what + " needs " + neededBytes + " bytes, but only " + availableBytes + " are available");
    }
}
