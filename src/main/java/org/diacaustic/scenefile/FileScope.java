package org.diacaustic.scenefile;

import java.io.IOException;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Optional;

/** Which files a scene may name, and the folder that relative names start from. */
public final class FileScope {
    /** For a scene that is no file: it may name none. */
    public static final FileScope NOWHERE = new FileScope(null, false);

    private final Path folder;
    private final boolean confined;

    private FileScope(Path folder, boolean confined) {
        this.folder = folder;
        this.confined = confined;
    }

    /** Only files in the folder of {@code scene} and in folders below it, wherever symbolic links lead. */
    public static FileScope inFolderOf(Path scene) {
        return new FileScope(scene.toAbsolutePath().getParent(), true);
    }

    /** Any file; relative names start from the folder of {@code scene}. */
    public static FileScope anywhere(Path scene) {
        return new FileScope(scene.toAbsolutePath().getParent(), false);
    }

    /** The readable file of this name, or nothing and a problem at the slot. */
    Optional<Path> resolve(String name, Slot slot) {
        if (folder == null) {
            slot.error("this scene has no folder, so it can name no files, found "
                    + slot.node().describe());
            return Optional.empty();
        }
        try {
            Path file = folder.resolve(name).normalize();
            // Asked before whether the file exists: what lies outside is nothing to tell about.
            if (confined && !file.startsWith(folder.normalize())) {
                return outside(file, slot);
            }
            Optional<String> reason = FileErrors.whyUnreadable(file);
            if (reason.isPresent()) {
                slot.unreadable(reason.get());
                return Optional.empty();
            }
            return confined && !file.toRealPath().startsWith(folder.toRealPath())
                    ? outside(file, slot)
                    : Optional.of(file);
        } catch (InvalidPathException notAPath) {
            slot.unexpected("a file name");
        } catch (IOException failure) {
            slot.unreadable("cannot be read: " + FileErrors.reason(failure));
        }
        return Optional.empty();
    }

    private static Optional<Path> outside(Path file, Slot slot) {
        slot.error("the file lies outside the scene's folder, which is not allowed: " + file);
        return Optional.empty();
    }
}
