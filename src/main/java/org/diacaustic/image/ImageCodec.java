package org.diacaustic.image;

import java.io.IOException;
import java.io.OutputStream;

/** Writes and reads one kind of image file. Has no state. */
interface ImageCodec {

    /** Writes the image, row by row, to a buffered stream that the caller flushes and closes. */
    void write(LinearImage image, Exposure exposure, OutputStream out) throws IOException;

    /**
     * Reads an image as linear light.
     *
     * @throws IOException with the fault, if the content is not such an image; {@link java.io.EOFException} if it ends
     *     early
     * @throws ImageTooLargeException if it would take more memory than allowed; nothing was allocated then
     */
    LinearImage read(ImageSource source) throws IOException;
}
