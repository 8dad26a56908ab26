package org.diacaustic.study;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.diacaustic.image.Exposure;
import org.diacaustic.image.ImageFiles;
import org.diacaustic.image.LinearImage;

/**
 * What a picture is held against.
 *
 * @param picture linear radiance
 * @param standardError how far each channel of each pixel may be off; nothing if that is not known
 * @param lightRays light rays followed for it, with all that became of them; 0 if it was read
 * @param batches independent pictures that it is the mean of; 0 if it was read
 * @param seconds that it took, wall clock
 */
public record Reference(
        LinearImage picture, Optional<LinearImage> standardError, long lightRays, int batches, double seconds) {
    private static final String ERROR_ENDING = ".error.pfm";

    /** Reads a picture, and its standard error if that lies beside it: NAME.error.pfm beside NAME.pfm. */
    public static Reference read(Path file) throws IOException {
        long start = System.nanoTime();
        LinearImage picture = ImageFiles.read(file);
        Path error = errorFile(file);
        Optional<LinearImage> standardError =
                Files.exists(error) ? Optional.of(ImageFiles.read(error)) : Optional.empty();
        return new Reference(picture, standardError, 0, 0, (System.nanoTime() - start) * 1e-9);
    }

    /** Writes what {@link #read} reads. */
    void write(Path file) throws IOException {
        ImageFiles.write(picture, Exposure.fixed(1), file);
        if (standardError.isPresent()) {
            ImageFiles.write(standardError.get(), Exposure.fixed(1), errorFile(file));
        }
    }

    private static Path errorFile(Path file) {
        return Path.of(file.toString().replaceFirst("\\.[^./\\\\]*$", "") + ERROR_ENDING);
    }
}
