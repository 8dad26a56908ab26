package org.diacaustic.study;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.diacaustic.image.Exposure;
import org.diacaustic.image.ImageFiles;
import org.diacaustic.image.LinearImage;
import org.diacaustic.scene.Camera;

/**
 * What a picture is held against.
 *
 * @param origin how it was made
 * @param picture linear radiance
 * @param standardError how far each channel of each pixel may be off; nothing if that is not known
 * @param halves the mean of one half of its batches minus the mean of the other, each with twice the variance of the whole;
 *     nothing if there are no halves
 * @param rays light rays followed for it, with all that became of them, or eye rays for straight ones; 0 if it was read
 * @param batches independent pictures that it is the mean of; 0 if it was read
 * @param seconds that it took, wall clock
 */
public record Reference(
        Origin origin,
        LinearImage picture,
        Optional<LinearImage> standardError,
        Optional<LinearImage> halves,
        long rays,
        int batches,
        double seconds) {
    private static final String ERROR_ENDING = ".error.pfm";
    private static final String HALVES_ENDING = ".halves.pfm";

    /** How a reference was made. */
    public enum Origin {
        /** Straight rays from surfaces to lamps: nothing bends light, so there is nothing to estimate but pixels cut by shadows. */
        STRAIGHT_RAYS,
        /** Light traced straight into the pixels: see {@link LightTracedPicture}. */
        LIGHT_TRACED,
        /** A file that was given. */
        GIVEN
    }

    /** Reads a picture, and beside NAME.pfm its standard error, NAME.error.pfm, and how its halves differ, NAME.halves.pfm, if they are there. */
    public static Reference read(Path file) throws IOException {
        long start = System.nanoTime();
        LinearImage picture = ImageFiles.read(file);
        Optional<LinearImage> standardError = readIfThere(beside(file, ERROR_ENDING));
        Optional<LinearImage> halves = readIfThere(beside(file, HALVES_ENDING));
        return new Reference(Origin.GIVEN, picture, standardError, halves, 0, 0, (System.nanoTime() - start) * 1e-9);
    }

    private static Optional<LinearImage> readIfThere(Path file) throws IOException {
        return Files.exists(file) ? Optional.of(ImageFiles.read(file)) : Optional.empty();
    }

    /** Writes what {@link #read} reads. */
    void write(Path file) throws IOException {
        ImageFiles.write(picture, Exposure.fixed(1), file);
        writeOrDelete(standardError, beside(file, ERROR_ENDING));
        writeOrDelete(halves, beside(file, HALVES_ENDING));
    }

    /** What lies there may be of another reference. */
    private static void writeOrDelete(Optional<LinearImage> image, Path file) throws IOException {
        if (image.isPresent()) {
            ImageFiles.write(image.get(), Exposure.fixed(1), file);
        } else {
            Files.deleteIfExists(file);
        }
    }

    /** @throws IllegalArgumentException if it is not of the picture's size */
    public void requireSizeOf(Camera camera) {
        if (picture.width() != camera.width() || picture.height() != camera.height()) {
            throw new IllegalArgumentException("the images differ in size: the reference is " + picture
                    + ", the pictures are " + camera.width() + " x " + camera.height());
        }
    }

    private static Path beside(Path file, String ending) {
        return Path.of(file.toString().replaceFirst("\\.[^./\\\\]*$", "") + ending);
    }
}
