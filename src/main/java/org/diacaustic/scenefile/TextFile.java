package org.diacaustic.scenefile;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.CharBuffer;
import java.nio.charset.CharsetDecoder;
import java.nio.charset.CoderResult;
import java.nio.charset.CodingErrorAction;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;

/** Reads a text file of bounded size as UTF-8, with or without a byte order mark. */
final class TextFile {
    /** Of a scene file, in bytes. Geometry of any size belongs in mesh files. */
    static final int MAX_BYTES = 16 << 20;

    private TextFile() {}

    static Optional<String> read(Path file, Problems problems) {
        Place place = Place.of(file.toString());
        Optional<String> reason = FileErrors.whyUnreadable(file);
        if (reason.isPresent()) {
            problems.unreadable(place, "", reason.get());
            return Optional.empty();
        }
        byte[] bytes;
        try (InputStream in = Files.newInputStream(file)) {
            // One byte more than the limit tells a file that is too large, even one that states no size.
            bytes = in.readNBytes(MAX_BYTES + 1);
        } catch (IOException failure) {
            problems.unreadable(place, "", "cannot be read: " + FileErrors.reason(failure));
            return Optional.empty();
        }
        if (bytes.length > MAX_BYTES) {
            problems.limit(place, "", "is larger than the limit of " + (MAX_BYTES >> 20) + " MiB for a scene file");
            return Optional.empty();
        }
        return decode(bytes, place.source(), problems);
    }

    static Optional<String> decode(byte[] bytes, String source, Problems problems) {
        int start = startsWith(bytes, 0xEF, 0xBB, 0xBF) ? 3 : 0;
        if (startsWith(bytes, 0xFE, 0xFF) || startsWith(bytes, 0xFF, 0xFE)) {
            problems.error(new Place(source, 1, 1), "", "is UTF-16; save it as UTF-8");
            return Optional.empty();
        }
        CharsetDecoder decoder = StandardCharsets.UTF_8
                .newDecoder()
                .onMalformedInput(CodingErrorAction.REPORT)
                .onUnmappableCharacter(CodingErrorAction.REPORT);
        ByteBuffer in = ByteBuffer.wrap(bytes, start, bytes.length - start);
        CharBuffer out = CharBuffer.allocate(bytes.length - start);
        CoderResult result = decoder.decode(in, out, true);
        out.flip();
        if (result.isError()) {
            String before = out.toString();
            int line = 1 + (int) before.chars().filter(c -> c == '\n').count();
            int column = before.length() - before.lastIndexOf('\n');
            problems.error(
                    new Place(source, line, column),
                    "",
                    "is not UTF-8 text: byte " + String.format("0x%02X", in.get(in.position())) + " at offset "
                            + in.position());
            return Optional.empty();
        }
        return Optional.of(out.toString());
    }

    private static boolean startsWith(byte[] bytes, int... mark) {
        if (bytes.length < mark.length) {
            return false;
        }
        for (int i = 0; i < mark.length; i++) {
            if ((bytes[i] & 0xFF) != mark[i]) {
                return false;
            }
        }
        return true;
    }
}
