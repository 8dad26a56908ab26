package org.diacaustic.image;

import java.io.BufferedInputStream;
import java.io.ByteArrayOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;

/** Writes and reads image files. */
public final class ImageFiles {
    /** The memory that {@link #read(Path)} allows an image to take: 1 GiB. */
    public static final long DEFAULT_LIMIT_BYTES = 1L << 30;

    private ImageFiles() {}

    /**
     * Writes the image in the format that the file's ending names. The file appears, or is replaced, only when it is
     * whole; if anything fails, what was there before is untouched.
     *
     * @param exposure for formats of 8 bits; those of linear radiance make no use of it
     * @throws IllegalArgumentException if the ending is unknown or the format cannot hold so large an image
     * @throws IOException if the file cannot be written
     */
    public static void write(LinearImage image, Exposure exposure, Path path) throws IOException {
        ImageFormat format = ImageFormat.of(path);
        format.checkSize(image.width(), image.height());
        WholeFile.write(path, out -> format.codec().write(image, exposure, out));
    }

    /**
     * What {@link #write} would put into a file.
     *
     * @throws IllegalArgumentException if the format cannot hold so large an image
     */
    public static byte[] bytes(LinearImage image, Exposure exposure, ImageFormat format) {
        format.checkSize(image.width(), image.height());
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        try {
            format.codec().write(image, exposure, out);
        } catch (IOException e) {
            throw new IllegalStateException("memory cannot be written to", e);
        }
        return out.toByteArray();
    }

    /**
     * Checks before a render that {@link #write} can be expected to work, leaving everything as it was.
     *
     * @throws IllegalArgumentException if the ending is unknown
     * @throws IOException if the folder does not exist or cannot be written to, or the path names a folder or a device
     */
    public static void checkWritable(Path path) throws IOException {
        ImageFormat.of(path);
        WholeFile.checkWritable(path);
    }

    /** Whether the file is a PNG that {@link #write} made: others are somebody's work, not to be written over unasked. */
    public static boolean isOurs(Path path) throws IOException {
        try (InputStream in = Files.newInputStream(path)) {
            return PngCodec.isSigned(in.readNBytes(PngCodec.SIGNED_HEAD_BYTES));
        }
    }

    /** As {@link #read(Path, long)}, with {@link #DEFAULT_LIMIT_BYTES}. */
    public static LinearImage read(Path path) throws IOException {
        return read(path, DEFAULT_LIMIT_BYTES);
    }

    /**
     * Reads an image as linear light. The endings tga, hdr, pfm and exr say what a file is; of any other, its content
     * does (PNG, JPEG, BMP, GIF and what else the JVM's image readers know). Formats of 8 or 16 bits are taken as sRGB.
     *
     * @param limitBytes the memory that decoding may take; the size is checked from the header alone
     * @throws ImageTooLargeException if it would take more, or more than can be held at all
     * @throws IOException if the file cannot be read or is broken; the message names the file and the fault
     */
    public static LinearImage read(Path path, long limitBytes) throws IOException {
        try (InputStream in = new BufferedInputStream(Files.newInputStream(path), 1 << 16)) {
            return codecFor(path).read(new ImageSource(in, limitBytes));
        } catch (ImageTooLargeException e) {
            throw new ImageTooLargeException(path.toString(), e);
        } catch (EOFException e) {
            throw new IOException(path + ": the file ends before the image does", e);
        } catch (FileSystemException e) {
            throw e;
        } catch (IOException e) {
            throw new IOException(path + ": " + e.getMessage(), e);
        }
    }

    private static ImageCodec codecFor(Path path) {
        String ending = ImageFormat.ending(path);
        for (ImageFormat format : ImageFormat.values()) {
            if (format.ending().equals(ending)) {
                return format.codec();
            }
        }
        return ImageFormat.PNG.codec();
    }
}
