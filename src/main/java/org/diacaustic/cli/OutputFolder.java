package org.diacaustic.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.diacaustic.image.WholeFile;

/** Folders for what a command writes. */
final class OutputFolder {
    private OutputFolder() {}

    /**
     * Makes the folder, if it is not there, and sees that a file can be written into it.
     *
     * @param file the name of one that will be
     */
    static void make(Path folder, String file) throws IOException {
        refuseFile(folder);
        Files.createDirectories(folder);
        WholeFile.checkWritable(folder.resolve(file));
    }

    /** Refuses what is there, but no folder. */
    static void refuseFile(Path folder) {
        if (Files.exists(folder) && !Files.isDirectory(folder)) {
            throw new CommandFailure(ExitCode.FILE, folder + ": is a file, not a folder");
        }
    }
}
