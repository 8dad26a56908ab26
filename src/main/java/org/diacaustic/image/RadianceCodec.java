package org.diacaustic.image;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Radiance pictures [Ward 1991]: RGBE pixels, in the run lengths per channel for widths of 8 to 32767, else flat. Files
 * with the older run lengths and with a stated exposure, which is undone, are read too; rows must run from the top left.
 */
final class RadianceCodec implements ImageCodec {
    private static final int SMALLEST_RUN_WIDTH = 8;
    private static final int LARGEST_RUN_WIDTH = 32767;
    private static final int SHORTEST_RUN = 4;
    private static final int LONGEST_RUN = 127;
    private static final int LONGEST_LITERAL = 128;
    private static final Pattern SIZE = Pattern.compile("-Y\\s+(\\d{1,10})\\s+\\+X\\s+(\\d{1,10})\\s*");

    @Override
    public void write(LinearImage image, Exposure exposure, OutputStream out) throws IOException {
        int width = image.width();
        String header = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + image.height() + " +X " + width + "\n";
        out.write(header.getBytes(StandardCharsets.US_ASCII));
        boolean runs = width >= SMALLEST_RUN_WIDTH && width <= LARGEST_RUN_WIDTH;
        byte[] flat = new byte[4 * width];
        byte[] plane = new byte[width];
        float[] samples = image.samples();
        for (int y = 0; y < image.height(); y++) {
            int offset = image.offset(0, y);
            for (int x = 0; x < width; x++, offset += 3) {
                Rgbe.encode(samples[offset], samples[offset + 1], samples[offset + 2], flat, 4 * x);
            }
            if (runs) {
                writeRuns(flat, plane, out);
            } else {
                out.write(flat);
            }
        }
    }

    private static void writeRuns(byte[] flat, byte[] plane, OutputStream out) throws IOException {
        out.write(2);
        out.write(2);
        out.write(plane.length >> 8);
        out.write(plane.length & 0xff);
        for (int channel = 0; channel < 4; channel++) {
            for (int x = 0; x < plane.length; x++) {
                plane[x] = flat[4 * x + channel];
            }
            writePlane(plane, out);
        }
    }

    private static void writePlane(byte[] plane, OutputStream out) throws IOException {
        int literal = 0;
        int x = 0;
        while (x < plane.length) {
            int run = runLength(plane, x);
            if (run >= SHORTEST_RUN) {
                writeLiterals(plane, literal, x, out);
                out.write(128 + run);
                out.write(plane[x]);
                literal = x + run;
            }
            x += run;
        }
        writeLiterals(plane, literal, x, out);
    }

    private static int runLength(byte[] plane, int start) {
        int end = Math.min(plane.length, start + LONGEST_RUN);
        int x = start + 1;
        while (x < end && plane[x] == plane[start]) {
            x++;
        }
        return x - start;
    }

    private static void writeLiterals(byte[] plane, int from, int to, OutputStream out) throws IOException {
        for (int start = from; start < to; start += LONGEST_LITERAL) {
            int count = Math.min(LONGEST_LITERAL, to - start);
            out.write(count);
            out.write(plane, start, count);
        }
    }

    @Override
    public LinearImage read(ImageSource source) throws IOException {
        double exposure = readHeader(source);
        String sizeLine = source.nextText('\n');
        Matcher size = SIZE.matcher(sizeLine);
        if (!size.matches()) {
            throw new IOException("the size is given as \"" + sizeLine + "\"; only -Y height +X width is read");
        }
        long width = Long.parseLong(size.group(2));
        LinearImage image = source.newImage(width, Long.parseLong(size.group(1)), 0);
        byte[] flat = new byte[4 * image.width()];
        for (int y = 0; y < image.height(); y++) {
            readRow(source, flat);
            int offset = image.offset(0, y);
            for (int x = 0; x < image.width(); x++, offset += 3) {
                Rgbe.decode(flat, 4 * x, exposure, image.samples(), offset);
            }
        }
        return image;
    }

    /** Reads up to the empty line, and returns the product of the exposures that were applied to the pixels. */
    private static double readHeader(ImageSource source) throws IOException {
        if (source.nextByte() != '#' || source.nextByte() != '?') {
            throw new IOException("not a Radiance picture: it does not begin with #?");
        }
        double exposure = 1;
        for (String line = source.nextText('\n'); !line.isBlank(); line = source.nextText('\n')) {
            if (line.startsWith("FORMAT=") && !line.substring(7).trim().equals("32-bit_rle_rgbe")) {
                throw new IOException("the pixels are in " + line.substring(7) + "; only 32-bit_rle_rgbe is read");
            }
            if (line.startsWith("EXPOSURE=")) {
                exposure *= exposure(line.substring(9).trim());
            }
        }
        return exposure;
    }

    private static double exposure(String text) throws IOException {
        try {
            double value = Double.parseDouble(text);
            if (value > 0 && value < Double.POSITIVE_INFINITY) {
                return value;
            }
        } catch (NumberFormatException e) {
            throw new IOException("the exposure in the header is \"" + text + "\", not a number", e);
        }
        throw new IOException("the exposure in the header is " + text + ", not a positive number");
    }

    private static void readRow(ImageSource source, byte[] flat) throws IOException {
        int width = flat.length / 4;
        source.next(flat, 4);
        boolean runs = flat[0] == 2 && flat[1] == 2 && flat[2] >= 0;
        if (!runs || width < SMALLEST_RUN_WIDTH || width > LARGEST_RUN_WIDTH) {
            readFlat(source, flat);
            return;
        }
        int stated = flat[2] << 8 | flat[3] & 0xff;
        if (stated != width) {
            throw new IOException("a row says that it is " + stated + " pixels wide, the header says " + width);
        }
        for (int channel = 0; channel < 4; channel++) {
            readPlane(source, flat, channel);
        }
    }

    private static void readPlane(ImageSource source, byte[] flat, int channel) throws IOException {
        int at = channel;
        while (at < flat.length) {
            int code = source.nextByte();
            int count = code > 128 ? code - 128 : code;
            if (count == 0 || count > (flat.length - at + 3) / 4) {
                throw new IOException("a run of " + count + " pixels does not fit into its row");
            }
            int value = code > 128 ? source.nextByte() : 0;
            for (int i = 0; i < count; i++, at += 4) {
                flat[at] = (byte) (code > 128 ? value : source.nextByte());
            }
        }
    }

    /** Reads the row whose first pixel is there already: plain pixels, where (1, 1, 1, n) repeats the last n times. */
    private static void readFlat(ImageSource source, byte[] flat) throws IOException {
        byte[] pixel = {flat[0], flat[1], flat[2], flat[3]};
        int shift = 0;
        int at = 0;
        while (true) {
            if (pixel[0] == 1 && pixel[1] == 1 && pixel[2] == 1) {
                long count = (long) (pixel[3] & 0xff) << shift;
                if (at == 0 || shift > 24 || count > (flat.length - at) / 4) {
                    throw new IOException("a run of " + count + " pixels does not fit into its row");
                }
                for (int end = at + 4 * (int) count; at < end; at++) {
                    flat[at] = flat[at - 4];
                }
                shift += 8;
            } else {
                System.arraycopy(pixel, 0, flat, at, 4);
                at += 4;
                shift = 0;
            }
            if (at == flat.length) {
                return;
            }
            source.next(pixel);
        }
    }
}
