package org.diacaustic.render;

/** A render that would need more than there is; thrown before anything large is allocated. */
public final class ResourceLimitException extends RuntimeException {
    private static final long serialVersionUID = 1;

    private final long neededBytes;
    private final long availableBytes;

    public ResourceLimitException(String what, long neededBytes, long availableBytes) {
        super(what + " needs " + neededBytes + " bytes, but only " + availableBytes + " are available");
        this.neededBytes = neededBytes;
        this.availableBytes = availableBytes;
    }

    public long neededBytes() {
        return neededBytes;
    }

    public long availableBytes() {
        return availableBytes;
    }
}
