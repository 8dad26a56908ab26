package org.diacaustic.image;

import java.io.IOException;
import java.io.OutputStream;

/** OpenEXR files [OpenEXR file layout]: one part, scan lines. */
final class ExrCodec implements ImageCodec {

    @Override
    public void write(LinearImage image, Exposure exposure, OutputStream out) throws IOException {
        ExrWriter.write(image, out);
    }

    @Override
    public LinearImage read(ImageSource source) throws IOException {
        return ExrReader.read(source);
    }
}
