package org.diacaustic.image;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;

/** Files in memory, for tests of one codec. */
final class CodecBytes {
    private CodecBytes() {}

    static byte[] write(ImageFormat format, LinearImage image) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        try {
            format.codec().write(image, Exposure.fixed(1), out);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return out.toByteArray();
    }

    static LinearImage read(ImageFormat format, byte[] bytes) throws IOException {
        return format.codec().read(new ImageSource(new ByteArrayInputStream(bytes), 1 << 28));
    }

    /** Each part is text, a byte array, or an Integer that stands for one byte. */
    static byte[] join(Object... parts) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        for (Object part : parts) {
            if (part instanceof String text) {
                out.writeBytes(text.getBytes(StandardCharsets.ISO_8859_1));
            } else if (part instanceof byte[] bytes) {
                out.writeBytes(bytes);
            } else {
                out.write((Integer) part);
            }
        }
        return out.toByteArray();
    }
}
