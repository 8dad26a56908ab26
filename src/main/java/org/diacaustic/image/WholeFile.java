package org.diacaustic.image;

import java.io.BufferedOutputStream;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;

/** Files that are seen whole or not at all. */
public final class WholeFile {
    private WholeFile() {}

    /** Writes the content of a file. */
    @FunctionalInterface
    public interface Content {
        void writeTo(OutputStream out) throws IOException;
    }

    /**
     * Writes a temporary file beside the target, then puts it in the target's place in one step. On any failure the
     * temporary file is removed and the target stays what it was. If the target is a symbolic link, what it points to
     * is replaced.
     */
    public static void write(Path path, Content content) throws IOException {
        Path target = Files.isSymbolicLink(path) && Files.exists(path) ? path.toRealPath() : path;
        Path temporary = createTemporary(target);
        try {
            writeNew(temporary, content);
            Files.move(temporary, target, StandardCopyOption.ATOMIC_MOVE);
        } catch (Throwable failure) {
            remove(temporary, failure);
            throw failure;
        }
    }

    /** An empty file of its own, in the target's folder: several writers do not meet. */
    private static Path createTemporary(Path target) throws IOException {
        for (int number = 0; ; number++) {
            try {
                return Files.createFile(folderOf(target).resolve("." + target.getFileName() + "." + number + ".tmp"));
            } catch (FileAlreadyExistsException e) {
                // Another writer's, or left by one that was killed: the next number is free.
            }
        }
    }

    /** Not by a file channel: an interrupted render saves what it has, and interruption closes channels. */
    private static void writeNew(Path path, Content content) throws IOException {
        try (FileOutputStream file = new FileOutputStream(path.toFile());
                OutputStream out = new BufferedOutputStream(file, 1 << 16)) {
            content.writeTo(out);
            out.flush();
            // Otherwise a power cut after the move could leave an empty file where the old one was.
            file.getFD().sync();
        }
    }

    /**
     * Checks that {@link #write} can be expected to work, leaving everything as it was.
     *
     * @throws IOException if the folder does not exist or cannot be written to, or the path names a folder, a
     *     device or a file that may not be written
     */
    public static void checkWritable(Path path) throws IOException {
        Path folder = folderOf(path);
        if (Files.notExists(folder)) {
            throw new NoSuchFileException(folder.toString(), null, "the folder does not exist");
        }
        if (!Files.isDirectory(folder)) {
            throw new FileSystemException(folder.toString(), null, "is a file, not a folder");
        }
        if (Files.isDirectory(path)) {
            throw new FileSystemException(path.toString(), null, "is a folder, not a file");
        }
        if (Files.exists(path) && !Files.isRegularFile(path)) {
            throw new FileSystemException(path.toString(), null, "is a device, not a file");
        }
        if (Files.exists(path) && !Files.isWritable(path)) {
            // A move would replace it all the same, which is not what whoever locked it wants.
            throw new FileSystemException(path.toString(), null, "is there already and may not be written");
        }
        try {
            // Permissions do not tell all: some file systems refuse new files to everyone.
            Files.delete(createTemporary(path));
        } catch (IOException refused) {
            throw new FileSystemException(folder.toString(), null, "no file can be made in the folder");
        }
    }

    static Path folderOf(Path path) {
        return path.toAbsolutePath().getParent();
    }

    private static void remove(Path temporary, Throwable failure) {
        try {
            Files.deleteIfExists(temporary);
        } catch (IOException e) {
            failure.addSuppressed(e);
        }
    }
}
