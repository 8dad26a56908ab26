package org.diacaustic.image;

import java.io.IOException;

/**
 * An image file that would take more memory than allowed. Known from the header alone: nothing was decoded or allocated.
 */
public final class ImageTooLargeException extends IOException {
    private static final long serialVersionUID = 1L;

    private final long neededBytes;
    private final long limitBytes;

    ImageTooLargeException(long width, long height, long neededBytes, long limitBytes) {
        super("the image of " + width + " x " + height + " pixels needs " + neededBytes
                + " bytes of memory; the limit is " + limitBytes);
        this.neededBytes = neededBytes;
        this.limitBytes = limitBytes;
    }

    ImageTooLargeException(String place, ImageTooLargeException cause) {
        super(place + ": " + cause.getMessage(), cause);
        this.neededBytes = cause.neededBytes;
        this.limitBytes = cause.limitBytes;
    }

    /** The bytes of memory that the decoded image would take. */
    public long neededBytes() {
        return neededBytes;
    }

    /** The bytes of memory that were allowed. */
    public long limitBytes() {
        return limitBytes;
    }
}
