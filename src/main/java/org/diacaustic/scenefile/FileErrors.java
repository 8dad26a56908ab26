package org.diacaustic.scenefile;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Optional;

/** Says in words why a file cannot be read. */
final class FileErrors {
    private FileErrors() {}

    /** Why a file cannot be read, with where it was looked for; nothing if it can. */
    static Optional<String> whyUnreadable(Path file) {
        String shown = file.toAbsolutePath().normalize().toString();
        if (!Files.exists(file)) {
            return Optional.of("no such file: " + shown);
        }
        if (Files.isDirectory(file)) {
            return Optional.of("expected a file, found a folder: " + shown);
        }
        return Files.isReadable(file) ? Optional.empty() : Optional.of("permission denied: " + shown);
    }

    static String reason(IOException failure) {
        if (failure instanceof NoSuchFileException) {
            return "no such file";
        }
        if (failure instanceof AccessDeniedException) {
            return "permission denied";
        }
        String message = failure.getMessage();
        return message == null ? failure.getClass().getSimpleName() : message;
    }
}
